// Brings a picture that was drawn smaller (frame.scale below 1) to its size, as it is shown or as radiance.
#pragma once

#include "gl/shader_library.h"
#include "gl/target.h"
#include "gl/vertex_array.h"
#include "plan/options.h"

#include <map>
#include <memory>

namespace tarn {

class UpscalePass {
public:
    explicit UpscalePass(gl::ShaderLibrary& shaders) : shaders_(shaders) {}

    /// @param shown after the tone curve, sRGB   @param size of the result, pixels
    const gl::Target& draw(const gl::Texture& shown, ivec2 size, FrameOptions::Upscaler upscaler);

    /// The same of radiance, for those who read it.
    /// @param sideBySide how many pictures, 1 or 2, stand beside each other and do not mix
    const gl::Target& drawLinear(const gl::Texture& radiance, ivec2 size, const FrameOptions& options, int sideBySide);

private:
    gl::Program& begin(const gl::Target& target, const gl::Texture& source, FrameOptions::Upscaler upscaler,
                       bool isLinear);

    gl::ShaderLibrary& shaders_;
    gl::Target shown_{"upscaled display"};
    gl::Target linear_{"upscaled picture"};
    gl::FullscreenTriangle triangle_;
    std::map<gl::Defines, std::shared_ptr<gl::Program>> programs_;
};

} // namespace tarn
