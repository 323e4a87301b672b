#include "render/frame_context.h"

#include "render/bindings.h"
#include "render/pixel_check.h"

#include <utility>

namespace tarn {

FrameContext::FrameContext(gl::Profiler& p, SceneRenderer& s)
    : profiler(p), sceneRenderer(s), viewBlock(static_cast<int>(BlockIndex::view), "view block")
{}

FrameStats::Pass& FrameContext::beginPass(PassId pass, const View& view, ivec2 size)
{
    viewBlock.update(tarn::viewBlock(view, size));
    return stats.of(passName(pass));
}

void FrameContext::check(PassId pass, const gl::Target& target)
{
    if (!checking) return;
    if (BadPixels found = checkTarget(passName(pass), target); found.any()) bad.push_back(std::move(found));
}

} // namespace tarn
