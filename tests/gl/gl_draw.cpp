#include "base/error.h"
#include "gl/api.h"
#include "gl/profiler.h"
#include "gl/state.h"
#include "gl/vertex_array.h"
#include "gl_test.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

namespace tarn::gl {
namespace {

/// Quads at chosen depths over a target of 4x1 pixels.
class GlDraw : public testing::Test {
protected:
    struct Vertex {
        vec2 position;
        std::uint8_t colour[4];
    };

    GlDraw()
    {
        folder_.write("quad.vert", "layout(location = 0) in vec2 position;\nlayout(location = 1) in vec4 tint;\n"
                                   "layout(location = 2) in float shift;\n"
                                   "uniform float depth;\nuniform float clip;\nout vec4 tintV;\n"
                                   "void main() { gl_Position = vec4(position.x + shift, position.y, depth, 1.0);\n"
                                   "  gl_ClipDistance[0] = clip; tintV = tint; }\n");
        folder_.write("quad.frag", "in vec4 tintV;\nout vec4 colour;\nvoid main() { colour = tintV; }\n");
        program_ = library_.program("quad", "quad.vert", "quad.frag");
        program_->set("clip", 1.0f);
        target_.ensure({.size = {4, 1}, .colours = {Format::rgba32f}, .depth = Format::depth32f});
        // A column one pixel wide at the left edge: counter-clockwise.
        const std::array<Vertex, 4> vertices = {Vertex{{-1.0f, -1.0f}, {255, 0, 51, 255}},
                                                {{-0.5f, -1.0f}, {255, 0, 51, 255}},
                                                {{-0.5f, 1.0f}, {255, 0, 51, 255}},
                                                {{-1.0f, 1.0f}, {255, 0, 51, 255}}};
        vertices_.upload(std::span<const Vertex>(vertices));
        indices_.upload(std::span<const std::uint32_t>(std::array<std::uint32_t, 6>{0, 1, 2, 0, 2, 3}));
        shifts_.upload(std::span<const float>(std::array<float, 4>{0.0f, 0.5f, 1.0f, 1.5f}));
        quad_.attributes(
            vertices_, sizeof(Vertex),
            {{0, 2, offsetof(Vertex, position)}, {1, 4, offsetof(Vertex, colour), Attribute::Type::unorm8}});
        quad_.attributes(shifts_, sizeof(float), {{2, 1, 0}}, 1);
        quad_.indices(indices_);
        start();
    }

    void start()
    {
        target_.bind();
        target_.drawFramebuffer().clearColour(vec4(0.0f));
        target_.drawFramebuffer().clearDepth();
        program_->use();
    }

    /// Red of the four pixels.
    std::array<float, 4> reds() const
    {
        const std::vector<float> v = target_.framebuffer().readFloats();
        return {v[0], v[4], v[8], v[12]};
    }

