// What the water's surface looks up of the scene: the refraction and the reflection target, for each of its sides that
// a frame shows.
#pragma once

#include "render/eye_frame.h"
#include "render/frame_context.h"
#include "render/passes/reflection.h"
#include "render/passes/refraction.h"

namespace tarn {

class WaterTargets {
public:
    /// One side's targets, and the cameras that they were drawn from, in this frame or an earlier one.
    struct Side {
        View refractionView, reflectionView;
        RefractionPass refraction;
        ReflectionPass reflection;
    };

    /// Places the cameras of the sides that the plan shows.
    void begin(const EyeFrame& eye);

    /// Draws what the plan wants and an earlier frame did not leave as it is.
    /// @param lit what of the sun's light the passes look up
    void draw(const EyeFrame& eye, const SceneVariant& lit, FrameContext& context);

    /// Where one side is all that is shown, its; where both are, that of the air.
    const Side& first() const { return first_; }
    /// Of the pixels under water, in a frame that shows both sides.
    const Side& below() const { return below_; }

private:
    /// The cameras that a side's targets are drawn from when this frame draws them.
    struct Views {
        View refraction, reflection;
    };
    Views viewsFor(const EyeFrame& eye, bool underwater) const;
    void drawRefraction(const EyeFrame& eye, const SceneVariant& lit, FrameContext& context);
    void drawReflection(const EyeFrame& eye, const SceneVariant& lit, FrameContext& context);

    Side first_, below_;
    Views firstViews_, belowViews_;
};

} // namespace tarn
