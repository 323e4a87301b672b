#include "gl/context.h"
#include "gl_test.h"

#include "base/error.h"
#include "base/files.h"
#include "gl/state.h"
#include "gl/vertex_array.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

// What Mesa and LLVM keep until the process ends is not ours to free.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa\nleak:libLLVM\n"; }

namespace tarn::test {

namespace {
gl::Context* context = nullptr;
}

gl::Context& testContext() { return *context; }

const char* const fullscreenVertex = R"(
void main()
{
    vec2 corner = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);
}
)";

ShaderFolder::ShaderFolder()
{
    std::string pattern = (std::filesystem::temp_directory_path() / "tarn-XXXXXX").string();
    if (!mkdtemp(pattern.data())) throw Error("no temporary folder");
    root_ = std::filesystem::path(pattern) / "shaders";
    std::filesystem::create_directories(root_ / "shared");
    const char* const prelude = "shared/glsl_prelude.glsl";
    std::filesystem::copy_file(projectRoot() / "shaders" / prelude, root_ / prelude);
}

ShaderFolder::~ShaderFolder()
{
    std::error_code ignored;
    std::filesystem::remove_all(root_.parent_path(), ignored);
}

void ShaderFolder::write(const std::string& file, const std::string& text)
{
    std::filesystem::create_directories((root_ / file).parent_path());
    writeFile(root_ / file, text);
    const auto now = std::filesystem::file_time_type::clock::now();
    std::filesystem::last_write_time(root_ / file, now + std::chrono::seconds(++writes_));
}

void ShaderFolder::remove(const std::string& file) { std::filesystem::remove(root_ / file); }

vec4 evaluate(const gl::Program& program)
{
    gl::Target pixel("pixel");
    pixel.ensure({.size = {1, 1}, .colours = {gl::Format::rgba32f}});
    pixel.bind();
    gl::apply({.depthTest = gl::DepthTest::off});
    program.use();
    gl::FullscreenTriangle().draw();
    const std::vector<float> values = pixel.framebuffer().readFloats();
    return {values[0], values[1], values[2], values[3]};
}

namespace {

/// Fails a test in which OpenGL complained, by debug message or by glGetError.
class NoGlErrors : public testing::EmptyTestEventListener {
    void OnTestStart(const testing::TestInfo&) override { before_ = gl::debugErrorCount(); }
    void OnTestEnd(const testing::TestInfo&) override
    {
        EXPECT_EQ(gl::debugErrorCount(), before_) << gl::lastDebugError();
        EXPECT_NO_THROW(gl::checkErrors("the test"));
    }
    int before_ = 0;
};

} // namespace

} // namespace tarn::test

int main(int argc, char** argv)
{
    testing::InitGoogleTest(&argc, argv);
    try {
        const auto context = tarn::gl::makeHeadlessContext({64, 64}, true);
        tarn::test::context = context.get();
        testing::UnitTest::GetInstance()->listeners().Append(new tarn::test::NoGlErrors);
        return RUN_ALL_TESTS();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "gl_tests: %s\n", error.what());
        return 1;
    }
}
