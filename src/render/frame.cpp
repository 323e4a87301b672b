#include "render/frame.h"

namespace tarn {

std::size_t FrameStats::triangles() const
{
    std::size_t sum = 0;
    for (const Pass& pass : passes) sum += pass.triangles;
    return sum;
}

FrameStats::Pass& FrameStats::of(const std::string& name)
{
    for (Pass& pass : passes)
        if (pass.name == name) return pass;
    return passes.emplace_back(Pass{name, 0, 0});
}

} // namespace tarn
