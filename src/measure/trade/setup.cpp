#include "measure/trade/setup.h"

#include "base/error.h"
#include "base/hash.h"

#include <numeric>

namespace tarn {

TradeKey keyOf(const TradeSetup& setup)
{
    TradeKey key = setup.about;
    key["views"] = fmt::format("{}", fmt::join(setup.views, ", "));
    key["times"] = fmt::format("{}{}", fmt::join(setup.times, ", "), setup.takesTurns ? ", in turns" : "");
    std::string plan = setup.plan.isGreedy ? "with greedy sweep" : "without greedy sweep";
    for (const TradePoint& point : setup.plan.points) plan += fmt::format(" {} {}", point.id, point.origin);
    key["plan"] = plan;
    return key;
}

std::vector<std::size_t> TradeSetup::timesOf(std::size_t view) const
{
    if (takesTurns) return {view % times.size()};
    std::vector<std::size_t> all(times.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

namespace {

std::string batchName(const std::vector<TradePoint>& points)
{
    std::string ids;
    for (const TradePoint& point : points) ids += point.id;
    return fmt::format("{:016x}", fnv1a(ids));
}

std::vector<std::vector<TradePoint>> batchesOf(const TradePoint& base, std::span<const TradePoint> points)
{
    std::vector<std::vector<TradePoint>> batches;
    for (const TradePoint& point : points) {
        if (point.id == base.id) continue;
        if (batches.empty() || batches.back().size() > pointsOfBatch) batches.push_back({base});
        batches.back().push_back(point);
    }
    if (batches.empty()) batches.push_back({base});
    return batches;
}

} // namespace

std::string TradeUnit::name() const
{
    switch (kind) {
    case Kind::errors: return fmt::format("errors-{}-view{}-time{}", points.front().id, view, time);
    case Kind::costs: return fmt::format("costs-{}-view{}", batchName(points), view);
    case Kind::pictures: return fmt::format("pictures-{}-view{}", points.front().id, view);
    case Kind::budget: break;
    }
    return fmt::format("budget-view{}", view);
}

std::string TradeUnit::text(const TradeSetup& setup) const
{
    const std::string& where = setup.views[view];
    switch (kind) {
    case Kind::errors: return fmt::format("errors of {}, {}", points.front().label, where);
    case Kind::costs: return fmt::format("costs of {} settings, {}", points.size(), where);
    case Kind::pictures: return fmt::format("pictures of {}, {}", points.front().label, where);
    case Kind::budget: break;
    }
    return fmt::format("error budget, {}", where);
}

double TradeUnit::work() const
{
    switch (kind) {
    case Kind::errors:
    case Kind::pictures: return 1.0;
    case Kind::costs: return 4.0 * static_cast<double>(points.size());
    case Kind::budget: break;
    }
    return 20.0;
}

std::vector<TradeUnit> measuringUnits(const TradeSetup& setup, std::span<const TradePoint> points)
{
    std::vector<TradeUnit> units;
    // Points change fastest: a reference is made once for a view and a time.
    for (std::size_t view = 0; view < setup.views.size(); ++view)
        for (const std::size_t time : setup.timesOf(view))
            for (const TradePoint& point : points) units.push_back({TradeUnit::Kind::errors, {point}, view, time});
    for (std::size_t view = 0; view < setup.views.size(); ++view) {
        if (!setup.isTimed(view)) continue;
        for (std::vector<TradePoint>& batch : batchesOf(setup.plan.base(), points))
            units.push_back({TradeUnit::Kind::costs, std::move(batch), view, 0});
    }
    return units;
}

std::vector<TradePoint> picturedPoints(const TradePlan& plan)
{
    std::vector<TradePoint> points{plan.base()};
    for (const auto& [name, index] : plan.presets) addPoint(points, plan.points[index]);
    return points;
}

std::vector<TradeUnit> showingUnits(const TradeSetup& setup)
{
    std::vector<TradeUnit> units;
    for (std::size_t view = 0; view < setup.views.size(); ++view) {
        for (const TradePoint& point : picturedPoints(setup.plan))
            units.push_back({TradeUnit::Kind::pictures, {point}, view, 0});
        if (!setup.plan.ladder) units.push_back({TradeUnit::Kind::budget, {setup.plan.base()}, view, 0});
    }
    return units;
}

} // namespace tarn
