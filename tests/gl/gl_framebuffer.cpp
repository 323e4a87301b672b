#include "gl/framebuffer.h"

#include "base/error.h"
#include "gl/api.h"
#include "gl/state.h"
#include "gl/target.h"
#include "gl/vertex_array.h"
#include "gl_test.h"

#include <gtest/gtest.h>

namespace tarn::gl {
namespace {

/// The message of the Error that building the framebuffer throws.
std::string complaint(std::span<const Attachment> attachments)
{
    try {
        const Framebuffer framebuffer("reflection", attachments);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(GlFramebuffer, BadCombinationsAreNamed)
{
    const Texture colour({.format = Format::rgba16f, .size = {8, 8}}, "mirrored");
    const Texture small({.format = Format::depth24, .size = {4, 8}}, "depth of old size");
    const Texture depth({.format = Format::depth24, .size = {8, 8}}, "depth");
    const Renderbuffer samples(Format::depth24, {8, 8}, 4, "samples");

    EXPECT_EQ(complaint({}),
              "framebuffer \"reflection\" cannot be drawn into: it has no attachment (attachments: none)");
    EXPECT_EQ(complaint(std::vector<Attachment>{colour, small}),
              "framebuffer \"reflection\" cannot be drawn into: the attachments differ in size (attachments: "
              "\"mirrored\" rgba16f 8x8, \"depth of old size\" depth24 4x8)");
    EXPECT_EQ(complaint(std::vector<Attachment>{colour, samples}),
              "framebuffer \"reflection\" cannot be drawn into: the attachments differ in samples (attachments: "
              "\"mirrored\" rgba16f 8x8, \"samples\" depth24 8x8 4 samples)");
    EXPECT_NE(complaint(std::vector<Attachment>{depth, depth}).find("two depth attachments"), std::string::npos);
    EXPECT_EQ(complaint(std::vector<Attachment>{colour, depth}), "");
}

TEST(GlFramebuffer, EveryFormatCanBeDrawnInto)
{
    for (int i = 0; i <= static_cast<int>(Format::depth32f); ++i) {
        const auto format = static_cast<Format>(i);
        const Texture texture({.format = format, .size = {4, 4}, .filter = Filter::nearest}, formatName(format));
        const Framebuffer framebuffer(formatName(format), {texture});
        if (isDepth(format))
            framebuffer.clearDepth(0.5f);
        else
            framebuffer.clearColour(vec4(0.5f));
        EXPECT_NEAR(texture.readBack().front(), 0.5f, 0.003f) << formatName(format);
    }
}

TEST(GlFramebuffer, ClearsOneOutputWhateverTheMasksAre)
{
    const Texture first({.format = Format::rgba32f, .size = {2, 2}}, "first");
    const Texture second({.format = Format::rgba32f, .size = {2, 2}}, "second");
    const Texture depth({.format = Format::depth32f, .size = {2, 2}}, "depth");
    const Framebuffer framebuffer("two outputs", {first, second, depth});
    framebuffer.clearColour(vec4(1, 2, 3, 4), 0);
    framebuffer.clearColour(vec4(5, 6, 7, 8), 1);
    apply({.depthWrite = false, .colourWrite = false});
    framebuffer.clearColour(vec4(-1.0f), 1);
    framebuffer.clearDepth(0.125f);
    GLboolean mask = GL_TRUE;
    glGetBooleanv(GL_DEPTH_WRITEMASK, &mask);
    EXPECT_EQ(mask, GL_FALSE) << "the mask is put back";

    EXPECT_EQ(framebuffer.readFloats(0), (std::vector<float>{1, 2, 3, 4, 1, 2, 3, 4, 1, 2, 3, 4, 1, 2, 3, 4}));
    EXPECT_EQ(framebuffer.readFloats(1), std::vector<float>(16, -1.0f));
    EXPECT_EQ(framebuffer.readDepth(), std::vector<float>(4, 0.125f));
    EXPECT_THROW(framebuffer.readFloats(2), Error);
    apply({});
}

TEST(GlFramebuffer, BytesAreClamped)
{
    const Texture texture({.format = Format::rgba8, .size = {1, 1}}, "bytes");
    const Framebuffer framebuffer("bytes", {texture});
    framebuffer.clearColour(vec4(0.0f, 0.5f, 1.0f, 9.0f));
    const std::vector<std::uint8_t> values = framebuffer.readBytes();
    EXPECT_EQ(values[0], 0);
    EXPECT_NEAR(values[1], 128, 1);
    EXPECT_EQ(values[2], 255);
    EXPECT_EQ(values[3], 255);
}

TEST(GlFramebuffer, BlitsTheChosenOutputAndStretches)
{
    const Texture a0({.format = Format::rgba32f, .size = {2, 2}}, "a0");
    const Texture a1({.format = Format::rgba32f, .size = {2, 2}}, "a1");
    const Texture b0({.format = Format::rgba32f, .size = {4, 4}}, "b0");
    const Texture b1({.format = Format::rgba32f, .size = {4, 4}}, "b1");
    const Framebuffer a("a", {a0, a1});
    const Framebuffer b("b", {b0, b1});
    a.clearColour(vec4(1.0f), 0);
    a.clearColour(vec4(2.0f), 1);
    b.clearColour(vec4(0.0f), 0);
    b.clearColour(vec4(0.0f), 1);
    a.blitTo(b, {.output = 1});
    EXPECT_EQ(b.readFloats(0), std::vector<float>(64, 0.0f)) << "the other output stays";
    EXPECT_EQ(b.readFloats(1), std::vector<float>(64, 2.0f));
    b.bind();
    b.clearColour(vec4(3.0f), 0);
    EXPECT_EQ(b.readFloats(0), std::vector<float>(64, 3.0f)) << "all outputs are enabled again";
}

TEST(GlFramebuffer, BindSetsTheViewport)
{
    const Texture texture({.format = Format::r8, .size = {7, 5}}, "odd");
    Framebuffer("odd", {texture}).bind();
    GLint viewport[4] = {};
    glGetIntegerv(GL_VIEWPORT, viewport);
    EXPECT_EQ(ivec4(viewport[0], viewport[1], viewport[2], viewport[3]), ivec4(0, 0, 7, 5));
}

TEST(GlTarget, IsRebuiltOnlyWhenItChanges)
{
    Target target("scene");
    EXPECT_FALSE(target);
    TargetDesc desc{.size = {16, 8}, .colours = {Format::rgba16f}, .depth = Format::depth24};
    EXPECT_TRUE(target.ensure(desc));
    const Name name = target.colour().name();
    EXPECT_FALSE(target.ensure(desc));
    EXPECT_EQ(target.colour().name(), name);
    desc.samples = 10000; // more than there are: capped, and not rebuilt each frame because of that
    EXPECT_TRUE(target.ensure(desc));
    EXPECT_FALSE(target.ensure(desc));
    EXPECT_GT(target.samples(), 1);
    EXPECT_LT(target.samples(), 10000);
    desc.size = {8, 8};
    EXPECT_TRUE(target.ensure(desc));
    EXPECT_EQ(target.colour().size(), ivec2(8, 8));
    EXPECT_EQ(target.depth().size(), ivec2(8, 8));
}

TEST(GlTarget, BadOneSaysWhichAndCanBeMended)
{
    Target target("caustics");
    try {
        target.ensure({.size = {8, 0}, .colours = {Format::r16f}});
        FAIL() << "a target without pixels";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "texture \"caustics colour 0\" (r16f 8x0): it has no pixels");
    }
    EXPECT_FALSE(target);
    EXPECT_TRUE(target.ensure({.size = {8, 8}, .colours = {Format::r16f}}));
}

TEST(GlTarget, ResolvesSamplesOfAllOutputsAndDepth)
{
    Target target("msaa");
    target.ensure(
        {.size = {4, 4}, .colours = {Format::rgba16f, Format::rg32f}, .depth = Format::depth32f, .samples = 4});
    ASSERT_TRUE(target.isMultisampled());
    target.drawFramebuffer().clearColour(vec4(0.25f, 0.5f, 1.0f, 2.0f), 0);
    target.drawFramebuffer().clearColour(vec4(-3.0f, 4.0f, 0.0f, 0.0f), 1);
    target.drawFramebuffer().clearDepth(0.75f);
    target.resolve();
    EXPECT_EQ(target.colour(0).readBack()[3], 2.0f);
    EXPECT_EQ(target.colour(1).readBack()[0], -3.0f);
    EXPECT_EQ(target.colour(1).readBack()[1], 4.0f);
    EXPECT_EQ(target.depth().readBack(), std::vector<float>(16, 0.75f));
    EXPECT_THROW(target.drawFramebuffer().readFloats(), Error) << "samples cannot be read";
}

TEST(GlTarget, ResolvesDepthAlone)
{
    Target target("shadow");
    target.ensure({.size = {4, 4}, .depth = Format::depth24, .samples = 4});
    target.drawFramebuffer().clearDepth(0.5f);
    target.resolve();
    EXPECT_NEAR(target.depth().readBack().back(), 0.5f, 1e-6f);
}

TEST(GlTarget, EdgePixelsAreAveraged)
{
    test::ShaderFolder folder;
    // Covers the left half of the middle pixel column of a 3-wide target.
    folder.write("half.vert", "void main() { vec2 p = vec2(gl_VertexID & 1, gl_VertexID >> 1);\n"
                              "gl_Position = vec4(p.x - 1.0, 2.0 * p.y - 1.0, 0.0, 1.0); }\n");
    folder.write("white.frag", "out vec4 colour;\nvoid main() { colour = vec4(1.0); }\n");
    ShaderLibrary library(folder.root());
    const auto program = library.program("half", "half.vert", "white.frag");
    Target target("edge");
    target.ensure({.size = {3, 1}, .colours = {Format::rgba32f}, .samples = 4});
    target.bind();
    target.drawFramebuffer().clearColour(vec4(0.0f));
    apply({.depthTest = DepthTest::off});
    program->use();
    const VertexArray empty("strip");
    empty.draw(Primitive::triangleStrip, 0, 4);
    target.resolve();
    const std::vector<float> values = target.framebuffer().readFloats();
    EXPECT_EQ(values[0], 1.0f);
    EXPECT_NEAR(values[4], 0.5f, 0.26f);
    EXPECT_GT(values[4], 0.0f);
    EXPECT_LT(values[4], 1.0f);
    EXPECT_EQ(values[8], 0.0f);
}

} // namespace
} // namespace tarn::gl
