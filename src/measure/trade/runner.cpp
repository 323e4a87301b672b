#include "measure/trade/runner.h"

#include "base/error.h"
#include "base/progress.h"
#include "measure/trade/trade_json.h"

#include <algorithm>

namespace tarn {

namespace {

class Runner {
public:
    Runner(const TradeSetup& setup, TradeStore& store, TradeExperiment& experiment, const RunArguments& arguments)
        : setup_(setup), store_(store), experiment_(experiment), arguments_(arguments)
    {}

    std::size_t measured = 0;

    void run(const std::vector<TradeUnit>& units)
    {
        std::vector<const TradeUnit*> missing;
        double work = 0.0;
        for (const TradeUnit* unit : mine(units)) {
            if (store_.has(unit->name() + ".json")) continue;
            missing.push_back(unit);
            work += unit->work();
        }
        double done = 0.0;
        for (const TradeUnit* unit : missing) {
            if (arguments_.stop && arguments_.stop())
                throw Error("stopped; what was measured is in {}, and the same command goes on from there",
                            store_.folder().string());
            if (arguments_.progress) arguments_.progress->report(done / work, unit->text(setup_));
            measure(*unit);
            ++measured;
            done += unit->work();
        }
    }

private:
    /// The shard's part: neighbours, so that few shards make the reference of one view, and as much work as
    /// the others.
    std::vector<const TradeUnit*> mine(const std::vector<TradeUnit>& units) const
    {
        double total = 0.0, before = 0.0;
        for (const TradeUnit& unit : units) total += unit.work();
        std::vector<const TradeUnit*> part;
        for (const TradeUnit& unit : units) {
            const double middle = before + 0.5 * unit.work();
            if (1 + static_cast<int>(middle / total * arguments_.shards) == arguments_.shard) part.push_back(&unit);
            before += unit.work();
        }
        return part;
    }

    void measure(const TradeUnit& unit)
    {
        switch (unit.kind) {
        case TradeUnit::Kind::errors: return measureErrors(unit);
        case TradeUnit::Kind::costs: return measureCosts(unit);
        case TradeUnit::Kind::pictures: return makePictures(unit);
        case TradeUnit::Kind::budget:
            const std::optional<ErrorBudget> budget = experiment_.budget(unit.view);
            return store_.writeJson(unit.name() + ".json", budget ? toJson(*budget) : nlohmann::json(nullptr));
        }
    }

    void measureErrors(const TradeUnit& unit)
    {
        const TradePoint& point = unit.points.front();
        const double time = setup_.times[unit.time];
        const ErrorFigures figures = experiment_.errors(point, unit.view, time);
        store_.writeJson(unit.name() + ".json", {{"id", point.id},
                                                 {"changes", point.changes},
                                                 {"view", setup_.views[unit.view]},
                                                 {"time", time},
                                                 {"figures", toJson(figures)}});
    }

    void measureCosts(const TradeUnit& unit)
    {
        const std::vector<Cost> costs = experiment_.costs(unit.points, unit.view);
        if (costs.size() != unit.points.size())
            throw Error("{} costs for {} settings; this is a fault of the program", costs.size(), unit.points.size());
        nlohmann::json points = nlohmann::json::array();
        for (std::size_t i = 0; i < costs.size(); ++i)
            points.push_back(
                {{"id", unit.points[i].id}, {"changes", unit.points[i].changes}, {"cost", toJson(costs[i])}});
        store_.writeJson(
            unit.name() + ".json",
            {{"machine", experiment_.machine()}, {"view", setup_.views[unit.view]}, {"points", std::move(points)}});
    }

    void makePictures(const TradeUnit& unit)
    {
        const TradePictures pictures = experiment_.pictures(unit.points.front(), unit.view);
        const std::string name = unit.name();
        const auto write = [&](const std::string& file, const std::string& png) {
            if (!png.empty()) store_.write(file, png); // an experiment need not make all three
        };
        write(name + "-realtime.png", pictures.realTime);
        write(name + "-flip.png", pictures.flip);
        write(fmt::format("reference-view{}.png", unit.view), pictures.reference);
        // Last, for it says that the pictures are there.
        store_.writeJson(name + ".json", {{"id", unit.points.front().id}, {"view", setup_.views[unit.view]}});
    }

    const TradeSetup& setup_;
    TradeStore& store_;
    TradeExperiment& experiment_;
    const RunArguments& arguments_;
};

} // namespace

RunOutcome runTrade(const TradeSetup& setup, TradeStore& store, TradeExperiment& experiment,
                    const RunArguments& arguments)
{
    Runner runner(setup, store, experiment, arguments);
    std::vector<TradeUnit> units = measuringUnits(setup, setup.plan.points);
    for (TradeUnit& unit : showingUnits(setup)) units.push_back(std::move(unit));
    // View by view, so that an experiment need not keep more than one reference.
    std::stable_sort(units.begin(), units.end(),
                     [](const TradeUnit& a, const TradeUnit& b) { return a.view < b.view; });
    runner.run(units);

    TradeResults results = collectResults(setup, store);
    std::vector<TradePoint> combined;
    for (std::size_t i = setup.plan.points.size(); i < results.points.size(); ++i)
        combined.push_back(results.points[i].point);
    if (!combined.empty() && !results.complete()) {
        runner.run(measuringUnits(setup, combined));
        results = collectResults(setup, store);
    }
    return {runner.measured, std::move(results)};
}

} // namespace tarn
