// Frame rate and pass times, steadied so that a person can read them.
#pragma once

#include <string>
#include <vector>

namespace tarn {

struct ShownTime {
    std::string name;
    double milliseconds = 0.0;
};

class FrameRate {
public:
    /// Once per frame. A value older than half a second counts little.
    void add(double frameSeconds, const std::vector<ShownTime>& passes);

    double framesPerSecond() const { return frameSeconds_ > 0.0 ? 1.0 / frameSeconds_ : 0.0; }
    double frameMilliseconds() const { return 1e3 * frameSeconds_; }
    /// Of the passes of the newest frame.
    const std::vector<ShownTime>& passes() const { return passes_; }

private:
    double frameSeconds_ = 0.0;
    std::vector<ShownTime> passes_;
};

} // namespace tarn
