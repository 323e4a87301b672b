// Both eyes' pictures side by side, or as one anaglyph.
#pragma once

#include "gl/shader_library.h"
#include "gl/target.h"
#include "gl/vertex_array.h"
#include "plan/stereo.h"

#include <memory>

namespace tarn {

class StereoPass {
public:
    explicit StereoPass(gl::ShaderLibrary& shaders) : shaders_(shaders) {}

    /// Copies what was drawn for an eye to its half. Both eyes' must be of one size and format.
    /// @param linear before the tone curve, or a debug view's raw values   @param display as it is shown
    void take(Eye eye, const gl::Target& linear, const gl::Target& display);

    /// Of the displayed halves, as large as one of them.
    const gl::Target& drawAnaglyph();

    /// The halves beside each other, the left eye's on the left.
    const gl::Target& linear() const { return linear_; }
    const gl::Target& display() const { return display_; }

private:
    gl::ShaderLibrary& shaders_;
    gl::Target linear_{"both eyes, linear"};
    gl::Target display_{"both eyes"};
    gl::Target anaglyph_{"anaglyph"};
    gl::FullscreenTriangle triangle_;
    std::shared_ptr<gl::Program> program_;
};

} // namespace tarn
