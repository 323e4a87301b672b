#include "app/plan_report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tarn {

nlohmann::json toJson(const FramePlan& plan)
{
    nlohmann::json passes = nlohmann::json::array();
    for (std::size_t i = 0; i < passCount; ++i) {
        const PassPlan& pass = plan.passes[i];
        nlohmann::json entry{
            {"name", passName(static_cast<PassId>(i))}, {"wanted", pass.wanted}, {"reason", pass.reason}};
        if (pass.wanted) {
            entry["size"] = {pass.size.x, pass.size.y};
            entry["reads"] = pass.dependsOn;
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
        if (!pass.dependsOn.empty()) text += fmt::format(" (reads {})", pass.dependsOn);
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
