#include "plan/frame_plan.h"

#include "optics/waves.h"
#include "plan/reduce.h"
#include "plan/stereo.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace tarn {

const char* passName(PassId pass)
{
    constexpr std::array names{"sunlight", "caustics", "heights", "refraction", "reflection",
                               "scene",    "water",    "glow",    "present"};
    static_assert(names.size() == passCount, "each pass has a name, in the order of PassId");
    return names[static_cast<std::size_t>(pass)];
}

float totalAmplitude(const WaterBody& water)
{
    float sum = 0.0f;
    for (const Wave& wave : water.waves) sum += std::abs(wave.amplitude);
    return sum;
}

Bounds waterBounds(const WaterBody& water)
{
    const float amplitude = totalAmplitude(water);
    const vec2 half = 0.5f * water.extent;
    Bounds bounds;
    bounds.add(vec3(water.centre.x - half.x, water.level - amplitude, water.centre.y - half.y));
    bounds.add(vec3(water.centre.x + half.x, water.level + amplitude, water.centre.y + half.y));
    return bounds;
}

float surfaceHeight(const WaterBody& water, vec2 xz, double time)
{
    double height = water.level;
    for (const Wave& wave : water.waves) {
        const auto term =
            optics64::makeWaveTerm(wave.amplitude, wave.wavelength, wave.direction, wave.phase, wave.period);
        height += optics64::waveHeight({&term, 1}, glm::dvec2(xz), time);
    }
    return static_cast<float>(height);
}

optics64::WaterGrid waterGrid(const WaterBody& water, const WaterOptions& options, const Camera& camera, float aspect)
{
    const glm::dvec4 rect(water.centre.x, water.centre.y, 0.5f * water.extent.x, 0.5f * water.extent.y);
    if (options.grid == WaterOptions::Grid::uniform) return optics64::uniformGrid(rect, options.gridSize);
    return optics64::focusedGrid(rect, static_cast<double>(water.level), static_cast<double>(totalAmplitude(water)),
                                 options.gridSize, glm::dvec3(camera.eye),
                                 glm::dmat4(clipFromView(camera, aspect)) * glm::dmat4(viewFromWorld(camera)));
}

float drawnHeight(const WaterBody& water, const optics64::WaterGrid& grid, vec2 xz, double time)
{
    std::vector<optics64::WaveTerm> terms;
    for (const Wave& wave : water.waves)
        terms.push_back(
            optics64::makeWaveTerm(wave.amplitude, wave.wavelength, wave.direction, wave.phase, wave.period));
    return static_cast<float>(water.level + optics64::gridHeight(terms.data(), static_cast<int>(terms.size()),
                                                                 glm::dvec2(xz), time, grid[0], grid[1]));
}

WaterSide waterSide(const WaterBody& water, const optics64::WaterGrid& grid, const Camera& camera, float aspect,
                    double time)
{
    const mat4 worldFromView = glm::inverse(viewFromWorld(camera));
    const float up = camera.nearPlane * std::tan(0.5f * camera.verticalFov);
    const float middle = camera.nearPlane * camera.lensShift;
    const vec3 centre(worldFromView * vec4(middle, 0.0f, -camera.nearPlane, 1.0f));
    Bounds plane;
    for (const vec2 corner : {vec2(-1, -1), vec2(1, -1), vec2(-1, 1), vec2(1, 1)})
        plane.add(vec3(worldFromView * vec4(corner.x * aspect * up + middle, corner.y * up, -camera.nearPlane, 1.0f)));

    const vec2 half = 0.5f * water.extent;
    const vec2 lower = water.centre - half;
    const vec2 upper = water.centre + half;
    if (plane.upper.x < lower.x || plane.lower.x > upper.x || plane.upper.z < lower.y || plane.lower.z > upper.y)
        return WaterSide::above;
    const bool inside =
        plane.lower.x >= lower.x && plane.upper.x <= upper.x && plane.lower.z >= lower.y && plane.upper.z <= upper.y;

    // From the height under the middle no point of the plane is further than its half diagonal. A facet is as steep as
    // the waves along either of its legs, and so at most √2 times as steep in between. Waves that fade from vertex to
    // vertex (gridFade) add to that.
    float slope = 0.0f;
    for (const Wave& wave : water.waves)
        slope += std::abs(wave.amplitude) * 2.0f * std::numbers::pi_v<float> / wave.wavelength;
    constexpr float rounding = 1.0e-3f; // m: float positions far from the origin
    const float reach = up * std::sqrt(1.0f + aspect * aspect);
    const float change =
        std::numbers::sqrt2_v<float> * slope * reach * static_cast<float>(optics64::fadeSteepening(grid));
    const float amplitude = totalAmplitude(water);
    const float height = drawnHeight(water, grid, vec2(centre.x, centre.z), time);
    if (plane.lower.y > std::min(height + change, water.level + amplitude) + rounding) return WaterSide::above;
    if (inside && plane.upper.y < std::max(height - change, water.level - amplitude) - rounding)
        return WaterSide::below;
    return WaterSide::crossing;
}

