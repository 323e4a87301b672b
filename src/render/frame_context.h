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
    FrameStats stats;
    bool checking = false;
    std::vector<BadPixels> bad;

    FrameContext(gl::Profiler& profiler, SceneRenderer& sceneRenderer);

    const FramePlan& plan() const { return stats.plan; }

    /// Makes a view the one that is drawn, into a target of `size` pixels.
    FrameStats::Pass& beginPass(PassId pass, const View& view, ivec2 size);
    /// Looks for values that no target may hold, if the frame is to be checked.
    void check(PassId pass, const gl::Target& target);
};

} // namespace tarn
