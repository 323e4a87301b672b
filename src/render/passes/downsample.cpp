#include "render/passes/downsample.h"

#include "gl/state.h"

#include <algorithm>
#include <string>

namespace tarn {

namespace {

/// How many texels a pixel's area can touch along one edge: one more than it is long where it begins within one.
int tapsAlong(int drawn, int size) { return drawn % size == 0 ? drawn / size : drawn / size + 2; }

} // namespace

const gl::Target& DownsamplePass::draw(const gl::Target& drawn, ivec2 size)
{
    if (drawn.size() == size) return drawn;
    target_.ensure({.size = size, .colours = {gl::Format::rgba16f}});
    gl::apply({.depthTest = gl::DepthTest::off, .depthWrite = false});
    target_.bind();
    const int taps = std::max(tapsAlong(drawn.size().x, size.x), tapsAlong(drawn.size().y, size.y));
    auto& program = programs_[taps];
    if (!program)
        program = shaders_.program("downsample", "passes/fullscreen.vert", "passes/downsample.frag",
                                   {{"TAPS", std::to_string(taps)}});
    program->use();
    program->texture("drawn", drawn.colour());
    program->set("drawnPerPixel", vec2(drawn.size()) / vec2(size));
    triangle_.draw();
    return target_;
}

} // namespace tarn
