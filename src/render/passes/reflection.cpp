#include "render/passes/reflection.h"

#include "gl/state.h"

namespace tarn {

const gl::Target& ReflectionPass::draw(SceneRenderer& sceneRenderer, const ReflectionOptions& options,
                                       const Inputs& inputs, FrameReport::Pass& stats)
{
    target_.ensure({.size = ivec2(options.targetSize), .colours = {gl::Format::rgba16f}, .depth = gl::Format::depth24});
    gl::apply({});
    target_.bind();
    target_.drawFramebuffer().clearColour(vec4(0.0f));
    target_.drawFramebuffer().clearDepth();
    SceneVariant variant = inputs.variant;
    variant.underwaterEye = inputs.underwater;
    if (const TargetBounds& bounds = inputs.view.lookedUp; !bounds.isWhole()) {
        const auto texel = [&](vec2 at) { return ivec2(glm::round((0.5f * at + 0.5f) * vec2(target_.size()))); };
        variant.scissor = gl::PixelRect{texel(bounds.lower), texel(bounds.upper) - texel(bounds.lower)};
    }
    sceneRenderer.draw(inputs.view, variant, WaterCover{}, inputs.cull, stats);
    return target_;
}

} // namespace tarn
