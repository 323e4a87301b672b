#include "plan/water_bounds.h"

#include "optics/optics.h"
#include "optics/refraction_camera.h"
#include "optics/waves.h"
#include "plan/frame_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tarn {

namespace {

using Polygon = std::vector<vec3>;

/// What of a polygon lies at or above a plane through the origin.
Polygon clipped(const Polygon& polygon, const vec3& inward)
{
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const float above = glm::dot(inward, a), next = glm::dot(inward, b);
        if (above >= 0.0f) kept.push_back(a);
        if ((above >= 0.0f) != (next >= 0.0f)) kept.push_back(glm::mix(a, b, above / (above - next)));
    }
    return kept;
}

/// The four sides of the pyramid that a picture shows, inward.
std::array<vec3, 4> sidesOf(const ViewTangents& tangents)
{
    const vec2 lower = tangents.middle - tangents.half, upper = tangents.middle + tangents.half;
    return {vec3(1.0f, 0.0f, lower.x), vec3(-1.0f, 0.0f, -upper.x), vec3(0.0f, 1.0f, lower.y),
            vec3(0.0f, -1.0f, -upper.y)};
}

bool filtersWaves(const WaterOptions& options)
{
    return options.filterWaves && options.normals == WaterOptions::Normals::pixel;
}

/// Sum of the waves' largest slopes.
float steepness(const WaterBody& water)
{
    float slope = 0.0f;
    for (const Wave& wave : water.waves) slope += std::abs(wave.amplitude) * 2.0f * pi / wave.wavelength;
    return slope;
}

/// What a triangle of the water's grid rises by a metre at most. Along either edge that lies on the axes it rises by no
/// more than the waves do and, where the cells grow, by 0.6 of that for what gridFade takes from one end only.
float steepestTriangle(const WaterBody& water) { return 1.6f * std::sqrt(2.0f) * steepness(water); }

/// Tangents from one pixel to the next.
vec2 pixelOf(const ViewTangents& tangents, ivec2 size) { return 2.0f * tangents.half / vec2(size); }

/// By how many standard deviations the outermost of water.frag's facets is tilted.
float outermostFacet(ReflectionOptions::Facets facets)
{
    switch (facets) {
    case ReflectionOptions::Facets::one: return 0.0f;
    case ReflectionOptions::Facets::three: return 1.7320508f;
    case ReflectionOptions::Facets::five: break;
    }
    return 2.8569700f;
}

/// |h/H| of the point U, at most (mirrorBounds). A step of water_surface.glsl's moveToWaves goes up or down by at most
/// twice the gap to the waves, so that it triples at most; all together go no further than a quarter of the way.
float largestRise(float amplitude, float height, int steps)
{
    const float bySteps = amplitude * (2.0f * std::pow(3.0f, static_cast<float>(steps)) - 1.0f) / height;
    return std::min(bySteps, 0.25f + 1.25f * amplitude / height);
}

/// Where a triangle covers samples of a pixel but not its middle, the surface's point lies on its plane beside it. How
/// much higher or lower than the triangle, m: the triangle of the eye, the one point and the other has the angle of
/// half a pixel at the eye, and at the other that between ray and plane. Negative: no bound, for a triangle may be seen
/// edge-on.
/// @param up in view space   @param tilt of a triangle, at most, radians
float riseBeside(const std::vector<vec3>& corners, const vec3& up, float tilt, float halfPixel)
{
    float farthest = 0.0f, flattestRay = 0.5f * pi; // below the horizon
    for (const vec3& corner : corners) {
        const float distance = glm::length(corner);
        farthest = std::max(farthest, distance);
        flattestRay = std::min(flattestRay, std::asin(std::clamp(-glm::dot(up, corner) / distance, -1.0f, 1.0f)));
    }
    const float between = flattestRay - tilt - halfPixel;
    if (between <= 0.01f) return -1.0f;
    return farthest * std::sin(halfPixel) / std::sin(between) * std::sin(tilt);
}

/// The bounds, as tangents, of all that is within an angle of what lies between the corners.
class Surroundings {
public:
    Surroundings(const std::vector<vec3>& corners, float angle) : sine_(std::sin(std::min(angle, 0.5f * pi)))
    {
        for (const vec3& corner : corners) {
            const vec3 v = glm::normalize(corner);
            reachesCamera |= v.z + sine_ > -nearlyZero;
            for (int axis = 0; axis < 2; ++axis) add(axis, v);
        }
    }

    bool reachesCamera = false; ///< some of it lies beside the camera or behind: there are no bounds
    vec2 lower{std::numeric_limits<float>::max()}, upper{std::numeric_limits<float>::lowest()};

private:
    static constexpr float nearlyZero = 0.02f; // tangents of 50, with digits left for the angle

    void add(int axis, const vec3& v)
    {
        const float radius = std::hypot(v[axis], v.z), angle = std::atan2(v[axis], -v.z);
        const float spread = sine_ < radius ? std::asin(sine_ / radius) : pi;
        reachesCamera |= std::abs(angle) + spread > 0.5f * pi - nearlyZero;
        if (reachesCamera) return;
        lower[axis] = std::min(lower[axis], std::tan(angle - spread));
        upper[axis] = std::max(upper[axis], std::tan(angle + spread));
    }

    float sine_;
};

