#include "render/passes/scene_pass.h"

#include "gl/state.h"

namespace tarn {

void ScenePass::draw(SceneRenderer& sceneRenderer, const gl::Target& frame, const Inputs& inputs,
                     FrameReport::Pass& stats) const
{
    gl::apply({});
    frame.bind();
    frame.drawFramebuffer().clearColour(vec4(0.0f));
    frame.drawFramebuffer().clearDepth();
    sceneRenderer.draw(inputs.view, inputs.variant, inputs.cover, inputs.cull, stats);
}

} // namespace tarn
