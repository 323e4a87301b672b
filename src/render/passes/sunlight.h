// The scene's depth along the sun: above the water along its direction, below it along the refracted one
// (Mihálik 2008, section 9.2). Shadows are looked up in it, and photons find the bed in it.
#pragma once

#include "gl/framebuffer.h"
#include "plan/options.h"
#include "render/pass_interface.h"
#include "render/scene_renderer.h"
#include "render/sun_views.h"

#include <optional>
#include <vector>

namespace tarn {

class SunlightPass {
public:
    static PassInterface interface(const FramePlan&) { return {{}, {Resource::sunDepth}}; }

    struct Inputs {
        SunVolume volume;
        vec3 toSun;      ///< unit, above the horizon
        vec3 toSunBelow; ///< the refracted one
        float level = 0.0f;
        bool dithersCutOuts = false;
        bool hasWater = true; ///< else the whole scene stands in the air
        float detail = 0.0f;  ///< pixels by which geometry may be off in a map
        bool operator==(const Inputs&) const = default;
    };

    /// True when the maps must be drawn: they keep what they hold until an input, or an option, changes.
    bool isStale(const Inputs& inputs, const SunlightOptions& options) const;

    /// Draws one map. The view's ViewBlock must be bound.
    /// @param cascade of the layer; what is submerged has one
    void draw(SunLayer layer, std::size_t cascade, const View& view, SceneRenderer& sceneRenderer, const Inputs& inputs,
              const SunlightOptions& options, bool cull, FrameReport::Pass& stats);
    /// After all of them.
    void keep(const Inputs& inputs, const SunlightOptions& options);

    /// An array of layers (shaders/passes/sun_maps.glsl).
    const gl::Texture& depth() const { return depth_; }

private:
    void ensureLayers(const SunlightOptions& options, std::size_t cascades);

    gl::Texture depth_;
    std::vector<gl::Framebuffer> layers_; ///< of depth_
    std::optional<Inputs> drawn_;
    int mapSize_ = 0;
    DepthFormat format_ = DepthFormat::depth24;
};

} // namespace tarn
