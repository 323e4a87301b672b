// Which passes a frame runs, and why: a pure function of the scene, the view and the options.
#pragma once

#include "optics/water_grid.h"
#include "plan/lookup_choice.h"
#include "plan/options.h"
#include "plan/visibility_facts.h"
#include "plan/water_bounds.h"
#include "scene/scene.h"

#include <array>
#include <string>

namespace tarn {

/// In the order in which a frame runs them.
enum class PassId { sunlight, caustics, heights, refraction, reflection, scene, water, glow, present };
inline constexpr std::size_t passCount = 9;

/// "refraction", "reflection", … as shown by the profiler, the HUD and `tarn explain`.
const char* passName(PassId pass);

/// What one pass leaves for another, on the graphics card.
enum class Resource {
    sunDepth,          ///< the scene's depth along the sun, layers of an array
    caustics,          ///< irradiance relative to the sun's above the water
    bedHeights,        ///< heights of the bed with its radiance
    aboveWaterHeights, ///< underside and top of what stands over the water, with their radiance
    refraction,        ///< colour and depth from the refraction's camera
    reflection,        ///< colour and depth from the mirrored camera
    sceneColour,       ///< linear radiance of the frame
    sceneDepth,        ///< its depth
    waterline,         ///< which side of the surface each pixel is on
    glow,              ///< blurred highlights of the water
    picture,           ///< as it is shown
};

struct PassPlan {
    bool wanted = false;
    std::string reason; ///< why, or why not, in words
    ivec2 size{0};      ///< of its target, pixels
};

/// Which side of the moving surface a frame shows.
enum class WaterSide {
    above,
    crossing, ///< the surface may cut the near plane: each pixel takes the side that it is on
    below,
};

struct FramePlan {
    std::array<PassPlan, passCount> passes;
    bool underwater = false;           ///< the eye is below the water's surface (and underwater.enabled is on)
    WaterSide side = WaterSide::above; ///< of the near plane, where pictures begin
    optics64::WaterGrid waterGrid{};   ///< that draws the surface
    bool raycastsBed = false, raycastsMirror = false;     ///< from above, through which of the maps of heights
    bool drawsBedMap = false, drawsAboveWaterMap = false; ///< of those maps, which no file gives
    bool targetsBed = true, targetsMirror = true; ///< from above, in which of the targets; from below it is always both

    TargetBounds mirrorBounds; ///< what is drawn of the reflection target; from above

    RuleStates rules; ///< by RuleId: what is left out, and why

    RuleState& rule(RuleId id) { return rules[static_cast<std::size_t>(id)]; }
    const RuleState& rule(RuleId id) const { return rules[static_cast<std::size_t>(id)]; }
    const PassPlan& operator[](PassId pass) const { return passes[static_cast<std::size_t>(pass)]; }
    PassPlan& operator[](PassId pass) { return passes[static_cast<std::size_t>(pass)]; }
};

/// What moves the surface at most: the sum of all amplitudes, m.
float totalAmplitude(const WaterBody& water);

/// The box that holds the moving surface, world space.
Bounds waterBounds(const WaterBody& water);

/// Height of the moving surface over (x, z), world y in metres, at a time in seconds.
float surfaceHeight(const WaterBody& water, vec2 xz, double time);

/// The grid that draws the surface for a camera.
/// @param aspect width / height of the picture
optics64::WaterGrid waterGrid(const WaterBody& water, const WaterOptions& options, const Camera& camera, float aspect);

/// The same height of the surface as a grid draws it.
float drawnHeight(const WaterBody& water, const optics64::WaterGrid& grid, vec2 xz, double time);

/// Where the near plane is, to the safe side: plainly above or below only when the drawn surface cannot cut it.
/// @param aspect width / height of the picture   @param time seconds
WaterSide waterSide(const WaterBody& water, const optics64::WaterGrid& grid, const Camera& camera, float aspect,
                    double time);

/// Of what is drawn for a picture with frame.scale, pixels; at least 1x1.
ivec2 scaledSize(ivec2 picture, const FrameOptions& options);

/// @param camera of one eye, in stereo   @param size of the picture, or of one eye's, pixels   @param time seconds
/// @param complexity what the methods auto go by; null where none is
/// @param visibility what the rules go by; null: nothing is known of what the cameras see
FramePlan planFrame(const Scene& scene, const WaterBody& water, const Camera& camera, const Options& options,
                    ivec2 size, double time, const DepthComplexity* complexity = nullptr,
                    const VisibilityFacts* visibility = nullptr);

} // namespace tarn
