#include "measure/trade/trade_json.h"

#include <cmath>

namespace tarn {

using nlohmann::json;

json numberJson(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

double numberFrom(const json& number) { return number.is_number() ? number.get<double>() : ErrorFigures::none; }

json toJson(const ErrorFigures& figures)
{
    json result = json::object();
    for (const FigureField& field : errorFigureFields()) result[field.name] = numberJson(figures.*field.member);
    return result;
}

ErrorFigures figuresFrom(const json& figures)
{
    ErrorFigures result;
    for (const FigureField& field : errorFigureFields())
        if (figures.contains(field.name)) result.*field.member = numberFrom(figures[field.name]);
    return result;
}

json toJson(const Cost& cost)
{
    json passes = json::array();
    for (const Cost::Pass& pass : cost.passes)
        passes.push_back({{"name", pass.name}, {"median_ms", numberJson(pass.median)}});
    return {{"median_ms", numberJson(cost.median)},
            {"p95_ms", numberJson(cost.p95)},
            {"cpu_ms", numberJson(cost.cpu)},
            {"ratio_to_base", numberJson(cost.ratio)},
            {"passes", passes}};
}

Cost costFrom(const json& cost)
{
    Cost result{numberFrom(cost.at("median_ms")),
                numberFrom(cost.at("p95_ms")),
                numberFrom(cost.at("cpu_ms")),
                numberFrom(cost.at("ratio_to_base")),
                {}};
    for (const json& pass : cost.at("passes"))
        result.passes.push_back({pass.at("name").get<std::string>(), numberFrom(pass.at("median_ms"))});
    return result;
}

json toJson(const ErrorBudget& budget)
{
    json rows = json::array();
    for (const ErrorBudget::Row& row : budget.rows)
        rows.push_back({{"part", row.part},
                        {"alone", numberJson(row.alone)},
                        {"removed", numberJson(row.removed)},
                        {"exact", row.exact}});
    return {{"quantity", budget.quantity},
            {"rows", rows},
            {"total", numberJson(budget.total)},
            {"together", numberJson(budget.together)},
            {"remaining", numberJson(budget.remaining)},
            {"noise", numberJson(budget.noise)},
            {"unmodelled", numberJson(budget.unmodelled)}};
}

ErrorBudget budgetFrom(const json& budget)
{
    ErrorBudget result{budget.at("quantity").get<std::string>(), {},
                       numberFrom(budget.at("total")),           numberFrom(budget.at("together")),
                       numberFrom(budget.at("remaining")),       numberFrom(budget.at("noise")),
                       numberFrom(budget.at("unmodelled"))};
    for (const json& row : budget.at("rows"))
        result.rows.push_back({row.at("part").get<std::string>(), numberFrom(row.at("alone")),
                               numberFrom(row.at("removed")), row.at("exact").get<std::string>()});
    return result;
}

} // namespace tarn
