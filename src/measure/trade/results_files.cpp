// results.csv and results.json.
#include "measure/trade/results.h"
#include "measure/trade/trade_json.h"

#include <fmt/format.h>

#include <cmath>

namespace tarn {

namespace {

using nlohmann::json;

/// RFC 4180.
std::string csvText(const std::string& text)
{
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + "\"";
}

/// Empty for what was not measured.
std::string csvNumber(double value) { return std::isfinite(value) ? fmt::format("{:.6g}", value) : ""; }

std::string changesText(const Changes& changes)
{
    std::string text;
    for (const auto& [key, value] : changes) text += fmt::format("{}{}={}", text.empty() ? "" : " ", key, value);
    return text;
}

std::string csvRow(const TradePoint& point, const std::string& view, const Measured& measured)
{
    std::string row =
        fmt::format("{},{},{},{},{},{},{}", point.id, csvText(point.label), point.origin, csvText(view),
                    csvNumber(measured.cost.median), csvNumber(measured.cost.p95), csvNumber(measured.cost.cpu));
    for (const FigureField& field : errorFigureFields())
        row += fmt::format(",{}", csvNumber(measured.errors.*field.member));
    return fmt::format("{},{}\n", row, csvText(changesText(point.changes)));
}

json measuredJson(const Measured& measured)
{
    return {{"cost", toJson(measured.cost)}, {"errors", toJson(measured.errors)}};
}

json pointJson(const TradeSetup& setup, const PointResult& result)
{
    json views = json::array();
    for (std::size_t view = 0; view < result.views.size(); ++view) {
        json entry = measuredJson(result.views[view]);
        entry["view"] = setup.views[view];
        for (std::size_t time = 0; time < setup.times.size(); ++time)
            entry["times"].push_back({{"time", setup.times[time]}, {"errors", toJson(result.byTime[view][time])}});
        views.push_back(std::move(entry));
    }
    return {{"id", result.point.id},           {"label", result.point.label},       {"origin", result.point.origin},
            {"changes", result.point.changes}, {"mean", measuredJson(result.mean)}, {"views", std::move(views)}};
}

/// For each figure the ids of its front: over the mean first, then in each view.
json frontsJson(const TradeSetup& setup, const TradeResults& results)
{
    const auto ids = [&](const std::vector<std::size_t>& front) {
        json list = json::array();
        for (const std::size_t i : front) list.push_back(results.points[i].point.id);
        return list;
    };
    json fronts = json::object();
    for (const FigureField& field : errorFigureFields()) {
        json& front = fronts[field.name];
        front.push_back(ids(frontOf(results, field, setup.views.size())));
        for (std::size_t view = 0; view < setup.views.size(); ++view)
            front.push_back(ids(frontOf(results, field, view)));
    }
    return fronts;
}

json quantitiesJson()
{
    json list = json::array();
    for (const FigureField& field : errorFigureFields())
        list.push_back({{"name", field.name},
                        {"unit", field.unit},
                        {"doc", field.doc},
                        {"smaller_is_better", field.smallerIsBetter}});
    return list;
}

json sweepsJson(const TradePlan& plan)
{
    json list = json::array();
    for (const TradePlan::SweptPoints& swept : plan.sweeps) {
        json ids = json::array();
        for (const std::size_t i : swept.points) ids.push_back(plan.points[i].id);
        list.push_back({{"key", swept.sweep.title()}, {"values", swept.sweep.values}, {"points", std::move(ids)}});
    }
    return list;
}

} // namespace

std::string toCsv(const TradeSetup& setup, const TradeResults& results)
{
    std::string csv = "id,label,origin,view,median_ms,p95_ms,cpu_ms";
    for (const FigureField& field : errorFigureFields()) csv += fmt::format(",{}", field.name);
    csv += ",changes\n";
    for (const PointResult& result : results.points) {
        csv += csvRow(result.point, "mean", result.mean);
        for (std::size_t view = 0; view < setup.views.size(); ++view)
            csv += csvRow(result.point, setup.views[view], result.views[view]);
    }
    return csv;
}

json toJson(const TradeSetup& setup, const TradeResults& results, const std::string& command)
{
    json about = setup.about;
    json base = json::object();
    for (const FieldRow& row : setup.describe({}, "base")) base[row.key] = row.value;
    json points = json::array();
    for (const PointResult& result : results.points) points.push_back(pointJson(setup, result));
    json presets = json::array();
    for (const auto& [name, index] : setup.plan.presets)
        presets.push_back({{"name", name}, {"point", setup.plan.points[index].id}});
    json budgets = json::array();
    for (const auto& budget : results.budgets) budgets.push_back(budget ? toJson(*budget) : json(nullptr));
    return {{"about", about},
            {"command", command},
            {"machines", results.machines},
            {"views", setup.views},
            {"times", setup.times},
            {"base", base},
            {"quantities", quantitiesJson()},
            {"points", std::move(points)},
            {"sweeps", sweepsJson(setup.plan)},
            {"presets", std::move(presets)},
            {"fronts", frontsJson(setup, results)},
            {"budgets", std::move(budgets)}};
}

} // namespace tarn
