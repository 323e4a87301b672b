#include "app/plan_report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tarn
{

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
    return {{"underwater", plan.underwater},
            {"crossing", plan.side == WaterSide::crossing},
            {"passes", std::move(passes)}};
}

std::string toTable(const FramePlan& plan)
{
    std::string text = fmt::format("the eye is {}\n", plan.underwater ? "under water" : "above the water");
    if (plan.side == WaterSide::crossing) text += "the surface cuts the near plane: each pixel takes its own side\n";
    for (std::size_t i = 0; i < passCount; ++i) {
        const PassPlan& pass = plan.passes[i];
        const std::string size = pass.wanted ? fmt::format("{}x{}", pass.size.x, pass.size.y) : "";
        text += fmt::format("{:<12}{:<5}{:<12}{}", passName(static_cast<PassId>(i)),
                            pass.wanted ? "yes" : "no", size, pass.reason);
        if (!pass.dependsOn.empty()) text += fmt::format(" (reads {})", pass.dependsOn);
        text += '\n';
    }
    return text;
}

} // namespace tarn