/// Normalised device coordinates between texels, with two to spare: one for linear filtering, one for rounding.
TargetBounds wholeTexels(vec2 lower, vec2 upper, int resolution)
{
    const float texels = static_cast<float>(resolution);
    const auto toTexels = [texels](vec2 at) { return (0.5f * glm::clamp(at, -1.0f, 1.0f) + 0.5f) * texels; };
    const vec2 first = glm::max(glm::floor(toTexels(lower)) - 2.0f, vec2(0.0f));
    const vec2 end = glm::min(glm::ceil(toTexels(upper)) + 2.0f, vec2(texels));
    return {2.0f * first / texels - 1.0f, 2.0f * end / texels - 1.0f};
}

} // namespace

float TargetBounds::fraction() const { return 0.25f * (upper.x - lower.x) * (upper.y - lower.y); }

std::vector<vec3> visibleCorners(const WaterBody& water, const Camera& camera, float aspect)
{
    const Bounds slab = waterBounds(water);
    const mat4 view = viewFromWorld(camera);
    std::array<vec3, 8> box;
    for (std::size_t i = 0; i < 8; ++i)
        box[i] = vec3(view * vec4((i & 1) ? slab.upper.x : slab.lower.x, (i & 2) ? slab.upper.y : slab.lower.y,
                                  (i & 4) ? slab.upper.z : slab.lower.z, 1.0f));
    constexpr std::array<std::array<std::size_t, 4>, 6> faces{
        {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}};
    std::vector<vec3> corners;
    for (const auto& face : faces) {
        Polygon polygon{box[face[0]], box[face[1]], box[face[2]], box[face[3]]};
        for (const vec3& side : sidesOf(ViewTangents(clipFromView(camera, aspect)))) polygon = clipped(polygon, side);
        corners.insert(corners.end(), polygon.begin(), polygon.end());
    }
    return corners;
}

// A pixel's neighbours lie on the rays at the tangents t and t + e. What the one is away from the other's ray is at
// least its depth times |e| / sqrt(1 + t²), and of that the triangle leaves 1 / sqrt(1 + slope²) to x and z. Half,
// because the neighbour may be nearer than the pixel itself.
float leastFootprint(const WaterBody& water, const Camera& camera, const std::vector<vec3>& corners, ivec2 size)
{
    float depth = std::numeric_limits<float>::max();
    for (const vec3& corner : corners) depth = std::min(depth, -corner.z);
    if (corners.empty()) return 0.0f;
    const ViewTangents tangents(clipFromView(camera, static_cast<float>(size.x) / static_cast<float>(size.y)));
    const vec2 pixel = pixelOf(tangents, size);
    const vec2 farthest = glm::abs(tangents.middle) + tangents.half + pixel;
    const float slope = steepestTriangle(water);
    return 0.5f * std::max(depth, 0.0f) * std::min(pixel.x, pixel.y) /
           std::sqrt((1.0f + glm::dot(farthest, farthest)) * (1.0f + slope * slope));
}

float largestSlope(const WaterBody& water, const Options& options, float footprint)
{
    const bool filters = filtersWaves(options.water);
    float sum = 0.0f, variance = 0.0f;
    for (const Wave& wave : water.waves) {
        const optics::WaveTerm term = optics::makeWaveTerm(wave.amplitude, wave.wavelength, 0.0f, 0.0f);
        sum += (filters ? optics::waveFilter(term, footprint) : 1.0f) * std::abs(wave.amplitude) * term.wavenumber;
        if (filters) variance += 0.5f * optics::waveFilteredVariance(term, 0.0f);
    }
    return sum + outermostFacet(options.reflection.facets) * std::sqrt(variance);
}

TargetBounds mirrorBounds(const WaterBody& water, const Camera& camera, const Options& options, ivec2 size)
{
    if (water.normalMap.isSeen()) return {};        // whose slopes have no bound
    if (options.reflection.interval > 1) return {}; // later frames look the target up from elsewhere
    // Nor have those between a triangle's corners where it is gone on with beside them.
    if (options.water.normals == WaterOptions::Normals::vertex && options.frame.samples() > 1) return {};
    const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
    const float height = camera.eye.y - water.level, amplitude = totalAmplitude(water);
    const std::vector<vec3> corners = visibleCorners(water, camera, aspect);
    const ViewTangents picture(clipFromView(camera, aspect));
    const vec2 edge = glm::abs(picture.middle) + picture.half;
    const float nearest = camera.nearPlane * std::sqrt(1.0f + glm::dot(edge, edge)); // to the near plane's corners
    if (corners.empty() || height <= 2.0f * amplitude + nearest) return {};

    const float halfPixel = 0.5f * glm::length(pixelOf(picture, size));
    float beside = 0.0f;
    if (options.frame.samples() > 1) {
        const vec3 up = mat3(viewFromWorld(camera)) * vec3(0.0f, 1.0f, 0.0f);
        beside = riseBeside(corners, up, std::atan(steepestTriangle(water)), halfPixel);
        if (beside < 0.0f) return {};
    }
    constexpr float rounding = 1.0e-3f;
    const float rise = largestRise(amplitude + beside, height, options.water.surfaceSteps);
    if (rise >= 1.0f) return {};
    const float turn = 2.0f * std::atan(largestSlope(water, options, leastFootprint(water, camera, corners, size)));
    const Surroundings rays(corners, std::max(std::asin(rise), turn) + halfPixel + rounding);
    if (rays.reachesCamera) return {};

    const ReflectionOptions& reflection = options.reflection;
    const float extension = optics::fovExtension(height, reflection.fovExtensionNear, reflection.fovExtensionFar);
    const ViewTangents target(clipFromView(camera, aspect, extension));
    return wholeTexels((rays.lower - target.middle) / target.half, (rays.upper - target.middle) / target.half,
                       reflection.targetSize);
}

} // namespace tarn
