// How steep the water's surface can be where a camera sees it, and what of the reflection's target it can look up
// there.
#pragma once

#include "plan/options.h"
#include "scene/scene.h"

#include <vector>

namespace tarn {

/// A part of a target, in normalised device coordinates.
struct TargetBounds {
    vec2 lower{-1.0f}, upper{1.0f};

    float fraction() const; ///< of the target's area
    bool isWhole() const { return lower == vec2(-1.0f) && upper == vec2(1.0f); }
    bool operator==(const TargetBounds&) const = default;
};

/// The corners of what the picture's edges leave of the slab that the surface moves in, in the camera's view space: all
/// directions to the surface are those of their convex hull. Empty: none of it is in the picture. The eye is not in the
/// slab.
/// @param aspect width / height of the picture
std::vector<vec3> visibleCorners(const WaterBody& water, const Camera& camera, float aspect);

/// The least that waveFilter's footprint can be in a picture, m.
/// @param corners visibleCorners()   @param size of the drawn picture, pixels
float leastFootprint(const WaterBody& water, const Camera& camera, const std::vector<vec3>& corners, ivec2 size);

/// What the slope of a facet can be at most, where no pixel's footprint is less than so many metres. Waves that pixels
/// show add up; those that they do not are facets of a share of their standard deviation (water.frag).
float largestSlope(const WaterBody& water, const Options& options, float footprint);

/// The texels of the reflection's target that an eye above the water can look up. All of them, where no bound is known:
/// steep waves, a normal map, a target for several frames (reflection.interval), an eye near the surface, or one that
/// may see a triangle edge-on with more than one sample of a pixel.
///
/// Let E' be the mirrored eye at the height -H, the water's level 0, and d the eye's ray to a pixel of the water. Every
/// look lies at U + s r, s >= 0 (shaders/passes/mirrored.glsl), so that its direction from E' lies on the arc between
/// those of U - E' and r. Let r0 be d mirrored in the level: the direction in which the mirrored camera sees this
/// pixel.
/// - A facet of slope S turns the mirrored ray from r0 by 2 atan S at most, and where the ray would go down, turning it
/// up
///   brings it nearer.
/// - U lies on the eye's ray at a height h, and tan(elevation of U - E') is (1 + h/H) / (1 - h/H) times that of r0. The
/// two
///   differ most, by asin |h/H|, where the tangent is the root of the inverse of that factor.
/// A cap of less than 90 degrees about r0 holds with two points the arc between them: all looks are within the larger
/// of the two angles of r0. What lies beside the target is looked up at its border, each axis for itself, as bounds
/// are.
///
/// A cap of an angle t about v lies beneath a plane through E' of unit normal m where v·m <= -|v| sin t. The left side
/// less the right is convex in v, so that of all the directions r0 their hull's corners decide.
/// @param size of the drawn picture, pixels
TargetBounds mirrorBounds(const WaterBody& water, const Camera& camera, const Options& options, ivec2 size);

} // namespace tarn
