// What the cameras of a frame may see of the scene: the facts that the plan's rules go by.
#pragma once

#include "optics/blocks.h"
#include "plan/options.h"
#include "plan/visibility_facts.h"
#include "scene/scene.h"

#include <vector>

namespace tarn {

/// The box of one chunk of the scene, and what it is made of.
struct SceneBox {
    Bounds boundsW;
    int material = 0;
};

/// Every chunk of the scene, in world space.
std::vector<SceneBox> listBoxes(const Scene& scene);

/// For an eye above the water; what an eye under it sees, no rule asks for.
/// @param size of the picture, pixels   @param light of the frame (render/frame_light.h)
VisibilityFacts gatherVisibility(const std::vector<SceneBox>& boxes, const Scene& scene, const WaterBody& water,
                                 const Camera& camera, ivec2 size, const Options& options,
                                 const blocks::FrameBlock& light);

} // namespace tarn
