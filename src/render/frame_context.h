// What the passes of a frame share while they are drawn.
#pragma once

#include "gl/buffer.h"
#include "gl/profiler.h"
#include "gl/target.h"
#include "optics/blocks.h"
#include "plan/frame_plan.h"
#include "render/frame.h"
#include "render/frame_cache.h"
#include "render/scene_renderer.h"

#include <vector>

namespace tarn {

struct FrameContext {
    gl::Profiler& profiler;
    SceneRenderer& sceneRenderer;
    gl::UniformBuffer<blocks::ViewBlock> viewBlock;
    FrameCache cache;
    FrameReport report;
    bool checking = false;
    std::vector<BadPixels> bad;

    FrameContext(gl::Profiler& profiler, SceneRenderer& sceneRenderer);

    /// Makes a view the one that is drawn, into a target of `size` pixels.
    FrameReport::Pass& beginPass(PassId pass, const View& view, ivec2 size);
    /// Looks for values that no target may hold, if the frame is to be checked.
    void check(PassId pass, const gl::Target& target);

    /// A rule let a pass stay as an earlier frame left it.
    void noteKept(PassId pass) { kept_.push_back(pass); }
    /// Tells the report what was noted since the last time.
    void reportKept(RuleId rule, const PlanOptions& rules);

private:
    std::vector<PassId> kept_;
};

} // namespace tarn
