// The scene's depth along the sun: above the water along its direction, below it along the refracted one
// (Mihálik 2008, section 9.2). Shadows are looked up in it, and photons find the bed in it.
#pragma once

#include "gl/target.h"
#include "plan/options.h"
#include "render/scene_painter.h"
#include "render/sun_views.h"

#include <array>
#include <optional>

namespace tarn {

class SunlightPass {
public:
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
    void draw(SunLayer layer, std::size_t cascade, const View& view, ScenePainter& painter, const Inputs& inputs,
              const SunlightOptions& options, bool cull, FrameStats::Pass& stats);
    /// After all of them.
    void keep(const Inputs& inputs, const SunlightOptions& options);

    const gl::Texture& depth(SunLayer layer, std::size_t cascade = 0) const
    {
        return (layer == SunLayer::afloat ? afloat_.at(cascade) : submerged_).depth();
    }

private:
    std::array<gl::Target, mostCascades> afloat_{gl::Target{"sunlight afloat"}, gl::Target{"sunlight beyond"},
                                                 gl::Target{"sunlight far beyond"}};
    gl::Target submerged_{"sunlight submerged"};
    std::optional<Inputs> drawn_;
    int mapSize_ = 0;
    DepthFormat format_ = DepthFormat::depth24;
};

} // namespace tarn
