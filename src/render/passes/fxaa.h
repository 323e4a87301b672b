// Smooths the edges of the shown picture (frame.antialiasing = fxaa).
#pragma once

#include "gl/shader_library.h"
#include "gl/target.h"
#include "gl/vertex_array.h"

#include <memory>

namespace tarn {

class FxaaPass {
public:
    explicit FxaaPass(gl::ShaderLibrary& shaders) : shaders_(shaders) {}

    /// @param shown after the tone curve, sRGB; its alpha is the luma, shared/fxaa.glsl
    const gl::Target& draw(const gl::Texture& shown);

private:
    gl::ShaderLibrary& shaders_;
    gl::Target target_{"smoothed display"};
    gl::FullscreenTriangle triangle_;
    std::shared_ptr<gl::Program> program_;
};

} // namespace tarn
