#include "render/passes/debug_copy.h"

#include "gl/state.h"

namespace tarn {

void DebugCopyPass::begin(ivec2 size)
{
    target_.ensure({.size = size, .colours = {gl::Format::rgba32f}});
    gl::apply({.depthTest = gl::DepthTest::off, .depthWrite = false});
    target_.bind();
    target_.drawFramebuffer().clearColour(vec4(0.0f));
}

void DebugCopyPass::copy(gl::Program& program, const gl::Texture& source, ivec2 size, vec2 nearFar)
{
    begin(size);
    program.use();
    program.texture("source", source);
    program.set("nearFar", nearFar);
    triangle_.draw();
}

const gl::Target& DebugCopyPass::colour(const gl::Texture& source, ivec2 size)
{
    if (!colourProgram_)
        colourProgram_ = shaders_.program("debug copy", "passes/fullscreen.vert", "passes/debug_copy.frag");
    copy(*colourProgram_, source, size, vec2(0.0f));
    return target_;
}

const gl::Target& DebugCopyPass::depth(const gl::Texture& source, ivec2 size, float nearPlane, float farPlane)
{
    if (!depthProgram_)
        depthProgram_ =
            shaders_.program("debug copy", "passes/fullscreen.vert", "passes/debug_copy.frag", {{"DEPTH", "1"}});
    copy(*depthProgram_, source, size, {nearPlane, farPlane});
    return target_;
}

const gl::Target& DebugCopyPass::nothing(ivec2 size)
{
    begin(size);
    return target_;
}

} // namespace tarn
