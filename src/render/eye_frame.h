// One eye's frame as a value: what its passes go by, made before the first of them is drawn and the same until the
// last.
#pragma once

#include "optics/blocks.h"
#include "plan/frame_plan.h"
#include "render/frame.h"
#include "render/gather_visibility.h"
#include "render/view.h"
#include "scene/sky.h"

#include <vector>

namespace tarn {

struct EyeFrame {
    const FrameInput& input; ///< its camera is the eye's
    const Camera& head;      ///< between the eyes: what does not depend on the eye is drawn for it
    const Options& options;
    const WaterBody& water;
    const Bounds& sceneBounds; ///< world
    FramePlan plan;
    VisibilityFacts visibility;
    blocks::FrameBlock light;
    blocks::WavesBlock waves;
    View view;           ///< of the eye; jittered where samples of a pixel are averaged
    ivec2 size{1};       ///< of the target of scene and water, pixels
    float aspect = 1.0f; ///< width / height of the picture
    /// Values of single pixels are shown: no samples to mix, and floats wide enough for positions.
    bool showsRawValues = false;
    bool drawsLookups = true; ///< maps and targets are not as the last frame left them

    bool isBelow() const { return plan.side == WaterSide::below; }       ///< all of the picture begins under water
    bool isCrossing() const { return plan.side == WaterSide::crossing; } ///< some of it does
};

/// What an eye's frame is made from.
struct EyeFrameInputs {
    const Scene& scene;
    const WaterBody& water;
    const Options& options;
    const SkyModel& sky;
    const std::vector<SceneBox>& boxes;
    const Bounds& sceneBounds;         ///< world
    const DepthComplexity* complexity; ///< null: no method is auto
    const FramePlan& lastPlan;         ///< of the frame before
    bool waterWasHidden = false;       ///< VisibilityFacts::waterWasHidden
};

/// Keeps references to what `inputs` refers to, to `input` and to `head`.
EyeFrame makeEyeFrame(const EyeFrameInputs& inputs, const FrameInput& input, const Camera& head);

} // namespace tarn
