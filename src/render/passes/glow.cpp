#include "render/passes/glow.h"

#include "gl/state.h"
#include "render/unrolled.h"

#include <optional>

namespace tarn {

gl::Program& GlowPass::highlightProgram(const WaterOptions& options, const Inputs& inputs)
{
    gl::Defines defines{eachWave(inputs.waveCount)};
    if (options.filterWaves) defines.emplace_back("FILTER_WAVES", "1");
    if (options.normals == WaterOptions::Normals::vertex) defines.emplace_back("VERTEX_NORMALS", "1");
    if (inputs.normalMap) defines.emplace_back("NORMAL_MAP", "1");
    addSurfaceSteps(defines, options.surfaceSteps);
    auto& program = programs_[defines];
    if (!program) program = shaders_.program("glow", "passes/water.vert", "passes/glow.frag", defines);
    return *program;
}

const gl::Target& GlowPass::draw(WaterGrid& grid, const Options& options, const Inputs& inputs,
                                 FrameReport::Pass& stats)
{
    highlight_.ensure({.size = inputs.size, .colours = {gl::Format::rgba16f}});
    gl::apply({.depthTest = gl::DepthTest::off, .depthWrite = false});
    highlight_.bind();
    highlight_.drawFramebuffer().clearColour(vec4(0.0f));
    gl::Program& p = highlightProgram(options.water, inputs);
    p.use();
    p.texture("sceneDepth", inputs.sceneDepth);
    p.set("glowColour", options.glow.strength * options.glow.colour);
    p.set("glowExponent", options.glow.exponent);
    p.set("footprint", 1.0f);
    if (inputs.normalMap) inputs.normalMap.set(p);
    {
        std::optional<gl::VisibilityQuery::Condition>
            condition; // not of the clear: what an earlier frame left would glow
        if (inputs.ifSeen) condition.emplace(*inputs.ifSeen);
        grid.draw(options.water.gridSize, stats);
    }
    return blur(highlight_.colour());
}

const gl::Target& GlowPass::blur(const gl::Texture& source)
{
    if (!blurProgram_) blurProgram_ = shaders_.program("glow blur", "passes/fullscreen.vert", "passes/glow_blur.frag");
    blurred_.ensure({.size = source.size(), .colours = {gl::Format::rgba16f}});
    gl::apply({.depthTest = gl::DepthTest::off, .depthWrite = false});
    blurred_.bind();
    blurProgram_->use();
    blurProgram_->texture("source", source);
    triangle_.draw();
    return blurred_;
}

} // namespace tarn
