#include "render/passes/sunlight.h"

#include "gl/state.h"
#include "render/passes/refraction.h"

namespace tarn {

bool SunlightPass::isStale(const Inputs& inputs, const SunlightOptions& options) const
{
    return !drawn_ || !(*drawn_ == inputs) || mapSize_ != options.mapSize || format_ != options.depth;
}

void SunlightPass::draw(SunLayer layer, std::size_t cascade, const View& view, ScenePainter& painter,
                        const Inputs& inputs, const SunlightOptions& options, bool cull, FrameStats::Pass& stats)
{
    gl::Target& target = layer == SunLayer::afloat ? afloat_.at(cascade) : submerged_;
    // Photons read the bed between texels; shadow comparisons fetch single ones and filter the answers.
    target.ensure({.size = ivec2(options.mapSize),
                   .colours = {},
                   .depth = glFormat(options.depth),
                   .depthFilter = gl::Filter::linear});
    gl::apply({});
    target.bind();
    target.drawFramebuffer().clearDepth();
    PaintStyle style;
    style.depthOnly = true;
    style.bothSides = true;
    style.sky = false;
    style.dithersCutOuts = inputs.dithersCutOuts;
    painter.draw(view, style, WaterCover{}, cull, stats);
}

void SunlightPass::keep(const Inputs& inputs, const SunlightOptions& options)
{
    drawn_ = inputs;
    mapSize_ = options.mapSize;
    format_ = options.depth;
}

} // namespace tarn
