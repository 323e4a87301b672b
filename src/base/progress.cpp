#include "base/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tarn {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

double clampFraction(double fraction) { return std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : 0.0; }

/// Negative while the work so far says nothing about the rest.
double secondsLeft(double elapsedSeconds, double fraction)
{
    // One per cent or a third of a second is too little to judge by.
    if (fraction < 0.01 || elapsedSeconds < 0.3) return -1.0;
    return elapsedSeconds * (1.0 - fraction) / fraction;
}

constexpr auto clearLine = "\r\x1b[K";

} // namespace

std::string timeLeft(double elapsedSeconds, double fraction)
{
    const double left = secondsLeft(elapsedSeconds, clampFraction(fraction));
    if (left < 0.0) return "";
    if (left < 100.0) return fmt::format("{:.0f} s", std::ceil(left));
    if (left < 100.0 * 60.0) return fmt::format("{:.0f} min", std::ceil(left / 60.0));
    return fmt::format("{:.0f} h", std::ceil(left / 3600.0));
}

TerminalProgress::TerminalProgress() : start_(Clock::now()), isTerminal_(::isatty(STDERR_FILENO) == 1) {}

TerminalProgress::~TerminalProgress()
{
    if (drawn_) std::fputs(clearLine, stderr);
}

void TerminalProgress::report(double fraction, const std::string& what)
{
    if (!isTerminal_) return;
    const auto now = Clock::now();
    // Ten lines a second is all that an eye can use; a terminal that is slow must not slow the work.
    if (drawn_ && now - lastDrawn_ < std::chrono::milliseconds(100)) return;
    lastDrawn_ = now;
    drawn_ = true;

    fraction = clampFraction(fraction);
    constexpr int width = 20;
    const auto filled = static_cast<std::size_t>(std::lround(fraction * width));
    const std::string bar = std::string(filled, '#') + std::string(width - filled, ' ');
    const std::string left = timeLeft(secondsSince(start_), fraction);
    const std::string line =
        fmt::format("[{}] {:3.0f} %  {}{}", bar, fraction * 100.0, left.empty() ? "" : left + " left  ", what);
    std::fprintf(stderr, "%s%.100s", clearLine, line.c_str());
    std::fflush(stderr);
}

void SharedProgress::report(double fraction, const std::string& what)
{
    const std::lock_guard lock(mutex_);
    state_.fraction = clampFraction(fraction);
    state_.what = what;
    state_.secondsLeft = secondsLeft(secondsSince(start_), state_.fraction);
}

SharedProgress::State SharedProgress::state() const
{
    const std::lock_guard lock(mutex_);
    return state_;
}

} // namespace tarn
