// Takes out of a frame's plan what its picture does not need (plan/rules.h).
#pragma once

#include "plan/frame_plan.h"
#include "plan/visibility_facts.h"

namespace tarn {

/// By how much the display's value, 0 to 1, changes at most when `exposed` is added to what is exposed, whatever that
/// is: the tone curve and sRGB are steepest in the dark, but not at its very end.
float displayChange(FrameOptions::ToneCurve curve, float exposed);

/// Applies the rules about passes that the options allow, and notes in plan.rules what became of each.
/// @param visibility null: nothing is known, and no rule that asks for it applies
void reducePlan(FramePlan& plan, const Scene& scene, const WaterBody& water, const Camera& camera,
                const Options& options, ivec2 size, const VisibilityFacts* visibility);

/// The options of a frame that shows raw values of what passes look up: only rules that change none of them.
PlanOptions planForRawValues(PlanOptions plan);

} // namespace tarn
