// How a benchmark is told: JSON for programs, tables for people.
#include "measure/benchmark.h"
#include "measure/statistics.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace tarn {

namespace {

nlohmann::json summaryJson(const std::vector<double>& samples)
{
    if (samples.empty()) return nullptr;
    const Summary s = summarise(samples);
    return {{"count", s.count}, {"minimum", s.minimum}, {"median", s.median},  {"mean", s.mean},
            {"p95", s.p95},     {"p99", s.p99},         {"maximum", s.maximum}};
}

nlohmann::json seriesJson(const BenchSeries& series)
{
    return {{"wall_ms", summaryJson(series.wallMs)},
            {"cpu_ms", summaryJson(series.cpuMs)},
            {"triangles", series.triangles}};
}

nlohmann::json callsJson(const gl::Counters& calls)
{
    nlohmann::json json = nlohmann::json::object();
    for (std::size_t i = 0; i < gl::callCount; ++i) json[std::string(gl::callNames[i])] = calls.calls[i];
    return json;
}

/// Of a and b, drawn next to each other.
nlohmann::json ratioJson(const BenchSeries& a, const BenchSeries& b)
{
    return {{"wall", medianRatio(a.wallMs, b.wallMs)},
            {"cpu", medianRatio(a.cpuMs, b.cpuMs)},
            {"total_wall", totalRatio(a.wallMs, b.wallMs)},
            {"total_cpu", totalRatio(a.cpuMs, b.cpuMs)}};
}

/// "  calls         15 draw calls, 7 program binds": those that there were.
std::string callsLine(const gl::Counters& calls)
{
    std::string text;
    for (std::size_t i = 0; i < gl::callCount; ++i) {
        if (calls.calls[i] == 0) continue;
        std::string name(gl::callNames[i]);
        std::replace(name.begin(), name.end(), '_', ' ');
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", calls.calls[i], name);
    }
    return text.empty() ? "" : fmt::format("  {:<14}{}\n", "calls", text);
}

std::string cell(const std::vector<double>& samples, double fraction)
{
    return samples.empty() ? fmt::format("{:>10}", "-") : fmt::format("{:>10.2f}", percentile(samples, fraction));
}

std::string row(const std::string& name, const BenchSeries& series)
{
    return fmt::format("  {:<14}{}{}{}{}{}{:>12}\n", name, cell(series.wallMs, 0.5), cell(series.wallMs, 0.95),
                       cell(series.wallMs, 0.99), cell(series.cpuMs, 0.5), cell(series.cpuMs, 0.95), series.triangles);
}

std::string resultTable(const BenchResult& result)
{
    std::string text = fmt::format("\n{:<16}{:>10}{:>10}{:>10}{:>10}{:>10}{:>12}\n", result.name, "wall ms", "95 %",
                                   "99 %", "cpu ms", "95 %", "triangles");
    for (const auto& [name, series] : result.passes) text += row(name, series);
    return text + row("frame", result.frame) + callsLine(result.calls);
}

} // namespace

nlohmann::json toJson(const BenchReport& report)
{
    nlohmann::json json;
    for (const auto& [key, value] : report.context) json["context"][key] = value;
    json["frames"] = report.plan.frames;
    json["warm_up"] = report.plan.warmUp;
    json["configurations"] = nlohmann::json::array();
    for (const BenchResult& result : report.results) {
        nlohmann::json entry{
            {"name", result.name}, {"frame", seriesJson(result.frame)}, {"calls", callsJson(result.calls)}};
        if (report.yardstick) entry["yardsticks"] = ratioJson(result.frame, report.yardstick->frame);
        entry["passes"] = nlohmann::json::array();
        for (const auto& [name, series] : result.passes) {
            nlohmann::json pass = seriesJson(series);
            pass["name"] = name;
            entry["passes"].push_back(std::move(pass));
        }
        json["configurations"].push_back(std::move(entry));
    }
    if (report.yardstick)
        json["yardstick"] = {{"frame", seriesJson(report.yardstick->frame)},
                             {"calls", callsJson(report.yardstick->calls)}};
    json["ratios"] = nlohmann::json::array();
    const BenchResult& base = report.results.back();
    for (std::size_t i = 0; i + 1 < report.results.size(); ++i) {
        const BenchResult& result = report.results[i];
        nlohmann::json ratio = ratioJson(result.frame, base.frame);
        ratio["of"] = result.name;
        ratio["to"] = base.name;
        json["ratios"].push_back(std::move(ratio));
    }
    return json;
}

std::string toTable(const BenchReport& report)
{
    std::string text;
    for (const auto& [key, value] : report.context) text += fmt::format("{:<16}{}\n", key, value);
    text += fmt::format("{:<16}{} of each configuration, taking turns, after {} to warm up\n", "frames",
                        report.plan.frames, report.plan.warmUp);
    if (report.yardstick) text += resultTable(*report.yardstick);
    for (const BenchResult& result : report.results) text += resultTable(result);
    const BenchResult& base = report.results.back();
    for (std::size_t i = 0; i + 1 < report.results.size(); ++i) {
        const BenchResult& result = report.results[i];
        text += fmt::format(
            "\n{} costs {:.2f} x {} (wall time) and {:.2f} x (processor time); in all {:.3f} and {:.3f}\n", result.name,
            medianRatio(result.frame.wallMs, base.frame.wallMs), base.name,
            medianRatio(result.frame.cpuMs, base.frame.cpuMs), totalRatio(result.frame.wallMs, base.frame.wallMs),
            totalRatio(result.frame.cpuMs, base.frame.cpuMs));
    }
    return text + yardstickLines(report);
}

std::string yardstickLines(const BenchReport& report)
{
    if (!report.yardstick) return "";
    const BenchSeries& yardstick = report.yardstick->frame;
    std::string text = fmt::format("\nthe yardstick takes {:.1f} ms (wall time) and {:.1f} ms (processor time)\n",
                                   percentile(yardstick.wallMs, 0.5), percentile(yardstick.cpuMs, 0.5));
    for (const BenchResult& result : report.results)
        text += fmt::format("{}: {:.2f} x yardstick (wall time), {:.2f} x (processor time)\n", result.name,
                            medianRatio(result.frame.wallMs, yardstick.wallMs),
                            medianRatio(result.frame.cpuMs, yardstick.cpuMs));
    return text;
}

} // namespace tarn
