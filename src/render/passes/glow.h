// The sun's highlight on the water, spread over the picture like light in a lens (Mihálik 2008, section 9.3).
#pragma once

#include "gl/shader_library.h"
#include "gl/target.h"
#include "gl/vertex_array.h"
#include "gl/visibility_query.h"
#include "plan/options.h"
#include "render/normal_map.h"
#include "render/pass_interface.h"
#include "render/water_grid.h"

#include <map>
#include <memory>

namespace tarn {

class GlowPass {
public:
    static PassInterface interface(const FramePlan&) { return {{Resource::sceneDepth}, {Resource::glow}}; }

    explicit GlowPass(gl::ShaderLibrary& shaders) : shaders_(shaders) {}

    struct Inputs {
        const gl::Texture& sceneDepth; ///< of the picture, water included; its ViewBlock must hold the glow's size
        ivec2 size;                    ///< of the glow's target, pixels
        int waveCount = 0;
        NormalMapInputs normalMap{};
        const gl::VisibilityQuery* ifSeen = nullptr; ///< whether anything of the water may be seen; null: it may
    };

    /// Highlight and filter. The result is on the display's scale.
    const gl::Target& draw(WaterGrid& grid, const Options& options, const Inputs& inputs, FrameReport::Pass& stats);

    /// The filter alone: what it makes of a picture.
    const gl::Target& blur(const gl::Texture& source);

private:
    gl::Program& highlightProgram(const WaterOptions& options, const Inputs& inputs);

    gl::ShaderLibrary& shaders_;
    gl::Target highlight_{"glow highlight"};
    gl::Target blurred_{"glow"};
    gl::FullscreenTriangle triangle_;
    std::map<gl::Defines, std::shared_ptr<gl::Program>> programs_;
    std::shared_ptr<gl::Program> blurProgram_;
};

} // namespace tarn
