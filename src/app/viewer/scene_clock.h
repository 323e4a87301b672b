// The time of the waves: the wall's, less the pauses.
#pragma once

namespace tarn {

class SceneClock {
public:
    explicit SceneClock(double startSeconds) : time_(startSeconds) {}

    /// @param steadySeconds of a clock that never goes back; its zero does not matter
    void advance(double steadySeconds)
    {
        if (started_ && !paused_ && steadySeconds > last_) time_ += steadySeconds - last_;
        last_ = steadySeconds;
        started_ = true;
    }

    /// Stops at a time.
    void holdAt(double seconds)
    {
        time_ = seconds;
        paused_ = true;
    }
    void togglePause() { paused_ = !paused_; }
    bool paused() const { return paused_; }
    double time() const { return time_; } ///< s

private:
    double time_;
    double last_ = 0.0;
    bool started_ = false;
    bool paused_ = false;
};

} // namespace tarn