    test::ShaderFolder folder_;
    ShaderLibrary library_{folder_.root()};
    std::shared_ptr<Program> program_;
    Target target_{"pixels"};
    Buffer vertices_{"vertices"}, indices_{"indices"}, shifts_{"shifts"};
    VertexArray quad_{"quad"};
};

using Reds = std::array<float, 4>;

TEST_F(GlDraw, IndexedInstancedAndInRanges)
{
    apply({});
    quad_.drawIndexed(Primitive::triangles, 0, 6);
    EXPECT_EQ(reds(), (Reds{1, 0, 0, 0}));
    const std::vector<float> values = target_.framebuffer().readFloats();
    EXPECT_FLOAT_EQ(values[2], 0.2f) << "bytes arrive as 0 to 1";

    start();
    quad_.drawIndexed(Primitive::triangles, 0, 6, 3);
    EXPECT_EQ(reds(), (Reds{1, 1, 1, 0}));

    start();
    quad_.drawIndexed(Primitive::triangles, std::array{IndexRange{0, 3}, IndexRange{3, 3}});
    EXPECT_EQ(reds(), (Reds{1, 0, 0, 0}));
    EXPECT_NO_THROW(quad_.drawIndexed(Primitive::triangles, std::span<const IndexRange>()));

    start();
    quad_.draw(Primitive::triangles, 0, 3, 4);
    EXPECT_EQ(target_.framebuffer().readDepth().size(), 4u);
}

TEST_F(GlDraw, DepthTestAndWrites)
{
    apply({.depthWrite = false});
    program_->set("depth", -0.5f);
    quad_.drawIndexed(Primitive::triangles, 0, 6);
    EXPECT_EQ(target_.framebuffer().readDepth()[0], 1.0f) << "not written";
    apply({});
    quad_.drawIndexed(Primitive::triangles, 0, 6);
    EXPECT_EQ(target_.framebuffer().readDepth()[0], 0.25f);
    program_->set("depth", 0.5f);
    quad_.drawIndexed(Primitive::triangles, 0, 6);
    EXPECT_EQ(target_.framebuffer().readDepth()[0], 0.25f) << "behind";
    apply({.depthTest = DepthTest::always});
    quad_.drawIndexed(Primitive::triangles, 0, 6);
    EXPECT_EQ(target_.framebuffer().readDepth()[0], 0.75f);
}

TEST_F(GlDraw, CullingAndWinding)
{
    apply({.cull = Cull::front});
    quad_.drawIndexed(Primitive::triangles, 0, 6);
    EXPECT_EQ(reds(), (Reds{0, 0, 0, 0}));
    apply({.cull = Cull::back, .clockwiseFront = true});
    quad_.drawIndexed(Primitive::triangles, 0, 6);
    EXPECT_EQ(reds(), (Reds{0, 0, 0, 0}));
    apply({.cull = Cull::back});
    quad_.drawIndexed(Primitive::triangles, 0, 6);
    EXPECT_EQ(reds(), (Reds{1, 0, 0, 0}));
}

TEST_F(GlDraw, ClipDistancesAndColourMask)
{
    program_->set("clip", -1.0f);
    apply({.clipDistances = 1});
    quad_.drawIndexed(Primitive::triangles, 0, 6);
    EXPECT_EQ(reds(), (Reds{0, 0, 0, 0})) << "clipped";
    program_->set("clip", 1.0f);
    apply({.colourWrite = false});
    quad_.drawIndexed(Primitive::triangles, 0, 6);
    EXPECT_EQ(reds(), (Reds{0, 0, 0, 0})) << "masked";
    EXPECT_EQ(target_.framebuffer().readDepth()[0], 0.5f) << "but drawn";
}

TEST_F(GlDraw, BlendingAdds)
{
    apply({.depthTest = DepthTest::always, .blend = Blend::add});
    quad_.drawIndexed(Primitive::triangles, 0, 6);
    quad_.drawIndexed(Primitive::triangles, 0, 6);
    EXPECT_EQ(reds(), (Reds{2, 0, 0, 0}));
    apply({.depthTest = DepthTest::always});
    quad_.drawIndexed(Primitive::triangles, 0, 6);
    EXPECT_EQ(reds(), (Reds{1, 0, 0, 0})) << "the next state does not inherit it";
}

TEST_F(GlDraw, SrgbTargetsEncodeWhenAsked)
{
    target_.ensure({.size = {4, 1}, .colours = {Format::srgb8a8}});
    target_.bind();
    apply({.srgbEncode = true});
    target_.drawFramebuffer().clearColour(vec4(0.0f));
    program_->use();
    quad_.drawIndexed(Primitive::triangles, 0, 6);
    // 0.2 is 0.4845 in sRGB (IEC 61966-2-1).
    EXPECT_NEAR(target_.colour().readBack()[2], 1.055f * std::pow(0.2f, 1.0f / 2.4f) - 0.055f, 0.003f);
    apply({});
    quad_.drawIndexed(Primitive::triangles, 0, 6);
    EXPECT_NEAR(target_.colour().readBack()[2], 0.2f, 0.003f);
}

TEST_F(GlDraw, ProfilerNamesPassesInOrderAndAddsUp)
{
    Profiler profiler;
    profiler.setSynchronous(true);
    EXPECT_TRUE(profiler.latest().empty());
    for (int frame = 0; frame < 3; ++frame) {
        profiler.beginFrame();
        for (const char* name : {"scene", "water", "scene"}) {
            const PassScope pass(profiler, name);
            apply({});
            quad_.drawIndexed(Primitive::triangles, 0, 6);
        }
        profiler.endFrame();
    }
    const std::vector<PassTime>& passes = profiler.latest();
    ASSERT_EQ(passes.size(), 3u);
    EXPECT_EQ(passes[0].name, "frame");
    EXPECT_EQ(passes[1].name, "scene");
    EXPECT_EQ(passes[2].name, "water");
    for (const PassTime& pass : passes) {
        EXPECT_GE(pass.gpuMs, 0.0) << pass.name;
        EXPECT_GT(pass.wallMs, 0.0) << pass.name;
        EXPECT_GE(pass.cpuMs, 0.0) << pass.name;
    }
    EXPECT_GE(passes[0].wallMs, passes[1].wallMs + passes[2].wallMs) << "the frame holds its passes";
}

TEST_F(GlDraw, ProfilerGetsResultsWithoutWaiting)
{
    Profiler profiler;
    for (int frame = 0; frame < 20 && profiler.latest().empty(); ++frame) {
        profiler.beginFrame();
        {
            const PassScope pass(profiler, "scene");
            quad_.drawIndexed(Primitive::triangles, 0, 6);
        }
        profiler.endFrame();
        glFinish(); // a frame's worth of time passes
    }
    ASSERT_EQ(profiler.latest().size(), 2u);
    EXPECT_EQ(profiler.latest()[1].name, "scene");
}

TEST_F(GlDraw, ProfilerSurvivesAFrameCutShort)
{
    Profiler profiler;
    profiler.setSynchronous(true);
    try {
        profiler.beginFrame();
        const PassScope pass(profiler, "scene");
        throw Error("a pass failed");
    } catch (const Error&) {
        profiler.beginFrame();
        profiler.endFrame();
    }
    { // work between frames is named for debuggers and not timed
        const PassScope loading(profiler, "loading");
    }
    ASSERT_EQ(profiler.latest().size(), 1u);
    EXPECT_EQ(profiler.latest()[0].name, "frame");
    GLint depth = 0;
    glGetIntegerv(GL_DEBUG_GROUP_STACK_DEPTH, &depth);
    EXPECT_EQ(depth, 1) << "every debug group is closed";
}

} // namespace
} // namespace tarn::gl
