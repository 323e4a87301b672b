// What the sun looks at: the rectangles on the water's level that its maps cover, and the parallel projections onto
// them (shaders/shared/sunlight.glsl). World space, metres.
#pragma once

#include "optics/blocks.h"
#include "plan/options.h"
#include "render/view.h"
#include "scene/scene.h"

#include <vector>

namespace tarn {

/// A rectangle on the plane of the water's level.
struct LevelRect {
    vec2 centre{0.0f}; ///< x and z
    vec2 halfExtent{1.0f};
    bool operator==(const LevelRect&) const = default;
};

/// What the shadow maps hold. It does not depend on the eye, so that their texels never move and they need drawing
/// only once.
struct SunVolume {
    /// Where maps are laid: over the water and a part of the shore first, then, each holding the one before it, as far
    /// as the scene goes (1 to 3).
    std::vector<LevelRect> cascades{LevelRect{}};
    float lowest = -1.0f, highest = 1.0f; ///< of the scene
    bool operator==(const SunVolume&) const = default;
};
/// @param bounds of the whole scene   @param toSun in the air; what lies deep is looked up that much to its side
SunVolume sunVolume(const WaterBody& water, const Bounds& bounds, const vec3& toSun, const SunlightOptions& options);

/// Which half of the scene a shadow map holds.
enum class SunLayer { aboveWater, submerged };

/// The parallel projection along the sun (above water) or along the refracted sun (submerged). Depth 0 is the highest
/// height of the volume, 1 the lowest. toSun: in the layer's medium, unit, above the horizon.
/// Without water all of the scene is above water.
View sunView(const SunVolume& volume, SunLayer layer, std::size_t cascade, const vec3& toSun, const WaterBody& water,
             bool hasWater);

/// A parallel projection onto a rectangle at a level, along what moves by `shear` sideways for each metre up. Depth 0
/// is at the highest height, 1 at the lowest; the map's rows run along +z.
View parallelView(const LevelRect& rect, float lowest, float highest, vec2 shear, float level);

/// What the caustics texture covers: the whole water when that is small, else a square about what the eye sees of it,
/// whose size has steps of √2 and whose place has steps of a texel, so that texels and photons keep their place on the
/// water while the eye moves.
struct CausticsRegion {
    LevelRect rect;
    float border = 0.0f; ///< width of the border in which it gives way to a flat surface; 0: it holds all there is
    bool operator==(const CausticsRegion&) const = default;
};
CausticsRegion causticsRegion(const WaterBody& water, const Camera& camera, const CausticsOptions& options);

/// By how much an occluder must clear a surface in a cascade, m: the option's bias in the first; a coarser texel,
/// within which a surface may bend, asks for a quarter of what it is wider.
float shadowBias(const SunVolume& volume, std::size_t cascade, const SunlightOptions& options);

blocks::SunBlock sunBlock(const SunVolume& volume, const CausticsRegion& region, const Options& options);

} // namespace tarn
