// What the tests in this folder share: they all run in one OSMesa context, made by gl_main.cpp, and any
// OpenGL debug error during a test fails it.
#pragma once

#include "gl/context.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/shader_library.h"
#include "gl/target.h"

#include <filesystem>
#include <memory>
#include <string>

namespace tarn::test {

/// The context that the tests run in.
gl::Context& testContext();

/// A folder of shaders that lives as long as the test, with the real prelude in it.
class ShaderFolder {
public:
    ShaderFolder();
    ~ShaderFolder();
    ShaderFolder(const ShaderFolder&) = delete;
    ShaderFolder& operator=(const ShaderFolder&) = delete;

    /// Every write gives the file a later time than any before, however fast the test is.
    void write(const std::string& file, const std::string& text);
    void remove(const std::string& file);
    /// Its last part is "shaders", as messages show it.
    const std::filesystem::path& root() const { return root_; }

private:
    std::filesystem::path root_;
    int writes_ = 0;
};

/// The vertex shader of a full-screen triangle.
extern const char* const fullscreenVertex;

/// Draws the program over a target of one rgba32f pixel and returns it.
vec4 evaluate(const gl::Program& program);

} // namespace tarn::test
