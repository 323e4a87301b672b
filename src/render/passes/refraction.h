// The refraction target: colour and depth of what lies on the far side of the water's surface (Mihálik 2008, 5.1); seen
// through a flat surface, also the point that each texel shows.
#pragma once

#include "gl/target.h"
#include "plan/options.h"
#include "render/pass_interface.h"
#include "render/scene_renderer.h"

namespace tarn {

class RefractionPass {
public:
    static PassInterface interface(const FramePlan&)
    {
        return {{Resource::sunDepth, Resource::caustics}, {Resource::refraction}};
    }

    struct Inputs {
        const View& view;
        bool underwater = false; ///< the eye is below the surface: the far side is the air
        vec3 deepRadiance{0.0f}; ///< where there is nothing under water
        bool cull = true;
        SceneVariant variant; ///< how the sun lights what is seen; the pass adds its own
    };

    const gl::Target& draw(SceneRenderer& sceneRenderer, const RefractionOptions& options, const Inputs& inputs,
                           FrameReport::Pass& stats);
    const gl::Target& target() const { return target_; }

private:
    gl::Target target_{"refraction"};
};

} // namespace tarn
