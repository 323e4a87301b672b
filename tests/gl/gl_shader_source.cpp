#include "gl/shader_source.h"

#include "base/error.h"
#include "gl_test.h"

#include <gtest/gtest.h>

namespace tarn::gl {
namespace {

std::string complaint(const test::ShaderFolder& folder, const std::string& file)
{
    try {
        assembleShader(folder.root(), file, {});
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

std::string named(const std::string& log)
{
    return nameFilesInLog(log, "/somewhere/shaders", {"shared/glsl_prelude.glsl", "passes/water.frag"});
}

TEST(GlShaderSource, IncludesEachFileOnceAndKeepsCount)
{
    test::ShaderFolder folder;
    folder.write("shared/a.glsl", "#include \"shared/b.glsl\"\nfloat a;\n");
    folder.write("shared/b.glsl", "float b;\n");
    folder.write("main.frag",
                 "// first\n#include \"shared/a.glsl\"\n  #  include \"shared/../shared/b.glsl\" // again\nlast\n");
    const ShaderSource source = assembleShader(folder.root(), "main.frag", {{"STEPS", "8"}, {"FLAT", ""}});

    EXPECT_TRUE(source.text.starts_with("#version 330 core\n#define STEPS 8\n#define FLAT \n#line 1 0\n"))
        << source.text;
    EXPECT_EQ(source.files,
              (std::vector<std::string>{"shared/glsl_prelude.glsl", "main.frag", "shared/a.glsl", "shared/b.glsl"}));
    EXPECT_TRUE(source.text.ends_with("#line 100001 1\n// first\n#line 200001 2\n#line 300001 3\nfloat b;\n"
                                      "#line 200002 2\nfloat a;\n#line 100003 1\n\nlast\n"))
        << source.text;
}

TEST(GlShaderSource, IncludesInCommentsStayComments)
{
    test::ShaderFolder folder;
    folder.write("main.frag", "/* one\n#include \"nowhere.glsl\"\n*/\n// #include \"nowhere.glsl\"\nfloat x; // /*\n"
                              "#include \"shared/b.glsl\"\n");
    folder.write("shared/b.glsl", "float b;\n");
    const ShaderSource source = assembleShader(folder.root(), "main.frag", {});
    EXPECT_NE(source.text.find("float b;"), std::string::npos);
    EXPECT_EQ(source.files.size(), 3u);
}

TEST(GlShaderSource, TakesFilesFromWindows)
{
    test::ShaderFolder folder;
    folder.write("main.frag", "\xEF\xBB\xBF#include \"shared/b.glsl\"\r\nfloat last;\r\n");
    folder.write("shared/b.glsl", "float b;\r\n");
    const ShaderSource source = assembleShader(folder.root(), "main.frag", {});
    EXPECT_TRUE(source.text.ends_with("float b;\n#line 100002 1\nfloat last;\n")) << source.text;
}

TEST(GlShaderSource, MistakesNameTheirPlace)
{
    test::ShaderFolder folder;
    folder.write("missing.frag", "\n\n#include \"shared/none.glsl\"\n");
    folder.write("nested.frag", "#include \"missing.frag\"\n");
    folder.write("bare.frag", "#include shared/b.glsl\n");
    folder.write("version.frag", "\n#version 450\n");
    const std::string root = folder.root().generic_string();
    EXPECT_EQ(complaint(folder, "missing.frag"),
              "shaders/missing.frag:3: no shader file \"shared/none.glsl\" in " + root);
    EXPECT_EQ(complaint(folder, "nested.frag"),
              "shaders/missing.frag:3: no shader file \"shared/none.glsl\" in " + root);
    EXPECT_EQ(complaint(folder, "none.frag"), "no shader file \"none.frag\" in " + root);
    EXPECT_EQ(complaint(folder, "shared"), "no shader file \"shared\" in " + root) << "a folder";
    EXPECT_TRUE(complaint(folder, "bare.frag").starts_with("shaders/bare.frag:1: #include wants a file in quotes"));
    EXPECT_TRUE(complaint(folder, "version.frag").starts_with("shaders/version.frag:2: remove #version"));
}

TEST(GlShaderSource, AFileThatIncludesItselfEnds)
{
    test::ShaderFolder folder;
    folder.write("loop.frag", "#include \"other.glsl\"\nfloat a;\n");
    folder.write("other.glsl", "#include \"loop.frag\"\nfloat b;\n");
    EXPECT_EQ(complaint(folder, "loop.frag"), "");
}

TEST(GlShaderSource, NamesFilesInTheLogsOfAllDrivers)
{
    EXPECT_EQ(named("0:100012(5): error: `foo' undeclared"), "shaders/passes/water.frag:12: `foo' undeclared");
    EXPECT_EQ(named("1(100012) : error C1008: undefined variable \"foo\""),
              "shaders/passes/water.frag:12: error C1008: undefined variable \"foo\"");
    EXPECT_EQ(named("ERROR: 1:100012: Use of undeclared identifier 'foo'"),
              "shaders/passes/water.frag:12: Use of undeclared identifier 'foo'");
    EXPECT_EQ(named("0:3(1): warning: extension unsupported\n\n1:100004(1): error: bad\n"),
              "shaders/shared/glsl_prelude.glsl:3: warning: extension "
              "unsupported\nshaders/passes/water.frag:4: bad");
}

TEST(GlShaderSource, LeavesOtherLogsAlone)
{
    EXPECT_EQ(named("linking with no vertex shader"), "linking with no vertex shader");
    EXPECT_EQ(named("7:700012(5): error: no such file number"), "7:700012(5): error: no such file number");
    EXPECT_EQ(named("0:99999999999999999999(5): error: no"), "0:99999999999999999999(5): error: no");
    EXPECT_EQ(named(""), "");
}

} // namespace
} // namespace tarn::gl
