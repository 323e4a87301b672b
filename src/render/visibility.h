// Which chunks of the scene a view can see.
#pragma once

#include "render/view.h"
#include "scene/mesh_detail.h"
#include "scene/scene.h"

#include <array>
#include <vector>

namespace tarn {

/// One chunk of one instance, ready to draw; or a coarser one that stands for others (scene/mesh_detail.h).
struct Chunk {
    int instance = 0;
    int mesh = 0;
    int material = 0;
    std::uint32_t firstIndex = 0, indexCount = 0;
    Bounds boundsW;
    float error = 0.0f;               ///< DetailNode::error, m in the world; 0: full detail
    std::array<int, 2> finer{-1, -1}; ///< of the same list; -1: none
};

struct Chunks {
    std::vector<Chunk> all;    ///< those of full detail first
    std::size_t full = 0;      ///< how many these are; together they are the scene
    std::vector<int> coarsest; ///< together they are the scene, too; empty: there is only full detail

    const Chunk& operator[](int index) const { return all[static_cast<std::size_t>(index)]; }
};

/// Every chunk of the scene, in world space.
/// @param details of the scene's meshes, or empty: full detail only
Chunks listChunks(const Scene& scene, const std::vector<Instance>& instances,
                  const std::vector<MeshDetail>& details = {});

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

/// How far off the geometry of a chunk may be in a view, m: View::geometryError at the chunk's nearest point. Less
/// where the ground crosses the water's level, since what is off by little in height moves the shore by much, and under
/// it, which water magnifies.
/// @param isUpright cards of plants, which cross the level steeply
float allowedError(const View& view, const Chunk& chunk, const WaterBody* water, bool isUpright);

/// Chunks in the view's frustum, on the kept side of its clip plane and not covered, nearest first (so that the
/// depth test throws most hidden pixels away before they are shaded), alpha-tested ones after the solid ones; each the
/// coarsest that is accurate enough for the view.
/// @param water null: there is none
std::vector<const Chunk*> visibleChunks(const Chunks& chunks, const std::vector<Material>& materials, const View& view,
                                        const WaterCover& cover, bool cull, const WaterBody* water);

/// False only when a view certainly shows nothing of what is within a box.
bool mayShow(const View& view, const WaterCover& cover, const Bounds& boxW);

} // namespace tarn
