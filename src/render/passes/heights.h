// The bed seen from above: its height, and how it shines (Lipp). What a refracted ray is marched through when
// refraction.method is raycast; drawn again only when scene, sun or water change.
//
// The sun's light is not in the colour, only how the bed answers it: shadows and caustics are looked up where a ray
// ends, so that moving waves leave the map as it is.
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

class HeightsPass {
public:
    static PassInterface interface(const FramePlan& plan)
    {
        return {{}, plan.drawsBedMap ? Resources{Resource::bedHeights} : Resources{}};
    }

    struct Inputs {
        LevelRect rect;
        float lowest = 0.0f;        ///< of the scene, world y
        float highest = 0.0f;       ///< where the bed is cut: over the highest wave
        blocks::FrameBlock light{}; ///< lastingLight() of the frame's
        bool cull = true;
    };

    /// True when the map must be drawn: it keeps what it holds until an input, or an option, changes.
    bool isStale(const Inputs& inputs, const HeightsOptions& options) const;

    /// The bed under the cut, and what stands over it: what goes up through the cut is solid there, has no top under
    /// it, and seen from above would be hollow.
    enum class Part { bed, over };
    /// A part seen from above. Its ViewBlock must be bound while it is drawn.
    static View view(const Inputs& inputs, Part part);
    void drawBed(const View& view, SceneRenderer& sceneRenderer, const Inputs& inputs, const HeightsOptions& options,
                 FrameReport::Pass& stats);
    void countSolid(const View& view, SceneRenderer& sceneRenderer, const HeightsOptions& options,
                    FrameReport::Pass& stats);
    /// After both.
    void readHeights(const Inputs& inputs);

    /// From now on this map is it, and none is drawn.
    void take(const HeightMapPicture& picture);
    bool isGiven() const { return given_.has_value(); }
    /// As it is, without its light. Waits for the GPU.
    HeightMapPicture picture() const;

    const HeightField& field() const { return field_; }
    const gl::Texture& heights() const { return heights_; } ///< r32f, with the pyramid of largest heights as its levels
    /// Of the sky, of lamps and of what shines itself.
    const gl::Texture& radiance() const { return given_ ? given_->radiance : map_.colour(0); }
    /// For a unit of the sun's irradiance on a surface that faces it.
    const gl::Texture& response() const { return given_ ? given_->response : map_.colour(1); }

private:
    struct Given {
        gl::Texture radiance, response;
    };
    void uploadHeights();

    gl::Target map_{"heights"};
    gl::Target solid_{"heights solid"};
    gl::Texture heights_;
    HeightField field_;
    std::optional<Inputs> drawn_;
    std::optional<Given> given_;
};

} // namespace tarn
