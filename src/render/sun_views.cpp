#include "render/sun_views.h"

#include "optics/optics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace tarn {

namespace {

/// Where the sun's light through the corners of a box crosses the level. A sun near the horizon moves nothing farther
/// than the box is wide.
LevelRect onLevel(const Bounds& bounds, const vec3& toSun, float level)
{
    const vec2 low(bounds.lower.x, bounds.lower.z), high(bounds.upper.x, bounds.upper.z);
    vec2 least = low, most = high;
    for (const float y : {bounds.lower.y, bounds.upper.y}) {
        const vec2 aside = glm::clamp((y - level) / toSun.y * vec2(toSun.x, toSun.z), low - high, high - low);
        least = glm::min(least, low - aside);
        most = glm::max(most, high - aside);
    }
    return {0.5f * (least + most), 0.5f * (most - least)};
}

/// The rectangle whose edges lie at a part of the way from those of one to those of another.
LevelRect between(const LevelRect& from, const LevelRect& to, float part)
{
    return {glm::mix(from.centre, to.centre, part), glm::mix(from.halfExtent, to.halfExtent, part)};
}

/// Adds maps to the first until they hold the scene: the last holds all of it, one between them stands at the
/// geometric mean of their sizes, so that texels grow by the same factor from each to the next.
void addCascades(std::vector<LevelRect>& cascades, const LevelRect& scene, int most)
{
    const LevelRect first = cascades.front();
    const vec2 low = glm::min(first.centre - first.halfExtent, scene.centre - scene.halfExtent);
    const vec2 high = glm::max(first.centre + first.halfExtent, scene.centre + scene.halfExtent);
    const LevelRect whole{0.5f * (low + high), 0.5f * (high - low)};
    const auto size = [](const LevelRect& rect) { return std::max(rect.halfExtent.x, rect.halfExtent.y); };
    const float growth = size(whole) / size(first);
    // A shore that reaches a tenth farther is not worth a map.
    constexpr float worthOne = 1.1f, worthTwo = 3.0f;
    if (growth <= worthOne || most < 2) return;
    if (growth > worthTwo && most > 2)
        cascades.push_back(between(first, whole, (std::sqrt(growth) - 1.0f) / (growth - 1.0f)));
    cascades.push_back(whole);
}

} // namespace

SunVolume sunVolume(const WaterBody& water, const Bounds& bounds, const vec3& toSun, const SunlightOptions& options)
{
    SunVolume volume;
    LevelRect& rect = volume.cascades.front();
    if (!bounds.empty()) {
        // A little room, so that neither the lowest bed nor the highest leaf lies on the end of the range.
        const float room = 0.01f * std::max(bounds.extent().y, 1.0f);
        volume.lowest = bounds.lower.y - room;
        volume.highest = bounds.upper.y + room;
    }
    if (water.present) {
        // The shore's own shadows, and those that fall on it, reach a part of the water's size inland.
        constexpr float withShore = 1.3f;
        rect = {water.centre, 0.5f * withShore * water.extent};
        const float deepest = bounds.empty() ? 0.0f : std::max(water.level - volume.lowest, 0.0f);
        if (toSun.y > 0.0f) {
            // Towards the sun, where the light that reaches the deepest bed crosses the level. A sun near the horizon
            // may not spread the map's texels without end.
            const vec2 shear = glm::clamp(deepest / toSun.y * vec2(toSun.x, toSun.z), -water.extent, water.extent);
            rect.centre += 0.5f * shear;
            rect.halfExtent += 0.5f * glm::abs(shear);
        }
        volume.lowest = std::min(volume.lowest, water.level - 1.0f);
        volume.highest = std::max(volume.highest, water.level + 1.0f);
    } else if (!bounds.empty()) {
        const vec3 centre = bounds.centre(), half = 0.5f * bounds.extent();
        rect = {{centre.x, centre.z}, glm::max(vec2(half.x, half.z), vec2(0.5f))};
    }
    if (!bounds.empty() && toSun.y > 0.0f)
        addCascades(volume.cascades, onLevel(bounds, toSun, water.level), options.cascades);
    return volume;
}

