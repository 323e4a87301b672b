// The scene without its water, from the main camera, into the frame's HDR target.
#pragma once

#include "gl/target.h"
#include "render/pass_interface.h"
#include "render/scene_renderer.h"

namespace tarn {

class ScenePass {
public:
    static PassInterface interface(const FramePlan&)
    {
        return {{Resource::sunDepth, Resource::caustics},
                {Resource::sceneColour, Resource::sceneDepth, Resource::waterline}};
    }

    struct Inputs {
        const View& view;
        SceneVariant variant;
        WaterCover cover; ///< what the water, drawn later, will hide
        bool cull = true;
    };

    /// Clears the target and draws into it.
    void draw(SceneRenderer& sceneRenderer, const gl::Target& frame, const Inputs& inputs,
              FrameReport::Pass& stats) const;
};

} // namespace tarn
