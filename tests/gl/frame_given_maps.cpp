// Maps of heights that are given as pictures: as good as the drawn ones, and, made up, met where formulas say.
#include "raycast_frames.h"
#include "temp_folder.h"
#include "test_renderer.h"
#include "test_scenes.h"

#include "base/log.h"
#include "gl/shader_library.h"
#include "optics/optics.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace tarn::test {
namespace {

using glm::dvec3;

/// Of the bed, and of what is mirrored.
Options bothRaycast(HeightsOptions::March march = HeightsOptions::March::pyramid)
{
    Options options = raycastOptions(march);
    options.reflection.method = ReflectionOptions::Method::raycast;
    return options;
}

Sun sunAt(const vec3& direction, float irradiance)
{
    Sun sun;
    sun.direction = glm::normalize(direction);
    sun.irradiance = vec3(irradiance);
    sun.automatic = false;
    return sun;
}

/// A sunlit pool with a sunken block, a post through the surface and a deck over it.
Scene furnishedPool()
{
    Scene scene = flatLake(1.0f, 6.0f);
    scene.sun = sunAt({0.4f, 1.0f, 0.3f}, 3.0f);
    scene.water.absorption = vec3(0.4f, 0.2f, 0.1f);
    Wave wave;
    wave.amplitude = 0.02f;
    wave.wavelength = 0.9f;
    scene.water.waves = {wave};
    addBox(scene, {-1.0f, -1.0f, -0.5f}, {-0.4f, -0.5f, 0.2f}, addMaterial(scene, vec3(0.2f, 0.6f, 0.2f)));
    addBox(scene, {0.4f, -1.0f, -0.2f}, {0.6f, 0.8f, 0.0f}, addMaterial(scene, vec3(0.8f, 0.1f, 0.1f)));
    addBox(scene, {-0.6f, 0.5f, -1.6f}, {0.8f, 0.6f, -0.9f}, addMaterial(scene, vec3(0.6f, 0.4f, 0.2f)));
    return scene;
}

std::size_t trianglesOfMaps(const FrameReport& stats)
{
    for (const FrameReport::Pass& pass : stats.passes)
        if (pass.name == "heights") return pass.triangles;
    return 0;
}

std::vector<std::string> warnings(const log::Capture& log)
{
    std::vector<std::string> texts;
    for (const log::Capture::Message& message : log.messages())
        if (message.level == log::Level::warning) texts.push_back(message.text);
    return texts;
}

TEST(GivenMaps, ShowWhatTheDrawnOnesShow)
{
    const Scene drawn = furnishedPool();
    const Camera camera = over({0.2f, 1.4f, 3.2f}, {0, -0.4f, -0.2f});
    const TempFolder folder;
    Scene given = furnishedPool();
    {
        TestRenderer test(drawn, bothRaycast());
        test.renderer.render({camera, 0.3, pictureSize});
        const auto passOn = [&](MapKind kind, GivenMap& map) {
            const auto file = folder.path() / (std::string(mapName(kind)) + ".exr");
            writeMapPicture(file, test.renderer.readMap(kind).value());
            map.file = file;
            map.picture = readMapPicture(file, kind);
        };
        passOn(MapKind::bed, given.maps.bed);
        passOn(MapKind::aboveWater, given.maps.aboveWater);
    }
    EXPECT_EQ(given.maps.bed.picture->resolution, 256);
    EXPECT_EQ(given.maps.bed.picture->extent, vec2(10.0f)) << "the water and heights.border";
    const log::Capture log;
    for (const auto march : {HeightsOptions::March::pyramid, HeightsOptions::March::classic}) {
        TestRenderer a(drawn, bothRaycast(march)), b(given, bothRaycast(march));
        for (const double time : {0.3, 0.8}) {
            EXPECT_EQ(trianglesOfMaps(a.renderer.render({camera, time, pictureSize})) > 0, time < 0.5);
            EXPECT_EQ(trianglesOfMaps(b.renderer.render({camera, time, pictureSize})), 0u) << "they are not drawn";
            const Image wanted = a.renderer.readDisplay(), shown = b.renderer.readDisplay();
            int worst = 0;
            for (std::size_t i = 0; i < wanted.bytes.size(); ++i)
                worst = std::max(worst, std::abs(static_cast<int>(wanted.bytes[i]) - static_cast<int>(shown.bytes[i])));
            EXPECT_LE(worst, 1);
        }
    }
    EXPECT_TRUE(warnings(log).empty()) << warnings(log)[0];
}

/// A made-up bed over a square about the origin: its heights, and how it answers the sun.
HeightMapPicture bedMap(int edge, float extent, const std::function<float(float x, float z)>& height,
                        float response = 0.0f)
{
    HeightMapPicture map;
    map.resolution = edge;
    map.extent = vec2(extent);
    map.lowest = -10.0f;
    for (int j = 0; j < edge; ++j)
        for (int i = 0; i < edge; ++i) {
            const vec2 place =
                (vec2(static_cast<float>(i), static_cast<float>(j)) + 0.5f) * extent / static_cast<float>(edge);
            map.heights.push_back(height(place.x - 0.5f * extent, place.y - 0.5f * extent));
        }
    const auto texels = static_cast<std::size_t>(edge * edge);
    map.colours[0].assign(3 * texels, 0.25f);
    map.colours[1].assign(3 * texels, response);
    return map;
}

/// Of a view of still water, what is off of what a formula says, at most, over the pixels that it knows.
/// @param exact from U and the ray's direction, or a vector of NaN
double worstError(const Scene& scene, const Options& options, const Camera& camera, DebugView view,
                  const std::function<dvec3(const dvec3& u, const dvec3& eyeRay)>& exact, int& known)
{
    CheckedRenderer renderer(scene, options);
    const Image surface = renderer.linear(camera, pictureSize, 0.0, DebugView::positionU);
    const Image image = renderer.linear(camera, pictureSize, 0.0, view);
    double worst = 0.0;
    known = 0;
    for (int y = 0; y < pictureSize.y; ++y)
        for (int x = 0; x < pictureSize.x; ++x) {
            const vec4 u = pixel(surface, x, y);
            if (u.w == 0.0f) continue;
            const dvec3 hit = exact(dvec3(u), glm::normalize(dvec3(u) - dvec3(camera.eye)));
            if (std::isnan(hit.x)) continue;
            ++known;
            worst = std::max(worst, glm::distance(hit, dvec3(pixel(image, x, y))));
        }
    return worst;
}

const dvec3 unknown(std::nan(""));

dvec3 refractedBy(const dvec3& eyeRay) { return optics64::refractRay(eyeRay, dvec3(0, 1, 0), 1.0 / n); }

// y = -1.2 + 0.15 x - 0.1 z: a plane lies between the heights of a map as it is.
TEST(GivenMaps, ASlopeIsMetWhereSnellSays)
{
    Scene scene = flatLake(5.0f, 8.0f); // the scene's own bed lies far below
    scene.maps.bed.picture = bedMap(64, 8.0f, [](float x, float z) { return -1.2f + 0.15f * x - 0.1f * z; });
    int known = 0;
    const double worst = worstError(
        scene, bothRaycast(), over({0, 1.6f, 4}, {0, -1, 0}), DebugView::positionW,
        [](const dvec3& u, const dvec3& eyeRay) {
            const dvec3 r = refractedBy(eyeRay);
            const double t = (-1.2 + 0.15 * u.x - 0.1 * u.z - u.y) / (r.y - 0.15 * r.x + 0.1 * r.z);
            const dvec3 hit = u + t * r;
            return std::max(std::abs(hit.x), std::abs(hit.z)) < 3.9 ? hit : unknown;
        },
        known);
    EXPECT_GT(known, 5000);
    EXPECT_LT(worst, 1.0e-3);
}

// A step from -2 to -1 m at x = 0: between the texels beside it, a ramp. And rows run along +z: a ridge lies at z = 1.
TEST(GivenMaps, AStepIsMetOnEitherSideOfIt)
{
    constexpr float extent = 8.0f;
    constexpr int edge = 256;
    constexpr double half = 0.5 * 8.0 / 256.0; // of a texel
    Scene scene = flatLake(5.0f, 8.0f);
    scene.maps.bed.picture = bedMap(edge, extent, [](float x, float) { return x < 0.0f ? -2.0f : -1.0f; });
    int low = 0, high = 0, ramp = 0, known = 0;
    const auto exact = [&](const dvec3& u, const dvec3& eyeRay) {
        const dvec3 r = refractedBy(eyeRay);
        const dvec3 top = u + (-1.0 - u.y) / r.y * r, bottom = u + (-2.0 - u.y) / r.y * r;
        if (std::max(std::abs(bottom.x), std::abs(bottom.z)) > 3.9) return unknown;
        // y = -1.5 + x / (2 half) for |x| <= half
        const double t = (-1.5 + u.x / (2.0 * half) - u.y) / (r.y - r.x / (2.0 * half));
        const dvec3 onRamp = u + t * r;
        if (top.x > half + 0.001) return ++high, top;
        if (bottom.x < -half - 0.001 && u.x < half) return ++low, bottom;
        if (t > 0.0 && std::abs(onRamp.x) < half - 0.001 && r.x > 0.1) return ++ramp, onRamp;
        return unknown;
    };
    EXPECT_LT(
        worstError(scene, bothRaycast(), over({-1.5f, 1.0f, 2}, {0.5f, -1, 0}), DebugView::positionW, exact, known),
        2.0e-3);
    EXPECT_GT(low, 500);
    EXPECT_GT(high, 2000);
    EXPECT_GT(ramp, 100);

    scene.maps.bed.picture = bedMap(edge, extent, [](float, float z) { return z > 0.5f && z < 1.5f ? -1.0f : -2.0f; });
    const auto onRidge = [](const dvec3& u, const dvec3& eyeRay) {
        const dvec3 r = refractedBy(eyeRay);
        const dvec3 top = u + (-1.0 - u.y) / r.y * r;
        return top.z > 0.6 && top.z < 1.4 && std::abs(top.x) < 3.9 ? top : unknown;
    };
    EXPECT_LT(worstError(scene, bothRaycast(), over({0, 1.6f, 5}, {0, -1, 0}), DebugView::positionW, onRidge, known),
              2.0e-3);
    EXPECT_GT(known, 1000);
}

// A ceiling at 1 m: every mirrored ray meets it from below.
TEST(GivenMaps, WhatStandsOverTheWaterIsMirroredWhereItIs)
{
    Scene scene = flatLake(1.0f, 8.0f);
    HeightMapPicture map;
    map.kind = MapKind::aboveWater;
    map.resolution = 64;
    map.extent = vec2(40.0f);
    for (int i = 0; i < 64 * 64; ++i) map.heights.insert(map.heights.end(), {1.0f, 1.5f, 1.0f});
    map.colours[0].assign(3 * 64 * 64, 0.0f);
    map.colours[1].assign(3 * 64 * 64, 5.0f);
    scene.maps.aboveWater.picture = map;
    int known = 0;
    const double worst = worstError(
        scene, bothRaycast(), over({0, 0.8f, 4}, {0, -0.4f, 0}), DebugView::reflectionHit,
        [](const dvec3& u, const dvec3& eyeRay) {
            const dvec3 up(eyeRay.x, -eyeRay.y, eyeRay.z);
            const dvec3 hit = u + (1.0 - u.y) / up.y * up;
            return std::max(std::abs(hit.x), std::abs(hit.z)) < 18.0 ? hit : unknown;
        },
        known);
    EXPECT_GT(known, 5000);
    EXPECT_LT(worst, 5.0e-3);
}

// What the bed answers is for each unit of the sun's irradiance: twice the sun, twice its share of the picture.
TEST(GivenMaps, TheBedFollowsTheSunsStrength)
{
    Scene scene = flatLake(5.0f, 8.0f);
    scene.sky.radiance = vec3(0.0f);
    scene.maps.bed.picture = bedMap(
        64, 8.0f, [](float, float) { return -1.0f; }, 0.2f);
    scene.maps.bed.picture->colours[0].assign(3 * 64 * 64, 0.0f);
    Options options = bothRaycast();
    options.caustics.enabled = options.sunlight.shadows = false;
    const Camera camera = over({0, 2.5f, 0.1f}, {0, -1, 0});
    const auto middle = [&](float irradiance) {
        scene.sun = sunAt({0.6f, 1.0f, 0.0f}, irradiance);
        CheckedRenderer renderer(scene, options);
        return static_cast<double>(pixel(renderer.linear(camera, pictureSize), 80, 60).x);
    };
    const double once = middle(1.0f);
    const double sun =
        static_cast<double>(optics::sunIrradianceBelow(vec3(1.0f), glm::normalize(vec3(0.6f, 1, 0)).y, 1.33f).x);
    const double down = 1.0 - optics64::fresnelExact(1.0, 1.0 / n);
    EXPECT_NEAR(once, down / (n * n) * 0.2 * sun, 0.02 * once);
    EXPECT_NEAR(middle(2.0f), 2.0 * once, 0.01 * once);
}

TEST(GivenMaps, AnotherLightIsSaidOnce)
{
    Scene scene = furnishedPool();
    const Camera camera = over({0.2f, 1.4f, 3.2f}, {0, -0.4f, -0.2f});
    HeightMapPicture map;
    {
        TestRenderer test(scene, bothRaycast());
        test.renderer.render({camera, 0.0, pictureSize});
        map = test.renderer.readMap(MapKind::bed).value();
    }
    map.file = "bed.exr";
    scene.maps.bed.picture = map;
    scene.sun = sunAt({-0.4f, 1.0f, 0.3f}, 3.0f);
    const log::Capture log;
    TestRenderer test(scene, bothRaycast());
    for (const double time : {0.0, 0.1}) test.renderer.render({camera, time, pictureSize});
    ASSERT_EQ(warnings(log).size(), 1u);
    EXPECT_TRUE(warnings(log)[0].starts_with("bed.exr: the sun changed since this map was made"));
}

} // namespace
} // namespace tarn::test
