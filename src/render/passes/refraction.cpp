#include "render/passes/refraction.h"

#include "gl/state.h"
#include "render/depth_format.h"

namespace tarn {

const gl::Target& RefractionPass::draw(SceneRenderer& sceneRenderer, const RefractionOptions& options,
                                       const Inputs& inputs, FrameReport::Pass& stats)
{
    // Depth-buffer values are linear in screen space on any plane, so that filtering them is exact on flat ground and
    // good to second order on a smooth bed.
    const bool isFlat = inputs.view.flatWater.has_value();
    std::vector<gl::Format> colours{gl::Format::rgba16f};
    if (isFlat) colours.push_back(gl::Format::rgba32f);
    target_.ensure({.size = ivec2(options.targetSize),
                    .colours = colours,
                    .depth = glFormat(options.depth),
                    .depthFilter = gl::Filter::linear});
    gl::apply({});
    target_.bind();
    target_.drawFramebuffer().clearColour(vec4(inputs.deepRadiance, 1.0f));
    if (isFlat) target_.drawFramebuffer().clearColour(vec4(0.0f), 1);
    target_.drawFramebuffer().clearDepth();
    SceneVariant variant = inputs.variant;
    variant.throughFlatWater = isFlat;
    variant.depthFirst = false;      // one bed hides little of itself: on the lake its depth costs more than it saves
    variant.sky = inputs.underwater; // in the water the far distance is water
    sceneRenderer.draw(inputs.view, variant, WaterCover{}, inputs.cull, stats);
    return target_;
}

} // namespace tarn
