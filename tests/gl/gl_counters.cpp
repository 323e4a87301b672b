// Calls of OpenGL are counted where they are made.
#include "gl/counters.h"
#include "gl/framebuffer.h"
#include "gl/state.h"
#include "gl/vertex_array.h"
#include "gl_test.h"

#include <gtest/gtest.h>

#include <thread>

namespace tarn::gl {
namespace {

TEST(GlCounters, CountEachKindOfCall)
{
    test::ShaderFolder folder;
    folder.write("full.vert", test::fullscreenVertex);
    folder.write("tint.frag", "uniform float tint;\nuniform sampler2D picture;\nout vec4 colour;\n"
                              "void main() { colour = tint * texture(picture, vec2(0.5)); }\n");
    ShaderLibrary library(folder.root());
    const auto program = library.program("tint", "full.vert", "tint.frag");
    program->set("tint", 0.5f);
    const Texture texture({}, "picture");
    Target target("pixels");
    target.ensure({.size = {2, 2}, .colours = {Format::rgba8}, .depth = Format::depth24});
    const FullscreenTriangle triangle;

    const Counters before = counters();
    target.bind();
    apply({});
    program->use();
    program->texture("picture", texture);
    triangle.draw();
    program->set("tint", 0.5f); // as it is
    program->set("tint", 0.25f);
    triangle.draw();
    const Counters calls = counters() - before;
    EXPECT_EQ(calls[Call::draw], 2u);
    EXPECT_EQ(calls[Call::programBind], 1u);
    EXPECT_EQ(calls[Call::textureBind], 1u);
    EXPECT_EQ(calls[Call::framebufferBind], 1u);
    EXPECT_EQ(calls[Call::vertexArrayBind], 2u);
    EXPECT_EQ(calls[Call::stateChange], 1u);
    EXPECT_EQ(calls[Call::uniformUpload], 2u) << "the first value, and the one that differs";
    EXPECT_EQ(calls[Call::stateQuery], 0u);
    EXPECT_EQ(calls[Call::readBack], 0u);

    const Counters drawn = counters();
    target.framebuffer().readBytes();
    EXPECT_EQ((counters() - drawn)[Call::readBack], 1u);
}

TEST(GlCounters, EachThreadHasItsOwn)
{
    const Counters before = counters();
    std::thread([] { count(Call::draw); }).join();
    EXPECT_EQ((counters() - before)[Call::draw], 0u);
}

} // namespace
} // namespace tarn::gl
