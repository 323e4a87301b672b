// What the water's surface looks up of the scene: the refraction and the reflection target, for each of its sides that
// a frame shows.
#pragma once

#include "render/frame_context.h"
#include "render/passes/reflection.h"
#include "render/passes/refraction.h"

namespace tarn {

class WaterTargets {
public:
    struct Inputs {
        const Options& options;
        const WaterBody& water;
        const Camera& camera;    ///< of the eye that is drawn
        float aspect = 1.0f;     ///< width / height of the picture
        const SceneVariant& lit; ///< what of the sun's light the passes look up
        vec3 deepRadiance{0.0f};
    };

    /// One side's targets, and the cameras that they were drawn from, in this frame or an earlier one.
    struct Side {
        View refractionView, reflectionView;
        RefractionPass refraction;
        ReflectionPass reflection;
    };

    /// Places the cameras of the sides that the plan shows.
    void begin(const Inputs& inputs, const FramePlan& plan);

    /// Draws what the plan wants and an earlier frame did not leave as it is.
    void draw(const Inputs& inputs, const VisibilityFacts& visibility, FrameContext& context);

    /// Where one side is all that is shown, its; where both are, that of the air.
    const Side& first() const { return first_; }
    /// Of the pixels under water, in a frame that shows both sides.
    const Side& below() const { return below_; }

private:
    /// The cameras that a side's targets are drawn from when this frame draws them.
    struct Views {
        View refraction, reflection;
    };
    Views viewsFor(const Inputs& inputs, bool underwater) const;
    void drawRefraction(const Inputs& inputs, FrameContext& context);
    void drawReflection(const Inputs& inputs, FrameContext& context);

    Side first_, below_;
    Views firstViews_, belowViews_;
};

} // namespace tarn
