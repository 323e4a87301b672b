// What of the comparison with a reference needs no window: what is shown, and when it can be.
#pragma once

#include "app/reference_view.h"
#include "measure/water_errors.h"

#include <string>

namespace tarn {

enum class ComparisonMode { off, slider, errorMap };

/// A rectangle of the window, its lower corner at the upper left; in the unit that it was asked in.
struct ScreenRect {
    vec2 lower{0.0f}, upper{0.0f};
};

class ComparisonState {
public:
    explicit ComparisonState(const ReferenceView& view) : view_(view) {}

    /// Once per frame: where the eye is, and when.
    void look(const Camera& camera, double time);
    /// The picture is the reference's own: same view, same time.
    bool isAligned() const { return sameView_ && sameTime_; }
    ComparisonMode shown() const { return isAligned() ? mode_ : ComparisonMode::off; }

    /// Key B. Away from the reference's view it asks to go back there: the answer is true. Else the next mode.
    bool next();

    /// By so many steps to the right; it stays in the window.
    void moveSlider(int steps) { setSlider(slider_ + 0.05f * static_cast<float>(steps)); }
    void setSlider(float fraction);
    float slider() const { return slider_; } ///< share of the window's width that is live

    void chooseError(ErrorKind kind) { kind_ = kind; }
    ErrorKind error() const { return kind_; }
    const ReferenceView& view() const { return view_; }

    /// What the picture is beside, and what B would do, for the figures' corner.
    std::string note() const;

private:
    ReferenceView view_;
    ComparisonMode mode_ = ComparisonMode::slider;
    ErrorKind kind_ = ErrorKind::refraction;
    float slider_ = 0.5f;
    bool sameView_ = true, sameTime_ = true;
};

/// Where a picture of the same vertical field of view lies in a window: as high, and about the middle.
ScreenRect overlaid(ivec2 picture, vec2 window);

} // namespace tarn
