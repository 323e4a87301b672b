#include "render/frame_context.h"

#include "render/bindings.h"
#include "render/pixel_check.h"

#include <utility>

namespace tarn {

FrameContext::FrameContext(gl::Profiler& p, SceneRenderer& s)
    : profiler(p), sceneRenderer(s), viewBlock(static_cast<int>(BlockIndex::view), "view block")
{}

FrameReport::Pass& FrameContext::beginPass(PassId pass, const View& view, ivec2 size)
{
    viewBlock.update(tarn::viewBlock(view, size));
    return report.of(passName(pass));
}

void FrameContext::reportKept(RuleId rule, const PlanOptions& rules)
{
    const std::vector<PassId> kept = std::exchange(kept_, {});
    if (!rules.allows(rule)) return; // the plan says so
    std::string names;
    for (const PassId pass : kept) names += (names.empty() ? "" : ", ") + std::string(passName(pass));
    report.rule(rule) = names.empty() ? RuleState{false, "nothing is as an earlier frame left it"}
                                      : RuleState{true, "as an earlier frame left it: " + names};
}

void FrameContext::check(PassId pass, const gl::Target& target)
{
    if (!checking) return;
    if (BadPixels found = checkTarget(passName(pass), target); found.any()) bad.push_back(std::move(found));
}

} // namespace tarn
