// From a frame that was drawn larger to the size of its picture: the mean radiance over each pixel, so that the tone
// curve acts on what a pixel's whole area sends, as it does in the reference.
#pragma once

#include "gl/shader_library.h"
#include "gl/target.h"
#include "gl/vertex_array.h"

#include <map>
#include <memory>

namespace tarn {

class DownsamplePass {
public:
    explicit DownsamplePass(gl::ShaderLibrary& shaders) : shaders_(shaders) {}

    /// @param drawn resolved, no smaller than `size`  @param size of the result, pixels
    /// @return `drawn` itself where it has that size already
    const gl::Target& draw(const gl::Target& drawn, ivec2 size);

private:
    gl::ShaderLibrary& shaders_;
    gl::Target target_{"picture"};
    gl::FullscreenTriangle triangle_;
    std::map<int, std::shared_ptr<gl::Program>> programs_; ///< by taps along one edge
};

} // namespace tarn
