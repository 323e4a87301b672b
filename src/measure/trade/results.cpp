#include "measure/trade/results.h"

#include "measure/statistics.h"
#include "measure/trade/ladder.h"
#include "measure/trade/pareto.h"
#include "measure/trade/trade_json.h"
#include "measure/trade/walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace tarn {

namespace {

constexpr std::size_t walkLength = 7;

/// Prices of one view by point id, from all its batches.
struct ViewPrices {
    std::map<std::string, Price> byId;
    std::vector<double> baseMedians;
};

Price scaled(Price price, double factor)
{
    price.median *= factor;
    price.p95 *= factor;
    price.cpu *= factor;
    for (Price::Pass& pass : price.passes) pass.median *= factor;
    return price;
}

void readBatch(const nlohmann::json& json, const std::string& baseId, ViewPrices& prices)
{
    for (const nlohmann::json& entry : json.at("points")) {
        const auto id = entry.at("id").get<std::string>();
        const Price price = priceFrom(entry.at("price"));
        if (id == baseId) prices.baseMedians.push_back(price.median);
        prices.byId.emplace(id, price);
    }
}

/// As measured in the batch, to as if measured beside the base of all batches.
Price related(const Price& price, const ViewPrices& prices)
{
    const double base = percentile(prices.baseMedians, 0.5);
    return scaled(price, price.ratio * base / price.median);
}

double mean(std::span<const Measured> views, double Price::*member)
{
    double sum = 0.0;
    for (const Measured& view : views) sum += view.price.*member;
    return sum / static_cast<double>(views.size());
}

/// Passes that a view does not run cost it nothing.
std::vector<Price::Pass> meanPasses(std::span<const Measured> views)
{
    std::vector<Price::Pass> passes;
    for (const Measured& view : views)
        for (const Price::Pass& pass : view.price.passes) {
            const auto found = std::find_if(passes.begin(), passes.end(),
                                            [&](const Price::Pass& other) { return other.name == pass.name; });
            Price::Pass& sum = found != passes.end() ? *found : passes.emplace_back(Price::Pass{pass.name, 0.0});
            sum.median += pass.median / static_cast<double>(views.size());
        }
    return passes;
}

/// @param timed those of the views that have prices
Measured meanOf(std::span<const Measured> views, std::span<const Measured> timed)
{
    std::vector<ErrorFigures> figures;
    for (const Measured& view : views) figures.push_back(view.errors);
    Measured result;
    result.errors = meanFigures(figures);
    result.price = {mean(timed, &Price::median), mean(timed, &Price::p95), mean(timed, &Price::cpu),
                    mean(timed, &Price::ratio), meanPasses(timed)};
    return result;
}

/// Reads units of points and puts them together.
class Collector {
public:
    Collector(const TradeSetup& setup, const TradeStore& store)
        : setup_(setup), store_(store), prices_(setup.views.size())
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
            readBatch(json, setup_.plan.base().id, prices_[unit.view]);
            machines.insert(json.at("machine").get<std::string>());
        }
    }

    PointResult finished(PointResult result) const
    {
        for (std::size_t view = 0; view < setup_.views.size(); ++view) {
            result.views[view].errors = meanFigures(result.byTime[view]);
            const auto price = prices_[view].byId.find(result.point.id);
            if (price != prices_[view].byId.end()) result.views[view].price = related(price->second, prices_[view]);
        }
        std::vector<Measured> timed;
        for (std::size_t view = 0; view < setup_.views.size(); ++view)
            if (setup_.isTimed(view)) timed.push_back(result.views[view]);
        result.mean = meanOf(result.views, timed);
        return result;
    }

    const TradeSetup& setup_;
    const TradeStore& store_;
    std::vector<ViewPrices> prices_;
};

/// What the walk calls the error of a setting: mean FLIP and the share of wrong refraction hits, each in parts
/// of how far the swept options move it. FLIP alone takes whatever falls on a bed of one colour for right.
class WalkError {
public:
    WalkError(const TradeSetup& setup, const std::vector<PointResult>& results)
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

std::vector<TradePoint> walkPoints(const TradeSetup& setup, const std::vector<PointResult>& results)
{
    if (!setup.plan.walk) return {};
    const WalkError errorOf(setup, results);
    if (setup.plan.ladder) return ladderWalk(setup, results, errorOf);
    std::vector<SweptOption> options;
    for (const TradePlan::SweptPoints& swept : setup.plan.sweeps) {
        if (!swept.sweep.with.empty()) continue; // what it adds is not added to any setting of the others
        SweptOption option{swept.sweep.key, {}};
        for (std::size_t i = 0; i < swept.points.size(); ++i) {
            const Measured& measured = results[swept.points[i]].mean;
            option.values.push_back({swept.sweep.values[i], measured.price.median, errorOf(measured)});
        }
        options.push_back(std::move(option));
    }
    const Measured& base = results.front().mean;
    const std::vector<WalkStep> front = predictedFront(options, {base.price.median, errorOf(base)});
    std::vector<TradePoint> known = setup.plan.points, walk;
    for (const WalkStep& step : thinned(front, walkLength)) {
        const std::size_t before = known.size();
        const std::string label = fmt::format("walk {}", walk.size() + 1);
        const std::size_t at = addPoint(known, makePoint(step.changes, label, "walk", setup.describe));
        if (at == before) walk.push_back(known[at]);
    }
    return walk;
}

std::function<double(const Measured&)> walkError(const TradeSetup& setup, const std::vector<PointResult>& results)
{
    return WalkError(setup, results);
}

TradeResults collectResults(const TradeSetup& setup, const TradeStore& store)
{
    Collector collector(setup, store);
    TradeResults results;
    results.points = collector.collect(setup.plan.points);
    if (collector.done == collector.total) {
        const std::vector<TradePoint> walk = walkPoints(setup, results.points);
        if (!walk.empty())
            for (PointResult& result : collector.collect(walk)) results.points.push_back(std::move(result));
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
    std::vector<PricedError> points;
    for (const PointResult& result : results.points) {
        const Measured& measured = view < result.views.size() ? result.views[view] : result.mean;
        points.push_back({measured.price.median, errorOf(figure, measured.errors)});
    }
    return paretoFront(points);
}

} // namespace tarn
