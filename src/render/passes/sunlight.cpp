#include "render/passes/sunlight.h"

#include "gl/state.h"
#include "render/depth_format.h"

namespace tarn {

bool SunlightPass::isStale(const Inputs& inputs, const SunlightOptions& options) const
{
    return !drawn_ || !(*drawn_ == inputs) || mapSize_ != options.mapSize || format_ != options.depth;
}

void SunlightPass::ensureLayers(const SunlightOptions& options, std::size_t cascades)
{
    // Photons read the bed between texels; shadow comparisons fetch single ones and filter the answers.
    const gl::TextureDesc desc{.kind = gl::TextureKind::array,
                               .format = glFormat(options.depth),
                               .size = ivec2(options.mapSize),
                               .layers = 1 + static_cast<int>(cascades),
                               .filter = gl::Filter::linear};
    if (depth_ && depth_.desc() == desc) return;
    layers_.clear();
    depth_ = gl::Texture(desc, "sunlight depth");
    for (int layer = 0; layer < desc.layers; ++layer)
        layers_.emplace_back("sunlight", std::initializer_list<gl::Attachment>{{depth_, 0, layer}});
}

void SunlightPass::draw(SunLayer layer, std::size_t cascade, const View& view, SceneRenderer& sceneRenderer,
                        const Inputs& inputs, const SunlightOptions& options, bool cull, FrameReport::Pass& stats)
{
    ensureLayers(options, inputs.volume.cascades.size());
    const gl::Framebuffer& target = layers_.at(layer == SunLayer::submerged ? 0 : 1 + cascade);
    gl::apply({});
    target.bind();
    target.clearDepth();
    SceneVariant variant;
    variant.depthOnly = true;
    variant.bothSides = true;
    variant.sky = false;
    variant.dithersCutOuts = inputs.dithersCutOuts;
    sceneRenderer.draw(view, variant, WaterCover{}, cull, stats);
}

void SunlightPass::keep(const Inputs& inputs, const SunlightOptions& options)
{
    drawn_ = inputs;
    mapSize_ = options.mapSize;
    format_ = options.depth;
}

} // namespace tarn
