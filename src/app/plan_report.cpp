#include "app/plan_report.h"

#include "render/pass_interface.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tarn {

namespace {

/// "sunlight, caustics": whose output a pass reads.
std::string namesReadBy(PassId pass, const FramePlan& plan)
{
    std::string names;
    for (const PassId other : readBy(pass, plan)) names += (names.empty() ? "" : ", ") + std::string(passName(other));
    return names;
}

/// The plan with what came of it.
FramePlan outcome(const FrameReport& report)
{
    FramePlan plan = report.plan;
    plan.rules = report.rules;
    for (std::size_t i = 0; i < passCount; ++i)
        if (report.reused[i])
            plan.passes[i].reason +=
                fmt::format(" ({}.interval: an earlier frame's)", passName(static_cast<PassId>(i)));
    return plan;
}

} // namespace

nlohmann::json toJson(const FrameReport& report) { return toJson(outcome(report)); }

std::string toTable(const FrameReport& report) { return toTable(outcome(report)); }

nlohmann::json toJson(const FramePlan& plan)
{
    nlohmann::json passes = nlohmann::json::array();
    for (std::size_t i = 0; i < passCount; ++i) {
        const PassPlan& pass = plan.passes[i];
        nlohmann::json entry{
            {"name", passName(static_cast<PassId>(i))}, {"wanted", pass.wanted}, {"reason", pass.reason}};
        if (pass.wanted) {
            entry["size"] = {pass.size.x, pass.size.y};
            entry["reads"] = namesReadBy(static_cast<PassId>(i), plan);
        }
        passes.push_back(std::move(entry));
    }
    nlohmann::json rules = nlohmann::json::array();
    for (std::size_t i = 0; i < ruleCount; ++i) {
        const Rule& known = rule(static_cast<RuleId>(i));
        rules.push_back({{"name", known.name},
                         {"applies", plan.rules[i].applies},
                         {"why", plan.rules[i].why},
                         {"leaves_out", known.leavesOut},
                         {"exact", known.bound == nullptr},
                         {"bound", known.bound ? nlohmann::json(known.bound) : nlohmann::json(nullptr)}});
    }
    return {{"underwater", plan.underwater},
            {"crossing", plan.side == WaterSide::crossing},
            {"passes", std::move(passes)},
            {"rules", std::move(rules)}};
}

std::string toTable(const FramePlan& plan)
{
    std::string text = fmt::format("the eye is {}\n", plan.underwater ? "under water" : "above the water");
    if (plan.side == WaterSide::crossing) text += "the surface cuts the near plane: each pixel takes its own side\n";
    for (std::size_t i = 0; i < passCount; ++i) {
        const PassPlan& pass = plan.passes[i];
        const std::string size = pass.wanted ? fmt::format("{}x{}", pass.size.x, pass.size.y) : "";
        text += fmt::format("{:<12}{:<5}{:<12}{}", passName(static_cast<PassId>(i)), pass.wanted ? "yes" : "no", size,
                            pass.reason);
        const std::string reads = namesReadBy(static_cast<PassId>(i), plan);
        if (!reads.empty()) text += fmt::format(" (reads {})", reads);
        text += '\n';
    }
    text += "\nwhat is left out\n";
    for (std::size_t i = 0; i < ruleCount; ++i) {
        const Rule& known = rule(static_cast<RuleId>(i));
        text += fmt::format("{:<22}{:<5}{:<13}{}\n", known.name, plan.rules[i].applies ? "yes" : "no",
                            known.bound ? "approximate" : "exact", plan.rules[i].why);
        if (known.bound) text += fmt::format("{:<40}at most {}\n", "", known.bound);
    }
    return text;
}

} // namespace tarn
