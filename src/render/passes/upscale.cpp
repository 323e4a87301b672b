#include "render/passes/upscale.h"

#include "gl/state.h"

namespace tarn {

gl::Program& UpscalePass::begin(const gl::Target& target, const gl::Texture& source, FrameOptions::Upscaler upscaler,
                                bool isLinear)
{
    gl::apply({.depthTest = gl::DepthTest::off, .depthWrite = false});
    target.bind();
    gl::Defines defines;
    if (upscaler == FrameOptions::Upscaler::edge) defines.emplace_back("EDGE", "1");
    if (isLinear) defines.emplace_back("LINEAR", "1");
    auto& program = programs_[defines];
    if (!program) program = shaders_.program("upscale", "passes/fullscreen.vert", "passes/upscale.frag", defines);
    program->use();
    program->texture("source", source);
    program->set("sourcePerPixel", vec2(source.size()) / vec2(target.size()));
    return *program;
}

const gl::Target& UpscalePass::draw(const gl::Texture& shown, ivec2 size, FrameOptions::Upscaler upscaler)
{
    shown_.ensure({.size = size, .colours = {gl::Format::rgba8}});
    begin(shown_, shown, upscaler, false);
    triangle_.draw();
    return shown_;
}

const gl::Target& UpscalePass::drawLinear(const gl::Texture& radiance, ivec2 size, const FrameOptions& options,
                                          int sideBySide)
{
    linear_.ensure({.size = size, .colours = {gl::Format::rgba16f}});
    gl::Program& program = begin(linear_, radiance, options.upscaler, true);
    program.set("exposure", options.exposure > 0.0f ? options.exposure : 1.0f);
    program.set("sideBySide", sideBySide);
    triangle_.draw();
    return linear_;
}

} // namespace tarn
