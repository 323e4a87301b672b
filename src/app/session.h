// A headless context with a renderer in it.
#pragma once

#include "app/scene_setup.h"
#include "gl/context.h"
#include "gl/profiler.h"
#include "gl/shader_library.h"
#include "render/renderer.h"

#include <memory>

namespace tarn {

class Session {
public:
    /// Keeps a reference to the set-up.
    Session(const SceneSetup& sceneSetup, ivec2 size, Progress* progress);

    Renderer& renderer() { return *renderer_; }
    gl::Profiler& profiler() { return profiler_; }
    gl::ShaderLibrary& shaders() { return *shaders_; }
    const gl::Context& context() const { return *context_; }

private:
    // In this order, so that all GL objects are gone before the context is.
    std::unique_ptr<gl::Context> context_;
    std::unique_ptr<gl::ShaderLibrary> shaders_;
    gl::Profiler profiler_;
    std::unique_ptr<Renderer> renderer_;
};

/// Throws Error when a picture of this size is more than the machine can draw.
void requireDrawable(ivec2 size);

/// Waits until the GPU has done all that it was asked for.
void finishGpu();

} // namespace tarn
