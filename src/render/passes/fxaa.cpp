#include "render/passes/fxaa.h"

#include "gl/state.h"

namespace tarn {

const gl::Target& FxaaPass::draw(const gl::Texture& shown)
{
    target_.ensure({.size = shown.size(), .colours = {gl::Format::rgba8}});
    gl::apply({.depthTest = gl::DepthTest::off, .depthWrite = false});
    target_.bind();
    if (!program_) program_ = shaders_.program("fxaa", "passes/fullscreen.vert", "passes/fxaa.frag");
    program_->use();
    program_->texture("source", shown);
    triangle_.draw();
    return target_;
}

} // namespace tarn
