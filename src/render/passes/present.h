// From linear radiance to the display; debug views to colours that a person can read.
#pragma once

#include "gl/shader_library.h"
#include "gl/target.h"
#include "gl/vertex_array.h"
#include "plan/options.h"
#include "render/debug_view.h"
#include "render/pass_interface.h"

#include <map>
#include <memory>

namespace tarn {

class PresentPass {
public:
    static PassInterface interface(const FramePlan&)
    {
        return {{Resource::sceneColour, Resource::glow}, {Resource::picture}};
    }

    explicit PresentPass(gl::ShaderLibrary& shaders) : shaders_(shaders) {}

    /// @param source linear; for a debug view its raw values
    /// @param glow added on the display's scale; null for none
    /// @param luma left in alpha for shared/fxaa.glsl; else that is 1
    const gl::Target& draw(const gl::Texture& source, const gl::Texture* glow, const FrameOptions& options,
                           DebugView view, bool luma = false);
    const gl::Target& target() const { return target_; } ///< the last result

private:
    gl::ShaderLibrary& shaders_;
    gl::Target target_{"display"};
    gl::FullscreenTriangle triangle_;
    std::map<gl::Defines, std::shared_ptr<gl::Program>> programs_;
};

} // namespace tarn
