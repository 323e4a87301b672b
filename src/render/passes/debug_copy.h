// Brings a target of a pass to the size of the picture, for the debug views that show it.
#pragma once

#include "gl/shader_library.h"
#include "gl/target.h"
#include "gl/vertex_array.h"

#include <memory>

namespace tarn {

class DebugCopyPass {
public:
    explicit DebugCopyPass(gl::ShaderLibrary& shaders) : shaders_(shaders) {}

    /// Colour as it is.
    const gl::Target& colour(const gl::Texture& source, ivec2 size);
    /// A depth texture as metres along the axis of the camera that made it.
    const gl::Target& depth(const gl::Texture& source, ivec2 size, float nearPlane, float farPlane);
    /// Black, for a target that the frame did not need.
    const gl::Target& nothing(ivec2 size);

private:
    void copy(gl::Program& program, const gl::Texture& source, ivec2 size, vec2 nearFar);
    void begin(ivec2 size);

    gl::ShaderLibrary& shaders_;
    gl::Target target_{"debug view"};
    gl::FullscreenTriangle triangle_;
    std::shared_ptr<gl::Program> colourProgram_, depthProgram_;
};

} // namespace tarn
