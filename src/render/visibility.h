// Which chunks of the scene a view can see.
#pragma once

#include "render/view.h"
#include "scene/scene.h"

#include <vector>

namespace tarn {

/// One chunk of one instance, ready to draw.
struct Chunk {
    int instance = 0;
    int mesh = 0;
    int material = 0;
    std::uint32_t firstIndex = 0, indexCount = 0;
    Bounds boundsW;
};

/// Every chunk of the scene, in world space.
std::vector<Chunk> listChunks(const Scene& scene, const std::vector<Instance>& instances);

/// What lies round a chunk, at rest: whether scene.frag must ask for each pixel.
enum class Medium { air, water, both };

/// @param rim how far beside its rectangle the water wets what touches it, m (scene.frag)
Medium mediumOf(const Bounds& boundsW, const WaterBody& water, float rim);

/// The slab in which an opaque water surface moves; nothing wholly behind it can be seen.
struct WaterCover {
    bool active = false;
    vec2 lower{0.0f}, upper{0.0f}; ///< its rectangle, x and z
    float lowest = 0.0f, highest = 0.0f;

    /// True when every ray from the eye, which is above the surface, to the box meets the surface first.
    bool hides(const vec3& eye, const Bounds& box) const;
};
WaterCover waterCover(const WaterBody& water);

/// Chunks in the view's frustum, on the kept side of its clip plane and not covered, nearest first (so that the
/// depth test throws most hidden pixels away before they are shaded), alpha-tested ones after the solid ones.
std::vector<const Chunk*> visibleChunks(const std::vector<Chunk>& chunks, const std::vector<Material>& materials,
                                        const View& view, const WaterCover& cover, bool cull);

/// False only when a view certainly shows nothing of what is within a box.
bool mayShow(const View& view, const WaterCover& cover, const Bounds& boxW);

} // namespace tarn
