#include "measure/trade/results.h"

#include "measure/statistics.h"
#include "measure/trade/greedy_sweep.h"
#include "measure/trade/ladder.h"
#include "measure/trade/pareto.h"
#include "measure/trade/trade_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace tarn {

namespace {

constexpr std::size_t greedySweepLength = 7;

/// Costs of one view by point id, from all its batches.
struct ViewCosts {
    std::map<std::string, Cost> byId;
    std::vector<double> baseMedians;
};

Cost scaled(Cost cost, double factor)
{
    cost.median *= factor;
    cost.p95 *= factor;
    cost.cpu *= factor;
    for (Cost::Pass& pass : cost.passes) pass.median *= factor;
    return cost;
}

void readBatch(const nlohmann::json& json, const std::string& baseId, ViewCosts& costs)
{
    for (const nlohmann::json& entry : json.at("points")) {
        const auto id = entry.at("id").get<std::string>();
        const Cost cost = costFrom(entry.at("cost"));
        if (id == baseId) costs.baseMedians.push_back(cost.median);
        costs.byId.emplace(id, cost);
    }
}

/// As measured in the batch, to as if measured beside the base of all batches.
Cost related(const Cost& cost, const ViewCosts& costs)
{
    const double base = percentile(costs.baseMedians, 0.5);
    return scaled(cost, cost.ratio * base / cost.median);
}

double mean(std::span<const Measured> views, double Cost::*member)
{
    double sum = 0.0;
    for (const Measured& view : views) sum += view.cost.*member;
    return sum / static_cast<double>(views.size());
}

/// Passes that a view does not run cost it nothing.
std::vector<Cost::Pass> meanPasses(std::span<const Measured> views)
{
    std::vector<Cost::Pass> passes;
    for (const Measured& view : views)
        for (const Cost::Pass& pass : view.cost.passes) {
            const auto found = std::find_if(passes.begin(), passes.end(),
                                            [&](const Cost::Pass& other) { return other.name == pass.name; });
            Cost::Pass& sum = found != passes.end() ? *found : passes.emplace_back(Cost::Pass{pass.name, 0.0});
            sum.median += pass.median / static_cast<double>(views.size());
        }
    return passes;
}

/// @param timed those of the views that have costs
Measured meanOf(std::span<const Measured> views, std::span<const Measured> timed)
{
    std::vector<ErrorFigures> figures;
    for (const Measured& view : views) figures.push_back(view.errors);
    Measured result;
    result.errors = meanFigures(figures);
    result.cost = {mean(timed, &Cost::median), mean(timed, &Cost::p95), mean(timed, &Cost::cpu),
                   mean(timed, &Cost::ratio), meanPasses(timed)};
    return result;
}

/// Reads units of points and puts them together.
class Collector {
public:
    Collector(const TradeSetup& setup, const TradeStore& store)
        : setup_(setup), store_(store), costs_(setup.views.size())
    {}

    std::set<std::string> machines;
    std::size_t done = 0, total = 0;

    std::vector<PointResult> collect(std::span<const TradePoint> points)
    {
        std::map<std::string, PointResult> byId;
        for (const TradePoint& point : points) {
            const std::vector<ErrorFigures> unknown(setup_.times.size());
            byId[point.id] = {point, std::vector<Measured>(setup_.views.size()), {}, {setup_.views.size(), unknown}};
        }
        for (const TradeUnit& unit : measuringUnits(setup_, points)) read(unit, byId);
        std::vector<PointResult> results;
        for (const TradePoint& point : points) results.push_back(finished(std::move(byId[point.id])));
        return results;
    }

private:
    void read(const TradeUnit& unit, std::map<std::string, PointResult>& byId)
    {
        ++total;
        const std::string file = unit.name() + ".json";
        if (!store_.has(file)) return;
        ++done;
        const nlohmann::json json = store_.readJson(file);
        if (unit.kind == TradeUnit::Kind::errors) {
            byId[unit.points.front().id].byTime[unit.view][unit.time] = figuresFrom(json.at("figures"));
        } else {
            readBatch(json, setup_.plan.base().id, costs_[unit.view]);
            machines.insert(json.at("machine").get<std::string>());
        }
    }

    PointResult finished(PointResult result) const
    {
        for (std::size_t view = 0; view < setup_.views.size(); ++view) {
            result.views[view].errors = meanFigures(result.byTime[view]);
            const auto cost = costs_[view].byId.find(result.point.id);
            if (cost != costs_[view].byId.end()) result.views[view].cost = related(cost->second, costs_[view]);
        }
        std::vector<Measured> timed;
        for (std::size_t view = 0; view < setup_.views.size(); ++view)
            if (setup_.isTimed(view)) timed.push_back(result.views[view]);
        result.mean = meanOf(result.views, timed);
        return result;
    }

