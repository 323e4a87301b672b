// What stands over the water, seen straight from below and from above: heights and radiance. What a mirrored ray is
// marched through when reflection.method is raycast; drawn again only when scene, sun or water change.
#pragma once

#include "gl/target.h"
#include "gl/texture.h"
#include "optics/blocks.h"
#include "plan/options.h"
#include "render/height_field.h"
#include "render/pass_interface.h"
#include "render/scene_renderer.h"

#include <optional>

namespace tarn {

class AboveWaterHeightsPass {
public:
    static PassInterface interface(const FramePlan& plan)
    {
        if (!plan.drawsAboveWaterMap) return {};
        return {{Resource::sunDepth}, {Resource::aboveWaterHeights}};
    }

    struct Inputs {
        LevelRect rect;
        float lowest = 0.0f, highest = 0.0f; ///< world y; the lowest lies under the lowest trough
        blocks::FrameBlock light{};          ///< as in HeightsPass
        SceneVariant lit;                    ///< how the sun lights it: its maps are static, too
        bool cull = true;
    };

    bool isStale(const Inputs& inputs, const HeightsOptions& options) const;

    enum class From { above, below };
    /// A view. Its ViewBlock must be bound for draw().
    static View view(const Inputs& inputs, From from);
    void draw(From from, const View& view, SceneRenderer& sceneRenderer, const Inputs& inputs,
              const HeightsOptions& options, FrameReport::Pass& stats);
    /// After both.
    void readHeights(const Inputs& inputs);

    /// From now on this map is it, and none is drawn.
    void take(const HeightMapPicture& picture);
    bool isGiven() const { return given_.has_value(); }
    /// As it is, without its light. Waits for the GPU.
    HeightMapPicture picture() const;

    /// rgba32f: underside, top and what is seen from below, m (shaders/passes/above_water_march.glsl); levels: the
    /// pyramid.
    const gl::Texture& heights() const { return heights_; }
    const gl::Texture& radiance(From from) const;
    const LevelRect& rect() const { return rect_; }
    float highest() const { return highest_; } ///< over all that stands there, m

private:
    struct Given {
        gl::Texture above, below; ///< radiance
    };
    struct Column;
    void uploadHeights(std::vector<Column> columns, int resolution);

    gl::Target above_{"heights from above"}, below_{"heights from below"};
    gl::Texture heights_;
    LevelRect rect_;
    float highest_ = 0.0f;
    std::optional<Inputs> drawn_;
    std::optional<Given> given_;
};

} // namespace tarn
