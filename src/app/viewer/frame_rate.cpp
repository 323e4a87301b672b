#include "app/viewer/frame_rate.h"

#include <algorithm>
#include <cmath>

namespace tarn {

namespace {

constexpr double memorySeconds = 0.5;

} // namespace

void FrameRate::add(double frameSeconds, const std::vector<ShownTime>& passes)
{
    if (!(frameSeconds > 0.0)) return;
    const double weight = 1.0 - std::exp(-frameSeconds / memorySeconds);
    const auto blend = [weight](double old, double now) { return old + weight * (now - old); };
    frameSeconds_ = frameSeconds_ > 0.0 ? blend(frameSeconds_, frameSeconds) : frameSeconds;

    std::vector<ShownTime> steadied = passes;
    for (ShownTime& pass : steadied) {
        const auto before =
            std::find_if(passes_.begin(), passes_.end(), [&](const ShownTime& old) { return old.name == pass.name; });
        if (before != passes_.end()) pass.milliseconds = blend(before->milliseconds, pass.milliseconds);
    }
    passes_ = std::move(steadied);
}

} // namespace tarn
