#include "plan/refinement.h"

#include <algorithm>
#include <cmath>

namespace tarn {

namespace {

/// The van der Corput sequence: i's digits, mirrored at the point.
float radicalInverse(int i, int base)
{
    float result = 0.0f, digit = 1.0f / static_cast<float>(base);
    for (; i > 0; i /= base, digit /= static_cast<float>(base)) result += digit * static_cast<float>(i % base);
    return result;
}

} // namespace

/// Halton's points of bases 2 and 3, moved round the pixel so that the first is its middle.
float footprintOf(int sample) { return sample > 1 ? 1.0f / std::sqrt(static_cast<float>(Refinement::samples)) : 1.0f; }

vec2 jitterOf(int sample)
{
    const int i = std::max(sample, 1) - 1;
    const vec2 point(radicalInverse(i, 2), radicalInverse(i, 3));
    const vec2 moved = glm::fract(point + 0.5f);
    return moved - 0.5f;
}

namespace {

/// The most accurate rung down to `shown` that is ready and whose frames are predicted to take no longer.
std::size_t rungWithin(double milliseconds, std::size_t shown, const Governor& governor,
                       const Governor::IsReady& isReady)
{
    for (std::size_t i = 0; i < shown; ++i) {
        if (isReady && !isReady(i)) continue;
        const auto predicted = governor.predicted(i);
        if (predicted && *predicted <= milliseconds) return i;
    }
    return shown;
}

} // namespace

Refinement::Step Refinement::next(const Input& input, const Governor& governor, const Governor::IsReady& isReady)
{
    if (input.disturbed || !begun_) touched_ = input.now;
    begun_ = true;
    const double rest = input.now - touched_;
    resting_ = rest >= secondsOfRest;
    if (!resting_ || !input.isStill) {
        rung_ = governor.rung();
        wanted_ = governor.wanted();
        sample_ = 0;
        return {rung_, 0, false};
    }
    if (rung_ > 0) {
        wanted_ = rungWithin(1e3 * rest, rung_, governor, {});
        rung_ = rungWithin(1e3 * rest, rung_, governor, isReady);
        if (rung_ > 0) return {rung_, 0, false}; // where that was drawn already, it is there and costs nothing
    }
    wanted_ = 0;
    if (sample_ >= samples) return {0, samples, true};
    return {0, ++sample_, false};
}

} // namespace tarn