namespace {

bool overWaterRect(const WaterBody& water, const vec3& pointW)
{
    return std::abs(pointW.x - water.centre.x) <= 0.5f * water.extent.x &&
           std::abs(pointW.z - water.centre.y) <= 0.5f * water.extent.y;
}

PassPlan wanted(std::string reason, ivec2 size) { return {true, std::move(reason), size}; }

PassPlan unwanted(std::string reason) { return {false, std::move(reason), ivec2(0)}; }

/// Why no water is drawn, or nothing when it is.
std::string whyNoWater(const WaterBody& water, const Options& options)
{
    if (!water.present) return "the scene has no water";
    if (!options.water.enabled) return "water.enabled is off";
    return "";
}

/// Why the sun's highlight on the water is not spread, or nothing when it is.
std::string whyNoGlow(const Scene& scene, const FramePlan& plan, const Options& options)
{
    if (!options.glow.enabled) return "glow.enabled is off";
    if (options.glow.strength == 0.0f) return "glow.strength is 0";
    if (!options.water.reflects) return "water.reflects is off: no sun is mirrored";
    if (!scene.sun) return "the scene has no sun";
    if (scene.sun->direction.y <= 0.0f) return "the sun is below the horizon";
    if (plan.side == WaterSide::below) return "the eye is under water";
    return "";
}

/// A sun so low has shadows without end, and next to no light on level ground.
constexpr float lowestSun = 0.01f;

std::string whyNoSun(const Scene& scene)
{
    if (!scene.sun) return "the scene has no sun";
    if (scene.sun->direction.y <= lowestSun) return "the sun is below the horizon, or on it";
    return "";
}

/// Why no light is gathered on the bed, or nothing when it is. `noWater`: why no surface is drawn.
std::string whyNoCaustics(const Scene& scene, const FramePlan& plan, const std::string& noWater, const Options& options)
{
    if (!options.caustics.enabled) return "caustics.enabled is off";
    if (const std::string noSun = whyNoSun(scene); !noSun.empty()) return noSun;
    if (plan.side != WaterSide::above) return ""; // the bed is seen directly
    if (!noWater.empty()) return noWater;
    if (!options.refraction.enabled) return "refraction.enabled is off: the bed is not seen";
    return "";
}

void planSunlight(FramePlan& plan, const Scene& scene, const std::string& noWater, const Options& options)
{
    const std::string noCaustics = whyNoCaustics(scene, plan, noWater, options);
    plan[PassId::caustics] =
        noCaustics.empty() ? wanted("the waves gather the sun's light on the bed", ivec2(options.caustics.textureSize))
                           : unwanted(noCaustics);
    std::string noSunlight = whyNoSun(scene);
    if (noSunlight.empty() && !options.sunlight.shadows && !noCaustics.empty())
        noSunlight = "sunlight.shadows is off, and no caustics need the bed's depth";
    plan[PassId::sunlight] = noSunlight.empty()
                                 ? wanted(options.sunlight.shadows ? "the sun casts shadows; drawn when scene, sun or "
                                                                     "water changed"
                                                                   : "photons need the bed's depth along the sun",
                                          ivec2(options.sunlight.mapSize))
                                 : unwanted(noSunlight);
}

const char* presentReason(StereoOptions::Output output)
{
    switch (output) {
    case StereoOptions::Output::off: break;
    case StereoOptions::Output::sideBySide:
    case StereoOptions::Output::pair:
        return "tone mapping to the display; all passes for each eye, but sunlight and caustics once";
    case StereoOptions::Output::anaglyph:
        return "tone mapping to the display, and both eyes in one; all passes for each eye, but sunlight and caustics "
               "once";
    }
    return "tone mapping to the display";
}

/// What becomes of the frame after the tone curve, or before it, until it is a picture of its size; "" when nothing.
std::string finishing(ivec2 size, const FrameOptions& options)
{
    std::string text;
    if (options.antialiasing == FrameOptions::Antialiasing::fxaa) text += "; edges smoothed by FXAA";
    const ivec2 drawn = scaledSize(size, options);
    if (drawn.x < size.x || drawn.y < size.y)
        text += fmt::format("; upscaled from {}x{}, {}", drawn.x, drawn.y,
                            options.upscaler == FrameOptions::Upscaler::edge ? "following edges" : "bilinear");
    else if (drawn != size)
        text += fmt::format("; the mean of {}x{}", drawn.x, drawn.y);
    return text;
}

/// The maps of heights that are marched through: drawn, or given.
void planHeights(FramePlan& plan, const Options& options, const SceneMaps& maps)
{
    if (!plan.raycastsBed && !plan.raycastsMirror) {
        plan[PassId::heights] = unwanted("no ray is marched: neither method takes a map, or the eye is under water");
        return;
    }
    const HeightMapPicture* const bed = plan.raycastsBed && maps.bed.picture ? &*maps.bed.picture : nullptr;
    const HeightMapPicture* const aboveWater =
        plan.raycastsMirror && maps.aboveWater.picture ? &*maps.aboveWater.picture : nullptr;
    plan.drawsBedMap = plan.raycastsBed && !bed;
    plan.drawsAboveWaterMap = plan.raycastsMirror && !aboveWater;
    const bool draws = plan.drawsBedMap || plan.drawsAboveWaterMap;
    std::string reason = plan.raycastsBed && plan.raycastsMirror
                             ? "rays are marched through the bed and what stands over the water"
                         : plan.raycastsBed ? "refracted rays are marched through the bed"
                                            : "mirrored rays are marched through what stands over the water";
    int resolution = draws ? options.heights.mapSize : 0;
    for (const HeightMapPicture* given : {bed, aboveWater})
        if (given) {
            reason += fmt::format("; {} gives the map '{}'", given->file.filename().string(), mapName(given->kind));
            resolution = std::max(resolution, given->resolution);
        }
    if (draws) reason += "; drawn when scene, sun or water changed";
    plan[PassId::heights] = wanted(std::move(reason), ivec2(resolution));
}

/// Which maps of heights are marched through, and with them the target of either kind: seen from above a map takes its
/// place.
void planWaterLookups(FramePlan& plan, const Options& options, const SceneMaps& maps, const LookupChoice& bed,
                      const LookupChoice& mirror)
{
    const bool fromAbove = plan.side != WaterSide::below, fromBelow = plan.side != WaterSide::above;
    const RefractionOptions& refraction = options.refraction;
    const ReflectionOptions& reflection = options.reflection;
    plan.raycastsBed = fromAbove && refraction.enabled && bed.map;
    plan.targetsBed = !plan.raycastsBed || bed.target;
    plan.raycastsMirror = fromAbove && options.water.reflects && reflection.enabled && mirror.map;
    plan.targetsMirror = !plan.raycastsMirror || mirror.target;

    const auto chosen = [&](const char* above, const char* crossing, const char* below) {
        return fromAbove && fromBelow ? crossing : fromAbove ? above : below;
    };
    const ivec2 refractionSize(refraction.targetSize), reflectionSize(reflection.targetSize);
    if (!refraction.enabled)
        plan[PassId::refraction] = unwanted("refraction.enabled is off: the water shows its own colour");
    else if (!plan.targetsBed)
        plan[PassId::refraction] = fromBelow ? wanted("from below, what stands over the water", refractionSize)
                                             : unwanted("the bed is found in its map of heights");
    else
        plan[PassId::refraction] =
            wanted(chosen("the bed under the surface", "both the bed and, from below, what stands over the water",
                          "what stands over the water, seen from below"),
                   refractionSize);
    if (!options.water.reflects)
        plan[PassId::reflection] = unwanted("water.reflects is off: the surface shows only what is refracted");
    else if (!reflection.enabled)
        plan[PassId::reflection] = unwanted("reflection.enabled is off: the water mirrors the sky alone");
    else if (!plan.targetsMirror)
        plan[PassId::reflection] = fromBelow ? wanted("from below, the bed mirrored in the surface", reflectionSize)
                                             : unwanted("what is mirrored is found in its map of heights");
    else
        plan[PassId::reflection] =
            wanted(chosen("what the surface mirrors", "what the surface mirrors, from above and from below",
                          "the bed mirrored in the surface from below"),
                   reflectionSize);
    planHeights(plan, options, maps);
    const auto explain = [&](PassId pass, const LookupChoice& choice) {
        if (fromAbove && !choice.why.empty()) plan[pass].reason += " (" + choice.why + ")";
    };
    if (refraction.enabled) explain(PassId::refraction, bed);
    if (reflection.enabled && options.water.reflects) explain(PassId::reflection, mirror);
}

ivec2 glowSize(ivec2 size, const Options& options) { return glm::max(size / options.glow.divisor, ivec2(1)); }

} // namespace

