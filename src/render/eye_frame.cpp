#include "render/eye_frame.h"

#include "plan/reduce.h"
#include "plan/refinement.h"
#include "render/frame_light.h"

namespace tarn {

namespace {

/// Whether a frame runs a pass that the one before did not, or may not have.
bool wantsMore(const FramePlan& plan, const FramePlan& before)
{
    if (before.rule(RuleId::waterHidden).applies) return true;
    for (std::size_t i = 0; i < passCount; ++i)
        if (plan.passes[i].wanted && !before.passes[i].wanted) return true;
    return plan.mirrorBounds != before.mirrorBounds;
}

/// Moves a view within a pixel.
/// @param sample of those that are averaged, from 1
void jitter(View& view, int sample, ivec2 size)
{
    view.clipFromView =
        glm::translate(mat4(1.0f), vec3(2.0f * jitterOf(sample) / vec2(size), 0.0f)) * view.clipFromView;
}

} // namespace

EyeFrame makeEyeFrame(const EyeFrameInputs& inputs, const FrameInput& input, const Camera& head)
{
    const Options& options = inputs.options;
    const WaterBody& water = inputs.water;
    EyeFrame eye{.input = input,
                 .head = head,
                 .options = options,
                 .water = water,
                 .sceneBounds = inputs.sceneBounds,
                 .plan = {},
                 .visibility = {},
                 .light = frameBlock(inputs.scene, water, inputs.sky, options),
                 .waves = wavesBlock(water, input.time),
                 .view = {}};
    eye.aspect = static_cast<float>(input.size.x) / static_cast<float>(input.size.y);
    eye.showsRawValues = input.view != DebugView::final;
    const int sample = options.stereo.isOn() || eye.showsRawValues ? 0 : input.sample;

    Options allowed = options;
    if (eye.showsRawValues) allowed.plan = planForRawValues(options.plan);
    // The samples of an edge's pixels look things up half a pixel beyond what is bounded for their middles.
    if (sample > 0) allowed.plan.rules[static_cast<std::size_t>(RuleId::targetBounds)] = false;
    eye.visibility = gatherVisibility(inputs.boxes, inputs.scene, water, input.camera, input.size, allowed, eye.light);
    eye.visibility.waterWasHidden = inputs.waterWasHidden;
    eye.plan = planFrame(inputs.scene, water, input.camera, allowed, input.size, input.time, inputs.complexity,
                         &eye.visibility);
    // What the last frame left out, a debug view of the same time may want to show.
    eye.drawsLookups = !input.sameMoment || wantsMore(eye.plan, inputs.lastPlan);
    for (std::size_t axis = 0; axis < 2; ++axis) eye.light.waterGrid[axis] = narrowed(eye.plan.waterGrid[axis]);

    const ivec2 sceneSize = eye.plan[PassId::scene].size;
    // A mean of raw values is none: a position between two others, a normal that is no longer of unit length.
    eye.size = eye.showsRawValues ? input.size : sceneSize;
    eye.view = mainView(input.camera, eye.aspect);
    if (sample > 0) jitter(eye.view, sample, glm::min(input.size, sceneSize));
    // How far off geometry may be. The maps of heights hold full detail: what marches through them goes closer.
    eye.view.geometryError = geometryErrorOf(eye.view, sceneSize, options.detail.pixels);
    return eye;
}

} // namespace tarn
