#include "plan/lookup_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tarn {

namespace {

// A map that misses more of its places than this leaves more wrong than the search in a target does
// (docs/methods/height-maps.md).
constexpr double mostHidden = 0.02;
// Heights between texels are straight, so that one of some pixels still shows what is there; colours blur from about
// here.
constexpr float mostPixels = 4.0f;

/// Metres that a pixel spans where the lowest ray of the picture meets the level.
float pixelAtNearestWater(const WaterBody& water, const Camera& camera, ivec2 size)
{
    const vec3 forward = glm::normalize(camera.target - camera.eye);
    const float halfFov = 0.5f * camera.verticalFov;
    const float steepest =
        std::min(std::asin(std::clamp(-forward.y, -1.0f, 1.0f)) + halfFov, 0.5f * std::numbers::pi_v<float>);
    const float height = std::abs(camera.eye.y - water.level);
    const float distance = height / std::max(std::sin(steepest), 1.0e-3f);
    return distance * 2.0f * std::tan(halfFov) / static_cast<float>(size.y);
}

template <typename Method> LookupChoice named(Method method)
{
    return {method == Method::raycast || method == Method::combined, method != Method::raycast, ""};
}

LookupChoice target(std::string why) { return {false, true, std::move(why)}; }
LookupChoice map(std::string why) { return {true, false, std::move(why)}; }
LookupChoice both(std::string why) { return {true, true, std::move(why)}; }

/// Of the bed's map, the longer edge, m.
float texelOf(const HeightsOptions& options, const WaterBody& water, const HeightMapPicture* given)
{
    if (given) return std::max(given->extent.x, given->extent.y) / static_cast<float>(given->resolution);
    return (std::max(water.extent.x, water.extent.y) + 2.0f * options.border) / static_cast<float>(options.mapSize);
}

} // namespace

LookupChoice chooseRefraction(const Options& options, const WaterBody& water, const Camera& camera, ivec2 size,
                              const DepthComplexity* complexity, const HeightMapPicture* given)
{
    using Method = RefractionOptions::Method;
    if (options.refraction.method != Method::automatic) return named(options.refraction.method);
    if (!complexity) return target("auto: whether a map can hold the bed is not known");
    const std::string hidden = fmt::format("{:.1f} % of the bed lies under something else", 100.0 * complexity->bed);
    if (complexity->bed > mostHidden) return both(fmt::format("auto: {}, where the target is asked", hidden));
    const float texel = texelOf(options.heights, water, given);
    const float pixel = pixelAtNearestWater(water, camera, size);
    const std::string texels = fmt::format(
        "a texel of the map is {:.1f} cm, and a pixel of the nearest water {:.1f} cm", 100.0f * texel, 100.0f * pixel);
    if (texel > mostPixels * pixel) return both(fmt::format("auto: {}, so that the target shows what is near", texels));
    return map(fmt::format("auto: {}; {}", hidden, texels));
}

LookupChoice chooseReflection(const Options& options, const DepthComplexity* complexity)
{
    using Method = ReflectionOptions::Method;
    if (options.reflection.method != Method::automatic) return named(options.reflection.method);
    if (!complexity) return target("auto: whether a map can hold what stands over the water is not known");
    std::string why = fmt::format("auto: {:.1f} % of what stands over the water stands over something else",
                                  100.0 * complexity->aboveWater);
    return complexity->aboveWater <= mostHidden ? map(std::move(why)) : target(std::move(why));
}

bool wantsDepthComplexity(const Options& options)
{
    return options.refraction.method == RefractionOptions::Method::automatic ||
           options.reflection.method == ReflectionOptions::Method::automatic;
}

} // namespace tarn
