#include "render/passes/downsample.h"

#include "gl/state.h"

namespace tarn {

const gl::Target& DownsamplePass::draw(const gl::Target& drawn, ivec2 size)
{
    if (drawn.size() == size) return drawn;
    target_.ensure({.size = size, .colours = {gl::Format::rgba16f}});
    gl::apply({.depthTest = gl::DepthTest::off, .depthWrite = false});
    target_.bind();
    if (!program_)
        program_ = shaders_.program("downsample", "passes/fullscreen.vert", "passes/downsample.frag");
    program_->use();
    program_->texture("drawn", drawn.colour());
    program_->set("edge", drawn.size().x / size.x);
    triangle_.draw();
    return target_;
}

} // namespace tarn
