#include "plan/lookup_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tarn {

namespace {

// A map that misses more of its places than this leaves more wrong than the other method's search does (README, "Through
// maps of heights").
constexpr double mostHidden = 0.02;
// Heights between texels are straight, so that one of some pixels still shows what is there; colours blur from about here.
constexpr float mostPixels = 4.0f;

/// Metres that a pixel spans where the lowest ray of the picture meets the level.
float pixelAtNearestWater(const WaterBody& water, const Camera& camera, ivec2 size)
{
    const vec3 forward = glm::normalize(camera.target - camera.eye);
    const float halfFov = 0.5f * camera.verticalFov;
    const float steepest = std::min(std::asin(std::clamp(-forward.y, -1.0f, 1.0f)) + halfFov,
                                    0.5f * std::numbers::pi_v<float>);
    const float height = std::abs(camera.eye.y - water.level);
    const float distance = height / std::max(std::sin(steepest), 1.0e-3f);
    return distance * 2.0f * std::tan(halfFov) / static_cast<float>(size.y);
}

/// Of the bed's map, the longer edge, m.
float texelOf(const HeightsOptions& options, const WaterBody& water, const HeightMapPicture* given)
{
    if (given) return std::max(given->extent.x, given->extent.y) / static_cast<float>(given->edge);
    return (std::max(water.extent.x, water.extent.y) + 2.0f * options.border) / static_cast<float>(options.mapSize);
}

} // namespace

LookupChoice chooseRefraction(const Options& options, const WaterBody& water, const Camera& camera, ivec2 size,
                              const DepthComplexity* complexity, const HeightMapPicture* given)
{
    using Method = RefractionOptions::Method;
    if (options.refraction.method != Method::automatic) return {options.refraction.method == Method::raycast, ""};
    if (!complexity) return {false, "auto: whether a map can hold the bed is not known"};
    if (complexity->bed > mostHidden)
        return {false, fmt::format("auto: {:.1f} % of the bed lies under something else", 100.0 * complexity->bed)};
    const float texel = texelOf(options.heights, water, given);
    const float pixel = pixelAtNearestWater(water, camera, size);
    if (texel > mostPixels * pixel)
        return {false, fmt::format("auto: a texel of the map is {:.1f} cm, and a pixel of the nearest water {:.1f} cm",
                                   100.0f * texel, 100.0f * pixel)};
    return {true, fmt::format("auto: {:.1f} % of the bed lies under something else, a texel is {:.1f} cm and a pixel of the "
                              "nearest water {:.1f} cm",
                              100.0 * complexity->bed, 100.0f * texel, 100.0f * pixel)};
}

LookupChoice chooseReflection(const Options& options, const DepthComplexity* complexity)
{
    using Method = ReflectionOptions::Method;
    if (options.reflection.method != Method::automatic) return {options.reflection.method == Method::raycast, ""};
    if (!complexity) return {false, "auto: whether a map can hold what stands over the water is not known"};
    const double stacked = 100.0 * complexity->afloat;
    return {complexity->afloat <= mostHidden,
            fmt::format("auto: {:.1f} % of what stands over the water stands over something else", stacked)};
}

bool wantsDepthComplexity(const Options& options)
{
    return options.refraction.method == RefractionOptions::Method::automatic ||
           options.reflection.method == ReflectionOptions::Method::automatic;
}

} // namespace tarn
