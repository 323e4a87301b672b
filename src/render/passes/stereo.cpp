#include "render/passes/stereo.h"

#include "gl/state.h"

namespace tarn {

namespace {

void copyHalf(Eye eye, const gl::Target& source, gl::Target& beside)
{
    const ivec2 size = source.size();
    beside.ensure({.size = {2 * size.x, size.y}, .colours = {source.desc().colours.front()}});
    source.framebuffer().blitTo(beside.framebuffer(), {.corner = ivec2(eye == Eye::left ? 0 : size.x, 0)});
}

} // namespace

void StereoPass::take(Eye eye, const gl::Target& linear, const gl::Target& display)
{
    copyHalf(eye, linear, linear_);
    copyHalf(eye, display, display_);
}

const gl::Target& StereoPass::drawAnaglyph()
{
    const ivec2 size = display_.size();
    anaglyph_.ensure({.size = {size.x / 2, size.y}, .colours = {gl::Format::rgba8}});
    gl::apply({.depthTest = gl::DepthTest::off, .depthWrite = false});
    anaglyph_.bind();
    if (!program_) program_ = shaders_.program("anaglyph", "passes/fullscreen.vert", "passes/anaglyph.frag");
    program_->use();
    program_->texture("beside", display_.colour());
    triangle_.draw();
    return anaglyph_;
}

} // namespace tarn