View parallelView(const LevelRect& rect, float lowest, float highest, vec2 shear, float level)
{
    // Rows of clipFromWorld: x - shear (y - level) and z likewise over the rectangle, heights from the top down.
    const vec2 half = rect.halfExtent;
    const float range = highest - lowest;
    const vec4 rowX(1.0f / half.x, -shear.x / half.x, 0.0f, (shear.x * level - rect.centre.x) / half.x);
    const vec4 rowY(0.0f, -shear.y / half.y, 1.0f / half.y, (shear.y * level - rect.centre.y) / half.y);
    const vec4 rowZ(0.0f, -2.0f / range, 0.0f, (highest + lowest) / range);
    View view;
    view.clipFromView = glm::transpose(mat4(rowX, rowY, rowZ, vec4(0.0f, 0.0f, 0.0f, 1.0f)));
    view.mirrored = true; // z of the world runs up the map
    return view;
}

View sunView(const SunVolume& volume, SunLayer layer, std::size_t cascade, const vec3& toSun, const WaterBody& water,
             bool hasWater)
{
    const float level = water.level;
    const LevelRect& rect = volume.cascades.at(cascade);
    View view = parallelView(rect, volume.lowest, volume.highest, optics::sunShear(toSun), level);
    view.eye = vec3(rect.centre.x, level, rect.centre.y) +
               2.0f * (volume.highest - volume.lowest + glm::length(rect.halfExtent)) * toSun;
    // The bed goes on a little above the level, so that the last photons before the shore find it there.
    constexpr float beach = 0.12f;
    if (hasWater)
        view.clipPlane =
            layer == SunLayer::aboveWater ? vec4(0.0f, 1.0f, 0.0f, -level) : vec4(0.0f, -1.0f, 0.0f, level + beach);
    return view;
}

namespace {

/// The step of √2 from `least` that holds an extent.
float quantised(float extent, float least)
{
    const float steps = std::ceil(2.0f * std::log2(std::max(extent / least, 1.0f)) - 1.0e-3f);
    return least * std::exp2(0.5f * steps);
}

float snapped(float value, float step) { return step * std::floor(value / step + 0.5f); }

} // namespace

CausticsRegion causticsRegion(const WaterBody& water, const Camera& camera, const CausticsOptions& options)
{
    const float whole = std::max(water.extent.x, water.extent.y);
    const float height = std::abs(camera.eye.y - water.level);
    // Six times the eye's height away the bed is seen at 10 degrees, where water mirrors more than it lets through.
    constexpr float least = 16.0f, perHeight = 6.0f, beside = 4.0f;
    const float extent = options.extent > 0.0f ? options.extent : quantised(perHeight * height + beside, least);
    // Light that waves throw past the water's edge still lands on something.
    constexpr float withRim = 1.05f;
    if (extent >= whole) return {{water.centre, vec2(0.5f * withRim * whole)}, 0.0f};

    const vec3 forward = glm::normalize(camera.target - camera.eye);
    const vec2 wanted = vec2(camera.eye.x, camera.eye.z) + 0.4f * extent * vec2(forward.x, forward.z);
    // Both lattices, texels and photons, repeat after this many metres.
    const float step = extent / static_cast<float>(std::gcd(options.textureSize, options.photons));
    constexpr float borderFraction = 0.08f;
    return {{{snapped(wanted.x, step), snapped(wanted.y, step)}, vec2(0.5f * extent)}, borderFraction * extent};
}

float shadowBias(const SunVolume& volume, std::size_t cascade, const SunlightOptions& options)
{
    const auto texel = [&](std::size_t i) {
        const vec2 half = volume.cascades.at(i).halfExtent;
        return 2.0f * std::max(half.x, half.y) / static_cast<float>(options.mapSize);
    };
    return options.bias + 0.25f * (texel(cascade) - texel(0));
}

blocks::SunBlock sunBlock(const SunVolume& volume, const CausticsRegion& region, const Options& options)
{
    blocks::SunBlock block{};
    block.sunRect = vec4(volume.cascades.front().centre, volume.cascades.front().halfExtent);
    for (std::size_t i = 1; i < volume.cascades.size(); ++i)
        block.sunRectsBeyond[i - 1] = vec4(volume.cascades[i].centre, volume.cascades[i].halfExtent);
    for (std::size_t i = 0; i < volume.cascades.size(); ++i)
        block.sunBiases[static_cast<int>(i)] = shadowBias(volume, i, options.sunlight);
    block.sunHeights = vec4(volume.lowest, volume.highest, 0.0f, 0.0f);
    block.causticsRect = vec4(region.rect.centre, region.rect.halfExtent);
    const float edge = 2.0f * region.rect.halfExtent.x;
    block.causticsBorder = vec4(region.border, edge / static_cast<float>(options.caustics.textureSize),
                                edge / static_cast<float>(options.caustics.photons), 0.0f);
    return block;
}

} // namespace tarn
