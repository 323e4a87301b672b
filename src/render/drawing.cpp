#include "render/drawing.h"

#include "render/bindings.h"
#include "render/pixel_check.h"

#include <utility>

namespace tarn {

Drawing::Drawing(gl::Profiler& p, ScenePainter& s)
    : profiler(p), painter(s), viewBlock(static_cast<int>(BlockIndex::view), "view block")
{}

FrameStats::Pass& Drawing::beginPass(PassId pass, const View& view, ivec2 size)
{
    viewBlock.update(tarn::viewBlock(view, size));
    return stats.of(passName(pass));
}

void Drawing::check(PassId pass, const gl::Target& target)
{
    if (!checking) return;
    if (BadPixels found = checkTarget(passName(pass), target); found.any()) bad.push_back(std::move(found));
}

} // namespace tarn
