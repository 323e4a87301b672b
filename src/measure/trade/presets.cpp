#include "measure/trade/presets.h"

#include "base/error.h"
#include "measure/trade/pareto.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace tarn {

namespace {

const FigureField& flipField()
{
    for (const FigureField& field : errorFigureFields())
        if (field.member == &ErrorFigures::flip) return field;
    throw Error("there is no figure for FLIP; this is a fault of the program");
}

/// What the thesis' settings cost and get wrong, where the plan has them.
std::optional<CostedError> thesisPoint(const TradeSetup& setup, const TradeResults& results)
{
    for (const auto& [name, index] : setup.plan.presets) {
        const CostedError point{results.points[index].mean.cost.median, results.points[index].mean.errors.flip};
        if (name == "thesis" && !std::isnan(point.cost) && !std::isnan(point.error)) return point;
    }
    return {};
}

/// Keys in the order of `tarn options`, so that those of one group stand together.
std::vector<std::string> presetKeys(const TradePlan& plan, const std::vector<FieldRow>& rows)
{
    std::set<std::string> wanted;
    for (const TradePlan::SweptPoints& swept : plan.sweeps) wanted.insert(swept.sweep.key);
    for (const TradePoint& point : plan.points)
        for (const auto& [key, value] : point.changes) wanted.insert(key);
    std::vector<std::string> keys;
    for (const FieldRow& row : rows)
        if (wanted.count(row.key) > 0) keys.push_back(row.key);
    return keys;
}

} // namespace

std::string tomlString(const std::string& text)
{
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return quoted + '"';
}

std::string tomlValue(const FieldRow& row)
{
    if (row.type == "choice") return "\"" + row.value + "\"";
    if (row.type == "vec2" || row.type == "vec3") return "[" + row.value + "]";
    return row.value;
}

std::vector<PresetPick> pickPresets(const TradeSetup& setup, const TradeResults& results)
{
    const std::vector<std::size_t> front = frontOf(results, flipField(), setup.views.size());
    if (front.empty()) throw Error("no presets: no setting has both a cost and a mean FLIP");
    const auto cost = [&](std::size_t i) { return results.points[i].mean.cost.median; };

    const auto flip = [&](std::size_t i) { return results.points[i].mean.errors.flip; };

    std::size_t fast = front.front(), low = front.front();
    if (const std::optional<CostedError> thesis = thesisPoint(setup, results)) {
        for (const std::size_t i : front) // errors fall along the front
            if (cost(i) <= thesis->cost) low = i;
        const auto first =
            std::find_if(front.begin(), front.end(), [&](std::size_t i) { return flip(i) <= thesis->error; });
        if (first != front.end()) fast = *first;
    }
    if (setup.plan.ladder) return {{"fast", fast}}; // nothing dearer than the base was measured
    const std::size_t best = front.back();
    const auto below = [&](double part) {
        const double rounding = 1.0 + 1e-9;
        const double limit = rounding * cost(low) * std::pow(cost(best) / cost(low), part);
        std::size_t found = low;
        for (const std::size_t i : front)
            if (cost(i) >= cost(low) && cost(i) <= limit) found = i;
        return found;
    };
    return {{"fast", fast}, {"low", low}, {"medium", below(1.0 / 3.0)}, {"high", below(2.0 / 3.0)}, {"best", best}};
}

std::string optionsText(const std::vector<FieldRow>& rows, const std::vector<std::string>& keys)
{
    // A table stands once in a TOML file, though the options of one group may not stand together.
    std::vector<std::pair<std::string, std::string>> groups;
    for (const FieldRow& row : rows) {
        if (std::find(keys.begin(), keys.end(), row.key) == keys.end()) continue;
        const std::size_t dot = row.key.rfind('.');
        const std::string name = row.key.substr(0, dot);
        auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == name; });
        if (group == groups.end()) group = groups.insert(groups.end(), {name, fmt::format("\n[{}]\n", name)});
        group->second += fmt::format("{} = {}\n", row.key.substr(dot + 1), tomlValue(row));
    }
    std::string text;
    for (const auto& [name, lines] : groups) text += lines;
    return text;
}

std::string measuredText(const Measured& measured)
{
    std::string text = fmt::format("{:.1f} ms a frame, mean FLIP {:.4f}", measured.cost.median, measured.errors.flip);
    if (!std::isnan(measured.errors.refractionMedian))
        text += fmt::format(", refraction hit error {:.3g} m (median)", measured.errors.refractionMedian);
    return text;
}

std::string presetText(const TradeSetup& setup, const TradePoint& point, const std::vector<std::string>& comment)
{
    std::string text;
    for (const std::string& line : comment) text += fmt::format("# {}\n", line);
    const std::vector<FieldRow> rows = setup.describe(point.changes, "preset");
    return text + optionsText(rows, presetKeys(setup.plan, rows));
}

} // namespace tarn