    const TradeSetup& setup_;
    const TradeStore& store_;
    std::vector<ViewCosts> costs_;
};

/// What the greedy sweep calls the error of a setting: mean FLIP and the share of wrong refraction hits, each in parts
/// of how far the swept options move it. FLIP alone takes whatever falls on a bed of one colour for right.
class GreedySweepError {
public:
    GreedySweepError(const TradeSetup& setup, const std::vector<PointResult>& results)
    {
        for (const TradePlan::SweptPoints& swept : setup.plan.sweeps)
            for (const std::size_t point : swept.points)
                for (Term& term : terms_) term.take(results[point].mean.errors.*term.member);
    }

    double operator()(const Measured& measured) const
    {
        double error = 0.0;
        for (const Term& term : terms_)
            if (term.most > term.least) error += measured.errors.*term.member / (term.most - term.least);
        return error;
    }

private:
    struct Term {
        double ErrorFigures::*member;
        double least = std::numeric_limits<double>::infinity();
        double most = -std::numeric_limits<double>::infinity();

        void take(double value)
        {
            if (std::isnan(value)) return; // no view over water, say: then it has no say either
            least = std::min(least, value);
            most = std::max(most, value);
        }
    };
    std::array<Term, 2> terms_{Term{&ErrorFigures::flip}, Term{&ErrorFigures::refractionWrong5cm}};
};

} // namespace

std::vector<TradePoint> greedySweepPoints(const TradeSetup& setup, const std::vector<PointResult>& results)
{
    if (!setup.plan.isGreedy) return {};
    const GreedySweepError errorOf(setup, results);
    if (setup.plan.ladder) return ladderWalk(setup, results, errorOf);
    std::vector<SweptOption> options;
    for (const TradePlan::SweptPoints& swept : setup.plan.sweeps) {
        if (!swept.sweep.with.empty()) continue; // what it adds is not added to any setting of the others
        SweptOption option{swept.sweep.key, {}};
        for (std::size_t i = 0; i < swept.points.size(); ++i) {
            const Measured& measured = results[swept.points[i]].mean;
            option.values.push_back({swept.sweep.values[i], measured.cost.median, errorOf(measured)});
        }
        options.push_back(std::move(option));
    }
    const Measured& base = results.front().mean;
    const std::vector<SweepStep> front = predictedFront(options, {base.cost.median, errorOf(base)});
    std::vector<TradePoint> known = setup.plan.points, combined;
    for (const SweepStep& step : thinned(front, greedySweepLength)) {
        const std::size_t before = known.size();
        const std::string label = fmt::format("greedy {}", combined.size() + 1);
        const std::size_t at = addPoint(known, makePoint(step.changes, label, "greedy", setup.describe));
        if (at == before) combined.push_back(known[at]);
    }
    return combined;
}

std::function<double(const Measured&)> greedySweepError(const TradeSetup& setup,
                                                        const std::vector<PointResult>& results)
{
    return GreedySweepError(setup, results);
}

TradeResults collectResults(const TradeSetup& setup, const TradeStore& store)
{
    Collector collector(setup, store);
    TradeResults results;
    results.points = collector.collect(setup.plan.points);
    if (collector.done == collector.total) {
        const std::vector<TradePoint> combined = greedySweepPoints(setup, results.points);
        if (!combined.empty())
            for (PointResult& result : collector.collect(combined)) results.points.push_back(std::move(result));
    }
    results.machines.assign(collector.machines.begin(), collector.machines.end());
    results.budgets.resize(setup.views.size());
    for (const TradeUnit& unit : showingUnits(setup)) {
        ++collector.total;
        if (!store.has(unit.name() + ".json")) continue;
        ++collector.done;
        if (unit.kind != TradeUnit::Kind::budget) continue;
        const nlohmann::json json = store.readJson(unit.name() + ".json");
        if (!json.is_null()) results.budgets[unit.view] = budgetFrom(json);
    }
    results.done = collector.done;
    results.total = collector.total;
    return results;
}

std::vector<std::size_t> frontOf(const TradeResults& results, const FigureField& figure, std::size_t view)
{
    std::vector<CostedError> points;
    for (const PointResult& result : results.points) {
        const Measured& measured = view < result.views.size() ? result.views[view] : result.mean;
        points.push_back({measured.cost.median, errorOf(figure, measured.errors)});
    }
    return paretoFront(points);
}

} // namespace tarn
