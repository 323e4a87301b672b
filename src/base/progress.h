// How far a long piece of work has come: a bar on the terminal, a bar in the window, or nothing.
#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <string>

namespace tarn {

/// The worker reports, a watcher on any thread reads. Throws nothing, except where it is there to end the work.
class Progress {
public:
    virtual ~Progress() = default;
    /// @param fraction 0 to 1   @param what "reading trees.obj"
    virtual void report(double fraction, const std::string& what) = 0;
};

/// Draws one line "[#####     ] 47 %  12 s left  reading trees.obj" on standard error when that is a terminal,
/// and nothing otherwise. The line is cleared on destruction.
class TerminalProgress : public Progress {
public:
    TerminalProgress();
    ~TerminalProgress() override;
    void report(double fraction, const std::string& what) override;

private:
    std::chrono::steady_clock::time_point start_;
    std::chrono::steady_clock::time_point lastDrawn_{};
    bool isTerminal_;
    bool drawn_ = false;
};

/// Keeps the latest report for another thread, which draws it.
class SharedProgress : public Progress {
public:
    void report(double fraction, const std::string& what) override;
    struct State {
        double fraction = 0.0;
        std::string what;
        double secondsLeft = -1.0; ///< negative: not known yet
    };
    State state() const;

private:
    mutable std::mutex mutex_;
    State state_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// "12 s", "3 min", from how long the work has taken so far; "" while that says nothing yet.
std::string timeLeft(double elapsedSeconds, double fraction);

} // namespace tarn
