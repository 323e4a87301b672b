// The mean radiance of frames of one moment that are jittered within a pixel: as smooth as supersampling, for a picture
// that stands still.
#pragma once

#include "gl/shader_library.h"
#include "gl/target.h"
#include "gl/vertex_array.h"

#include <array>
#include <memory>

namespace tarn {

class AccumulatePass {
public:
    explicit AccumulatePass(gl::ShaderLibrary& shaders) : shaders_(shaders) {}

    /// @param newest linear radiance  @param sample how many there are with it; 1 begins anew
    /// @return the mean: `newest` itself where it is the first
    const gl::Target& add(const gl::Target& newest, int sample);

private:
    gl::ShaderLibrary& shaders_;
    std::array<gl::Target, 2> means_{gl::Target{"mean"}, gl::Target{"mean before"}}; ///< the first is the newer
    gl::FullscreenTriangle triangle_;
    std::shared_ptr<gl::Program> program_;
};

} // namespace tarn