ivec2 scaledSize(ivec2 picture, const FrameOptions& options)
{
    return glm::max(ivec2(glm::round(vec2(picture) * options.scale)), ivec2(1));
}

FramePlan planFrame(const Scene& scene, const WaterBody& water, const Camera& camera, const Options& options,
                    ivec2 size, double time, const DepthComplexity* complexity, const VisibilityFacts* visibility)
{
    FramePlan plan;
    plan[PassId::scene] = wanted("what the eye sees, without the water", scaledSize(size, options.frame));
    plan[PassId::present] = wanted(presentReason(options.stereo.output) + finishing(size, options.frame),
                                   presentedSize(size, options.stereo.output));

    plan.underwater = water.present && options.water.enabled && options.underwater.enabled &&
                      overWaterRect(water, camera.eye) &&
                      camera.eye.y < surfaceHeight(water, vec2(camera.eye.x, camera.eye.z), time);

    const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
    if (water.present) plan.waterGrid = waterGrid(water, options.water, camera, aspect);
    if (water.present && options.water.enabled && options.underwater.enabled) {
        plan.side = waterSide(water, plan.waterGrid, camera, aspect, time);
        if (plan.side != WaterSide::crossing) plan.underwater = plan.side == WaterSide::below;
    }
    const auto bySide = [&plan](const char* above, const char* crossing, const char* below) {
        return plan.side == WaterSide::above ? above : plan.side == WaterSide::crossing ? crossing : below;
    };
    if (plan.side == WaterSide::crossing)
        plan[PassId::scene].reason = "what the eye sees, without the water; each pixel on its side of the waterline";

    const std::string noWater = whyNoWater(water, options);
    planSunlight(plan, scene, noWater, options);
    if (!noWater.empty()) {
        for (const PassId pass : {PassId::heights, PassId::refraction, PassId::reflection, PassId::water, PassId::glow})
            plan[pass] = unwanted(noWater);
        reducePlan(plan, scene, water, camera, options, size, visibility);
        return plan;
    }

    plan[PassId::water] =
        wanted(bySide("the surface is in the view", "the surface cuts the near plane: drawn from both sides",
                      "the surface seen from below"),
               scaledSize(size, options.frame));
    const HeightMapPicture* const givenBed = scene.maps.bed.picture ? &*scene.maps.bed.picture : nullptr;
    planWaterLookups(plan, options, scene.maps, chooseRefraction(options, water, camera, size, complexity, givenBed),
                     chooseReflection(options, complexity));
    const std::string noGlow = whyNoGlow(scene, plan, options);
    plan[PassId::glow] =
        noGlow.empty() ? wanted("the sun stands over the water", glowSize(size, options)) : unwanted(noGlow);
    reducePlan(plan, scene, water, camera, options, size, visibility);
    return plan;
}

} // namespace tarn
