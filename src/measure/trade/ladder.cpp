#include "measure/trade/ladder.h"

#include "base/error.h"
#include "measure/trade/greedy_sweep.h"
#include "measure/trade/pareto.h"
#include "measure/trade/presets.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace tarn {

namespace {

constexpr std::size_t combinations = 14; // measured
constexpr std::size_t programSets = 3;   // beside the base's
constexpr double clearlyLess = 0.93;     // of the cost of the rung before

/// From the dearest to the cheapest.
std::vector<std::string> sweepTexts()
{
    return {"frame.antialiasing=fxaa,none",
            "frame.scale=0.77,0.67,0.5,0.35",
            "sunlight.cascades=1",
            "sunlight.taps=1",
            "sunlight.map_size=1024,512",
            "water.surface_steps=1,0",
            "water.normals=vertex",
            "water.grid_size=33,17",
            "refraction.steps=2,1",
            "refraction.target_size=256,128",
            "refraction.interval=2,4",
            "reflection.facets=three,one",
            "reflection.target_size=256,128",
            "reflection.interval=2,4",
            "caustics.texture_size=256,128",
            "caustics.photons=256,128", // fewer leave a pattern on the near bed that a person sees and FLIP hardly does
            "caustics.interval=2,4"};
}

/// Which side of the base's value is the cheaper one: that to which the values go, or, of one value, that where it
/// lies.
bool isCheaper(const Sweep& sweep, const std::string& value, double base)
{
    const double first = rankAt(sweep.key, sweep.values.front()), last = rankAt(sweep.key, sweep.values.back());
    const double direction = sweep.values.size() > 1 ? last - first : first - base;
    return (rankAt(sweep.key, value) - base) * direction > 0.0;
}

/// A swept option with the base's own value among those that a greedy sweep may choose.
SweptOption optionOf(const TradePlan::SweptPoints& swept, const std::vector<PointResult>& results,
                     const CostedError& base, const std::function<double(const Measured&)>& errorOf)
{
    SweptOption option{swept.sweep.key, {{"", base.cost, base.error}}};
    for (std::size_t i = 0; i < swept.points.size(); ++i) {
        const Measured& measured = results[swept.points[i]].mean;
        option.values.push_back({swept.sweep.values[i], measured.cost.median, errorOf(measured)});
    }
    return option;
}

/// Without the options that stay the base's.
Changes changed(Changes changes)
{
    std::erase_if(changes, [](const auto& entry) { return entry.second.empty(); });
    return changes;
}

bool onlySizes(const Changes& changes)
{
    return std::all_of(changes.begin(), changes.end(), [](const auto& entry) { return isSizeOnly(entry.first); });
}

} // namespace

std::vector<Sweep> cheaperSweeps(const DescribeSettings& describe)
{
    std::map<std::string, std::string> base;
    for (const FieldRow& row : describe({}, "ladder")) base[row.key] = row.value;
    std::vector<Sweep> sweeps;
    for (Sweep& sweep : parseSweeps(sweepTexts(), describe)) {
        const double rank = rankAt(sweep.key, base.at(sweep.key));
        std::vector<std::string> cheaper;
        for (const std::string& value : sweep.values)
            if (isCheaper(sweep, value, rank)) cheaper.push_back(value);
        if (cheaper.empty()) continue;
        sweep.values = std::move(cheaper);
        sweeps.push_back(std::move(sweep));
    }
    return sweeps;
}

