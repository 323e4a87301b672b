#include "gl/state.h"

#include "gl/api.h"
#include "gl/counters.h"

#include <array>

namespace tarn::gl {

namespace {

thread_local WriteMasks masks; // as OpenGL's own state, of the context that is current in this thread

void enable(GLenum what, bool on)
{
    if (on)
        glEnable(what);
    else
        glDisable(what);
}

void applyDepth(const State& state)
{
    constexpr std::array<GLenum, 6> functions = {GL_ALWAYS, GL_LESS, GL_LEQUAL, GL_EQUAL, GL_ALWAYS, GL_GREATER};
    enable(GL_DEPTH_TEST, state.depthTest != DepthTest::off);
    glDepthFunc(functions[static_cast<std::size_t>(state.depthTest)]);
    glDepthMask(state.depthWrite ? GL_TRUE : GL_FALSE);
    enable(GL_DEPTH_CLAMP, state.depthClamp);
    enable(GL_POLYGON_OFFSET_FILL, state.depthOffset != vec2(0.0f));
    glPolygonOffset(state.depthOffset.x, state.depthOffset.y);
}

void applyFaces(const State& state)
{
    enable(GL_CULL_FACE, state.cull != Cull::none);
    glCullFace(state.cull == Cull::front ? GL_FRONT : GL_BACK);
    glFrontFace(state.clockwiseFront ? GL_CW : GL_CCW);
    glPolygonMode(GL_FRONT_AND_BACK, state.wireframe ? GL_LINE : GL_FILL);
    constexpr int guaranteed = 8; // GL_MAX_CLIP_DISTANCES is at least this
    for (int i = 0; i < guaranteed; ++i) {
        enable(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i), i < state.clipDistances);
    }
}

void applyBlend(const State& state)
{
    enable(GL_BLEND, state.blend != Blend::none);
    glBlendEquation(GL_FUNC_ADD);
    switch (state.blend) {
    case Blend::none: glBlendFunc(GL_ONE, GL_ZERO); break;
    case Blend::alpha: glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA); break;
    case Blend::premultiplied: glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA); break;
    case Blend::add: glBlendFunc(GL_ONE, GL_ONE); break;
    }
}

} // namespace

void apply(const State& state)
{
    masks = {state.colourWrite, state.depthWrite};
    count(Call::stateChange);
    applyDepth(state);
    applyFaces(state);
    applyBlend(state);
    const GLboolean colour = state.colourWrite ? GL_TRUE : GL_FALSE;
    glColorMask(colour, colour, colour, colour);
    enable(GL_FRAMEBUFFER_SRGB, state.srgbEncode);
    enable(GL_SAMPLE_ALPHA_TO_COVERAGE, state.alphaToCoverage);
    enable(GL_PROGRAM_POINT_SIZE, state.shaderPointSize);
    glEnable(GL_MULTISAMPLE);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    enable(GL_SCISSOR_TEST, state.scissor.has_value());
    if (const auto& rect = state.scissor) glScissor(rect->lower.x, rect->lower.y, rect->size.x, rect->size.y);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_DITHER);
}

WriteMasks writeMasks() { return masks; }

} // namespace tarn::gl
