// Renders pictures of one scene for tests that look at the values of their pixels.
#pragma once

#include "gl/profiler.h"
#include "gl/shader_library.h"
#include "render/renderer.h"

#include <gtest/gtest.h>

#include <memory>

namespace tarn::test {

/// A renderer and what it needs, for tests that ask it themselves. The scene must outlive it.
struct TestRenderer {
    explicit TestRenderer(const Scene& scene, const Options& options)
        : shaders(makeShaderLibrary()), renderer(scene, options, *shaders, profiler)
    {}
    std::unique_ptr<gl::ShaderLibrary> shaders;
    gl::Profiler profiler;
    Renderer renderer;
};

class CheckedRenderer {
public:
    /// The scene must outlive it.
    explicit CheckedRenderer(const Scene& scene, const Options& options = {})
        : shaders_(makeShaderLibrary()), renderer_(scene, options, *shaders_, profiler_)
    {
        renderer_.setChecking(true);
    }

    /// The linear picture, or the raw values of a debug view. A NaN, an infinity or a negative value fails the test.
    Image linear(const Camera& camera, ivec2 size, double time = 0.0, DebugView view = DebugView::final)
    {
        stats = renderer_.render({camera, time, size, view});
        EXPECT_TRUE(renderer_.badPixels().empty()) << renderer_.badPixels().front().pass;
        return renderer_.readLinear();
    }
    void setOptions(const Options& options, const WaterBody& water) { renderer_.setOptions(options, water); }
    FrameReport stats; ///< of the last picture

private:
    std::unique_ptr<gl::ShaderLibrary> shaders_;
    gl::Profiler profiler_;
    Renderer renderer_;
};

/// y counts from the top.
inline vec4 pixel(const Image& image, int x, int y)
{
    const std::size_t i =
        (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) * 4;
    return {image.floats[i], image.floats[i + 1], image.floats[i + 2], image.floats[i + 3]};
}

} // namespace tarn::test
