// The reflection target: what the mirrored camera sees on the eye's side of the water's surface (Mihálik 2008, 5.2).
#pragma once

#include "gl/target.h"
#include "plan/options.h"
#include "render/pass_interface.h"
#include "render/scene_renderer.h"

namespace tarn {

class ReflectionPass {
public:
    static PassInterface interface(const FramePlan&)
    {
        return {{Resource::sunDepth, Resource::caustics}, {Resource::reflection}};
    }

    struct Inputs {
        const View& view;
        bool underwater = false; ///< the eye is below the surface, which mirrors the bed
        bool cull = true;
        SceneVariant variant; ///< how the sun lights what is seen; the pass adds its own
    };

    const gl::Target& draw(SceneRenderer& sceneRenderer, const ReflectionOptions& options, const Inputs& inputs,
                           FrameReport::Pass& stats);
    const gl::Target& target() const { return target_; }

private:
    gl::Target target_{"reflection"};
};

} // namespace tarn
