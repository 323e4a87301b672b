#include "app/viewer/comparison_state.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>

namespace tarn {

void ComparisonState::look(const Camera& camera, double time)
{
    sameView_ = isSameView(camera, view_.camera);
    sameTime_ = std::abs(time - view_.time) < 1e-6;
}

bool ComparisonState::next()
{
    if (!isAligned()) return true;
    switch (mode_) {
    case ComparisonMode::off: mode_ = ComparisonMode::slider; break;
    case ComparisonMode::slider: mode_ = ComparisonMode::errorMap; break;
    case ComparisonMode::errorMap: mode_ = ComparisonMode::off; break;
    }
    return false;
}

void ComparisonState::setSlider(float fraction)
{
    if (std::isfinite(fraction)) slider_ = std::clamp(fraction, 0.0f, 1.0f);
}

std::string ComparisonState::note() const
{
    if (!sameView_) return "away from the reference's view; B: back";
    if (!sameTime_) return "the waves have left the reference's time; B: back";
    switch (mode_) {
    case ComparisonMode::off: return "B: beside the reference";
    case ComparisonMode::slider: return "live | reference   [ ]: move   B: errors";
    case ComparisonMode::errorMap: break;
    }
    const ErrorKindInfo& kind = infoOf(kind_);
    return fmt::format("{} error, white from {:g}{}{}   B: live only", kind.name, kind.scale, *kind.unit ? " " : "",
                       kind.unit);
}

ScreenRect overlaid(ivec2 picture, vec2 window)
{
    const float width = window.y * static_cast<float>(picture.x) / static_cast<float>(picture.y);
    const float left = 0.5f * (window.x - width);
    return {{left, 0.0f}, {left + width, window.y}};
}

} // namespace tarn