std::vector<TradePoint> ladderWalk(const TradeSetup& setup, const std::vector<PointResult>& results,
                                   const std::function<double(const Measured&)>& errorOf)
{
    const CostedError base{results.front().mean.cost.median, errorOf(results.front().mean)};
    std::vector<SweptOption> sizes, programs;
    for (const TradePlan::SweptPoints& swept : setup.plan.sweeps)
        (isSizeOnly(swept.sweep.key) ? sizes : programs).push_back(optionOf(swept, results, base, errorOf));

    // Few sets of programs, which the sweep of sizes takes for the values of one more option.
    const std::vector<SweepStep> sets = thinned(predictedFront(programs, base), programSets);
    SweptOption set{"programs", {{"", base.cost, base.error}}};
    for (std::size_t i = 0; i < sets.size(); ++i)
        set.values.push_back({std::to_string(i), sets[i].cost, sets[i].error});
    sizes.push_back(set);

    std::vector<TradePoint> known = setup.plan.points, combined;
    for (const SweepStep& step : thinned(predictedFront(sizes, base), combinations)) {
        Changes changes = step.changes;
        if (const auto chosen = changes.find(set.key); chosen != changes.end()) {
            const std::string index = chosen->second;
            changes.erase(chosen);
            if (!index.empty()) changes.merge(Changes(sets[std::stoul(index)].changes));
        }
        const std::size_t before = known.size();
        const std::string label = fmt::format("greedy {}", combined.size() + 1);
        const std::size_t at = addPoint(known, makePoint(changed(changes), label, "greedy", setup.describe));
        if (at == before) combined.push_back(known[at]);
    }
    return combined;
}

Ladder pickLadder(const TradeSetup& setup, const TradeResults& results,
                  const std::function<double(const Measured&)>& errorOf)
{
    const PointResult& base = results.points.front();
    std::vector<const PointResult*> candidates{&base};
    std::vector<CostedError> costed{{base.mean.cost.median, errorOf(base.mean)}};
    for (const PointResult& result : results.points) {
        const bool mayBeRung = result.point.origin == "greedy" || onlySizes(result.point.changes);
        if (!mayBeRung || &result == &base || !(result.mean.cost.median < base.mean.cost.median)) continue;
        candidates.push_back(&result);
        costed.push_back({result.mean.cost.median, errorOf(result.mean)});
    }
    Ladder ladder;
    ladder.rungs.push_back(
        {{}, 1.0, base.mean.cost.median, base.mean.errors.flip, base.mean.errors.refractionWrong5cm});
    std::vector<std::size_t> front = paretoFront(costed);
    std::reverse(front.begin(), front.end()); // from the most accurate
    for (const std::size_t i : front) {
        const Measured& measured = candidates[i]->mean;
        const Rung above = ladder.rungs.back();
        const double cost = measured.cost.median / base.mean.cost.median;
        if (cost > clearlyLess * above.cost) continue;
        ladder.rungs.push_back({candidates[i]->point.changes, cost, measured.cost.median,
                                std::max(measured.errors.flip, above.flip),
                                std::max(measured.errors.refractionWrong5cm, above.wrongHits)});
    }
    if (ladder.rungs.size() < 2)
        throw Error("no ladder: nothing that was measured is cheaper than the settings themselves");
    // A scene without water has no hits to be wrong.
    for (Rung& rung : ladder.rungs)
        if (std::isnan(rung.wrongHits)) rung.wrongHits = 0.0;
    for (const FieldRow& row : setup.describe({}, "ladder"))
        for (const Rung& rung : ladder.rungs)
            if (rung.settings.contains(row.key)) ladder.base[row.key] = row.value;
    return ladder;
}

std::string ladderText(const TradeSetup& setup, const Ladder& ladder, const std::vector<std::string>& comment)
{
    const auto settings = [&](const OptionValues& values) {
        std::string lines;
        for (const FieldRow& row : setup.describe(values, "ladder"))
            if (values.contains(row.key)) lines += fmt::format("{} = {}\n", row.key, tomlValue(row));
        return lines;
    };
    std::string text;
    for (const std::string& line : comment) text += fmt::format("# {}\n", line);
    text += fmt::format("\nscene = {}\nsize = {}\nmachine = {}\n", tomlString(ladder.scene), tomlString(ladder.size),
                        tomlString(ladder.machine));
    text += "\n[base]\n" + settings(ladder.base);
    for (const Rung& rung : ladder.rungs) {
        text += fmt::format("\n[[rungs]]\ncost = {:.4f}\nmilliseconds = {:.1f}\nflip = {:.4f}\nwrong_hits = {:.4f}\n",
                            rung.cost, rung.milliseconds, rung.flip, rung.wrongHits);
        if (!rung.settings.empty()) text += "[rungs.settings]\n" + settings(rung.settings);
    }
    return text;
}

} // namespace tarn
