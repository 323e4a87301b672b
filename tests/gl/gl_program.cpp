#include "gl/program.h"

#include "base/error.h"
#include "base/log.h"
#include "gl/buffer.h"
#include "gl_test.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>

namespace tarn::gl {
namespace {

/// A library on a folder of its own, and a short way to a program from the body of a fragment shader.
class GlProgram : public testing::Test {
protected:
    GlProgram() { folder_.write("full.vert", test::fullscreenVertex); }

    std::shared_ptr<Program> make(const std::string& fragment, const Defines& defines = {})
    {
        folder_.write("test.frag", "out vec4 colour;\n" + fragment);
        return library_.program("test", "full.vert", "test.frag", defines);
    }

    /// The message of the Error that the action throws.
    template <typename Action> static std::string complaint(Action action)
    {
        try {
            action();
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }

    test::ShaderFolder folder_;
    ShaderLibrary library_{folder_.root(),
                           {.blocks = {{"ViewBlock", 1}, {"FrameBlock", 2}}, .samplers = {{"pinned", 1}}}};
};

using GlShaderLibrary = GlProgram;

TEST_F(GlProgram, UniformsOfEveryTypeArrive)
{
    const auto program =
        make("uniform bool b; uniform int i; uniform float f; uniform vec2 v2; uniform vec3 v3; uniform vec4 v4;\n"
             "uniform ivec2 i2; uniform ivec3 i3; uniform ivec4 i4; uniform mat3 m3; uniform mat4 m4; uniform "
             "float list[3];\n"
             "void main() { colour = vec4(b ? float(i) + f : -1.0, v2.y + v3.z + v4.w,\n"
             "    float(i2.y + i3.z + i4.w) + m3[2][1] + m4[3][0], list[0] + 10.0 * list[1] + 100.0 * list[2]); "
             "}\n");
    program->set("b", true);
    program->set("i", 3);
    program->set("f", 0.5f);
    program->set("v2", vec2(9, 1));
    program->set("v3", vec3(9, 9, 2));
    program->set("v4", vec4(9, 9, 9, 4));
    program->set("i2", ivec2(9, 1));
    program->set("i3", ivec3(9, 9, 2));
    program->set("i4", ivec4(9, 9, 9, 4));
    mat3 m3(0.0f);
    m3[2][1] = 0.25f;
    program->set("m3", m3);
    program->set("m4", glm::translate(mat4(1.0f), vec3(8, 9, 9)));
    program->setArray<float>("list", std::array{1.0f, 2.0f, 3.0f});
    EXPECT_EQ(test::evaluate(*program), vec4(3.5f, 7.0f, 15.25f, 321.0f));
}

TEST_F(GlProgram, ValuesMayBeSetBeforeOrAfterUseAndStay)
{
    const auto program = make("uniform float a; uniform float b;\nvoid main() { colour = vec4(a, b, 0.0, 1.0); }\n");
    const auto other = library_.program("other", "full.vert", "test.frag");
    const Uniform<float> a = program->uniform<float>("a");
    a.set(1.0f);
    program->use();
    program->set("b", 2.0f);
    EXPECT_EQ(test::evaluate(*program), vec4(1, 2, 0, 1));
    EXPECT_EQ(test::evaluate(*other), vec4(0, 0, 0, 1)) << "another program has values of its own";
    a.set(3.0f); // while the other one is in use
    EXPECT_EQ(test::evaluate(*program), vec4(3, 2, 0, 1));
}

TEST_F(GlProgram, WrongTypesAndLengthsAreErrors)
{
    const auto program = make("uniform vec3 tint; uniform float list[2];\n"
                              "void main() { colour = vec4(tint, list[0] + list[1]); }\n");
    EXPECT_EQ(complaint([&] { program->set("tint", 1.0f); }),
              "program \"test\": uniform tint is declared with another type than the float it is set to");
    EXPECT_EQ(complaint([&] {
                  program->setArray<float>("list", std::array{1.0f, 2.0f, 3.0f});
              }),
              "program \"test\": uniform list has 2 elements and is set to 3");
}

TEST_F(GlProgram, UnusedUniformsAreNotedOnce)
{
    const auto program = make("void main() { colour = vec4(1.0); }\n");
    log::setLevel(log::Level::debug);
    const log::Capture capture;
    for (int frame = 0; frame < 3; ++frame) program->set("exposre", 1.0f);
    log::setLevel(log::Level::info);
    ASSERT_EQ(capture.messages().size(), 1u);
    EXPECT_EQ(capture.messages().front().text, "program \"test\" does not use a uniform exposre");
}

TEST_F(GlProgram, SamplersGetUnitsOfTheirOwn)
{
    const auto program = make("uniform sampler2D alpha; uniform sampler2D beta; uniform sampler2D pinned;\n"
                              "void main() { vec2 p = vec2(0.5); colour = vec4(texture(alpha, p).r,\n"
                              "    texture(beta, p).r, texture(pinned, p).r, 1.0); }\n");
    EXPECT_EQ(program->samplerUnit("pinned"), 1) << "from the table";
    EXPECT_EQ(program->samplerUnit("alpha"), 0);
    EXPECT_EQ(program->samplerUnit("beta"), 2) << "the next that is free";
    EXPECT_EQ(program->samplerUnit("gamma"), std::nullopt);
    std::array<Texture, 3> textures;
    const std::array<const char*, 3> names = {"alpha", "beta", "pinned"};
    for (std::size_t i = 0; i < 3; ++i) {
        textures[i] = Texture({.format = Format::r32f, .size = {1, 1}}, names[i]);
        textures[i].upload(std::vector<float>{static_cast<float>(i + 1)});
        program->texture(names[i], textures[i]);
    }
    EXPECT_EQ(test::evaluate(*program), vec4(1, 2, 3, 1));
}

struct TestBlock {
    vec3 direction;
    float time;
    mat4 matrix;
    vec4 list[3];
};

TEST_F(GlProgram, UniformBlocksArriveAsLaidOut)
{
    const std::string block = "UNIFORM_BLOCK(ViewBlock) { vec3 direction; float time; mat4 matrix; vec4 list[3]; };\n";
    const auto program = make(block + "void main() { colour = vec4(direction.z, time, matrix[3][1], list[2].w); }\n");
    EXPECT_EQ(program->blockSize("ViewBlock"), static_cast<int>(sizeof(TestBlock)));
    EXPECT_EQ(program->blockSize("FrameBlock"), std::nullopt);
    EXPECT_EQ(program->blockOffset("time"), static_cast<int>(offsetof(TestBlock, time)));
    EXPECT_EQ(program->blockOffset("list[0]"), static_cast<int>(offsetof(TestBlock, list)));
    EXPECT_EQ(program->blockOffset("nothing"), std::nullopt);

    UniformBuffer<TestBlock> first(1, "first view");
    UniformBuffer<TestBlock> second(1, "second view");
    TestBlock value{{9, 9, 1}, 2.0f, glm::translate(mat4(1.0f), vec3(9, 3, 9)), {vec4(9), vec4(9), vec4(9, 9, 9, 4)}};
    first.update(value);
    value.time = 20.0f;
    second.update(value);
    EXPECT_EQ(test::evaluate(*program), vec4(1, 20, 3, 4)) << "the one updated last is bound";
    first.bind();
    EXPECT_EQ(test::evaluate(*program), vec4(1, 2, 3, 4));
}

TEST_F(GlProgram, BufferPartsAreReplacedWithinBounds)
{
    const auto program = make("UNIFORM_BLOCK(ViewBlock) { vec4 a; vec4 b; };\nvoid main() { colour = a + b; }\n");
    Buffer buffer("two vectors", Buffer::Usage::dynamic);
    const std::array<vec4, 2> values = {vec4(1.0f), vec4(2.0f)};
    buffer.upload(std::span<const vec4>(values));
    buffer.subData(sizeof(vec4), &values[0], sizeof(vec4));
    buffer.bindUniform(1);
    EXPECT_EQ(test::evaluate(*program), vec4(2.0f));
    EXPECT_EQ(complaint([&] { buffer.subData(17, &values[0], sizeof(vec4)); }),
              "buffer \"two vectors\" holds 32 bytes; 16 bytes at 17 reach past its end");
}

TEST_F(GlProgram, BlocksWithoutBindingAreErrors)
{
    EXPECT_EQ(complaint([&] { make("UNIFORM_BLOCK(Lost) { vec4 x; };\nvoid main() { colour = x; }\n"); }),
              "program \"test\": uniform block Lost has no binding index; add it to the bindings of the "
              "shader library");
}

TEST_F(GlShaderLibrary, DefinesMakeVariants)
{
    const std::string text = "void main() { colour = vec4(VALUE); }\n";
    const auto one = make(text, {{"VALUE", "1.0"}});
    const auto two = make(text, {{"VALUE", "2.0"}});
    EXPECT_EQ(test::evaluate(*one), vec4(1.0f));
    EXPECT_EQ(test::evaluate(*two), vec4(2.0f));
    EXPECT_EQ(library_.program("test", "full.vert", "test.frag", {{"VALUE", "1.0"}}), one);
}

TEST_F(GlShaderLibrary, CompileErrorsNameFileAndLine)
{
    const std::string broken = complaint([&] { make("\nvoid main() { colour = vec4(nonsense); }\n"); });
    EXPECT_TRUE(broken.starts_with("shaders/test.frag:3: ")) << broken;
    EXPECT_NE(broken.find("nonsense"), std::string::npos) << broken;
    EXPECT_EQ(broken.find('\n'), std::string::npos) << "one line";
}

TEST_F(GlShaderLibrary, CompileErrorsInIncludesNameTheInclude)
{
    folder_.write("shared/good.glsl", "float good() { return 1.0; }\n");
    folder_.write("shared/bad.glsl", "#include \"shared/good.glsl\"\n\n\nfloat bad() { return nonsense; }\n");
    const std::string text = "#include \"shared/good.glsl\"\n#include \"shared/bad.glsl\"\n";
    std::string message = complaint([&] { make(text + "void main() { colour = vec4(bad()); }\n"); });
    EXPECT_TRUE(message.starts_with("shaders/shared/bad.glsl:4: ")) << message;
    // The lines after the includes are counted right too.
    folder_.write("shared/bad.glsl", "float bad() { return 1.0; }\n");
    message = complaint([&] { make(text + "\nvoid main() { colour = vec4(bad(), nonsense); }\n"); });
    EXPECT_TRUE(message.starts_with("shaders/test.frag:5: ")) << message;
}

TEST_F(GlShaderLibrary, LinkErrorsNameTheFiles)
{
    folder_.write("varying.vert", std::string("out vec2 normalW;\n") + test::fullscreenVertex);
    folder_.write("varying.frag", "in vec3 normalW;\nout vec4 colour;\nvoid main() { colour = vec4(normalW, 1.0); }\n");
    const std::string message = complaint([&] { library_.program("pier", "varying.vert", "varying.frag"); });
    EXPECT_TRUE(message.starts_with("program \"pier\" (varying.vert with varying.frag) does not link: ")) << message;
    EXPECT_NE(message.find("normalW"), std::string::npos) << message;
}

TEST_F(GlShaderLibrary, ReloadsWhatChanged)
{
    folder_.write("shared/value.glsl", "const float value = 1.0;\n");
    const auto program = make("#include \"shared/value.glsl\"\nuniform float scale;\n"
                              "void main() { colour = vec4(scale * value); }\n");
    program->set("scale", 10.0f);
    EXPECT_EQ(test::evaluate(*program), vec4(10.0f));
    EXPECT_FALSE(library_.reloadChanged()) << "nothing changed";

    folder_.write("shared/value.glsl", "const float value = 2.0;\n");
    EXPECT_TRUE(library_.reloadChanged());
    EXPECT_EQ(program->generation(), 1);
    EXPECT_EQ(test::evaluate(*program), vec4(20.0f)) << "an include counts, and uniforms keep their values";
    EXPECT_FALSE(library_.reloadChanged());
}

TEST_F(GlShaderLibrary, ABrokenShaderKeepsTheLastGoodProgram)
{
    const auto program = make("void main() { colour = vec4(1.0); }\n");
    folder_.write("test.frag", "out vec4 colour;\nvoid main() { colour = vec4(oops); }\n");
    {
        const log::Capture capture;
        EXPECT_FALSE(library_.reloadChanged());
        EXPECT_FALSE(library_.reloadChanged());
        std::vector<std::string> errors;
        for (const auto& message : capture.messages()) {
            if (message.level == log::Level::error) errors.push_back(message.text);
        }
        ASSERT_EQ(errors.size(), 1u) << "said once";
        EXPECT_TRUE(errors.front().starts_with("shaders/test.frag:2: ")) << errors.front();
    }
    EXPECT_TRUE(library_.lastError().starts_with("shaders/test.frag:2: ")) << library_.lastError();
    EXPECT_EQ(test::evaluate(*program), vec4(1.0f));

    const log::Capture capture;
    folder_.write("test.frag", "out vec4 colour;\nvoid main() { colour = vec4(3.0); }\n");
    EXPECT_TRUE(library_.reloadChanged());
    EXPECT_EQ(library_.lastError(), "");
    EXPECT_EQ(test::evaluate(*program), vec4(3.0f));
}

TEST_F(GlShaderLibrary, AMissingIncludeIsNoticedWhenItComes)
{
    const auto program = make("void main() { colour = vec4(1.0); }\n");
    const log::Capture capture;
    folder_.write("test.frag",
                  "#include \"shared/late.glsl\"\nout vec4 colour;\nvoid main() { colour = vec4(late); }\n");
    EXPECT_FALSE(library_.reloadChanged());
    EXPECT_NE(library_.lastError().find("shaders/test.frag:1: no shader file"), std::string::npos);
    folder_.write("shared/late.glsl", "const float late = 5.0;\n");
    EXPECT_TRUE(library_.reloadChanged());
    EXPECT_EQ(test::evaluate(*program), vec4(5.0f));
}

TEST_F(GlShaderLibrary, AnEditThatChangesAUniformsTypeIsRefused)
{
    const auto program = make("uniform float tint;\nvoid main() { colour = vec4(tint); }\n");
    program->set("tint", 2.0f);
    const log::Capture capture;
    folder_.write("test.frag", "out vec4 colour;\nuniform vec4 tint;\nvoid main() { colour = tint; }\n");
    EXPECT_FALSE(library_.reloadChanged());
    EXPECT_NE(library_.lastError().find("uniform tint"), std::string::npos);
    program->set("tint", 4.0f);
    EXPECT_EQ(test::evaluate(*program), vec4(4.0f));
}

TEST_F(GlShaderLibrary, AFileThatIsBeingSavedIsWaitedFor)
{
    const auto program = make("void main() { colour = vec4(1.0); }\n");
    folder_.remove("test.frag");
    EXPECT_FALSE(library_.reloadChanged());
    EXPECT_EQ(library_.lastError(), "");
    folder_.write("test.frag", "out vec4 colour;\nvoid main() { colour = vec4(2.0); }\n");
    EXPECT_TRUE(library_.reloadChanged());
    EXPECT_EQ(test::evaluate(*program), vec4(2.0f));
}

TEST_F(GlShaderLibrary, PollingLooksAFewTimesASecond)
{
    const auto program = make("void main() { colour = vec4(1.0); }\n");
    library_.pollChanges();
    folder_.write("test.frag", "out vec4 colour;\nvoid main() { colour = vec4(2.0); }\n");
    EXPECT_FALSE(library_.pollChanges()) << "within the same quarter of a second";
    EXPECT_TRUE(library_.reloadChanged());
}

TEST_F(GlShaderLibrary, ForgetsProgramsThatNobodyHolds)
{
    make("void main() { colour = vec4(1.0); }\n");
    const log::Capture capture;
    folder_.write("test.frag", "broken\n");
    EXPECT_FALSE(library_.reloadChanged());
    EXPECT_EQ(library_.lastError(), "") << "a program that is gone is not rebuilt";
}

} // namespace
} // namespace tarn::gl
