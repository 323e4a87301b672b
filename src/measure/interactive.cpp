#include "measure/interactive.h"

#include "base/error.h"
#include "measure/statistics.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace tarn {

namespace {

constexpr double msPerSecond = 1e3;

nlohmann::json summaryJson(const std::vector<double>& samples)
{
    const Summary s = summarise(samples);
    return {{"count", s.count}, {"median", s.median}, {"mean", s.mean},
            {"p95", s.p95},     {"p99", s.p99},       {"maximum", s.maximum}};
}

std::string row(const char* name, const std::vector<double>& samples)
{
    const Summary s = summarise(samples);
    return fmt::format("{:<20}{:>10}{:>10.1f}{:>10.1f}{:>10.1f}{:>10.1f}\n", name, s.count, s.median, s.p95, s.p99,
                       s.maximum);
}

} // namespace

InteractiveTimes playInputs(std::span<const double> due, const std::function<double()>& now,
                            const std::function<void(const InteractiveFrame&)>& draw)
{
    if (due.empty()) throw Error("a recording without inputs has no delay to measure");
    if (!std::is_sorted(due.begin(), due.end()) || due.front() < 0.0)
        throw Error("the inputs of a recording must stand in the order of their times, from 0 on");
    InteractiveTimes times;
    const double start = now();
    double lastEnd = 0.0;
    for (std::size_t shown = 0; shown < due.size();) {
        const double begin = now() - start;
        const auto firstLater = std::upper_bound(due.begin() + static_cast<std::ptrdiff_t>(shown), due.end(), begin);
        const auto count = static_cast<std::size_t>(firstLater - due.begin()) - shown;
        draw({shown, count, begin});
        const double end = now() - start;
        times.frameMs.push_back(msPerSecond * (end - lastEnd));
        for (const double moment : due.subspan(shown, count)) times.delayMs.push_back(msPerSecond * (end - moment));
        shown += count;
        lastEnd = end;
    }
    return times;
}

nlohmann::json toJson(const InteractiveTimes& times)
{
    return {{"frame_ms", summaryJson(times.frameMs)}, {"input_to_picture_ms", summaryJson(times.delayMs)}};
}

std::string toTable(const InteractiveTimes& times)
{
    return fmt::format("{:<20}{:>10}{:>10}{:>10}{:>10}{:>10}\n", "", "count", "median", "95 %", "99 %", "most") +
           row("frame, ms", times.frameMs) + row("input to picture, ms", times.delayMs);
}

} // namespace tarn
