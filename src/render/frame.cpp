#include "render/frame.h"

#include <utility>

namespace tarn {

void FrameReport::begin(FramePlan planned)
{
    plan = std::move(planned);
    rules = plan.rules;
    reused.fill(false);
}

std::size_t FrameReport::triangles() const
{
    std::size_t sum = 0;
    for (const Pass& pass : passes) sum += pass.triangles;
    return sum;
}

FrameReport::Pass& FrameReport::of(const std::string& name)
{
    for (Pass& pass : passes)
        if (pass.name == name) return pass;
    return passes.emplace_back(Pass{name, 0, 0});
}

} // namespace tarn
