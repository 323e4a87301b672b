// Which pixels are under water in a frame whose near plane the surface cuts.
#pragma once

#include "gl/shader_library.h"
#include "gl/target.h"
#include "gl/vertex_array.h"
#include "render/view.h"

#include <memory>

namespace tarn {

class WaterlinePass {
public:
    explicit WaterlinePass(gl::ShaderLibrary& shaders) : shaders_(shaders) {}

    /// Red: 1 where a pixel is under the drawn surface and within the water's rectangle; green: 1 on the line itself.
    /// FrameBlock, the waves and the view's ViewBlock must be bound.
    /// @param size of the picture, pixels
    const gl::Texture& draw(const View& view, ivec2 size);

private:
    gl::ShaderLibrary& shaders_;
    gl::Target target_{"waterline"};
    gl::FullscreenTriangle triangle_;
    std::shared_ptr<gl::Program> program_;
};

} // namespace tarn
