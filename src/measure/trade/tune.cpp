#include "measure/trade/tune.h"

#include "base/error.h"
#include "base/progress.h"
#include "measure/statistics.h"
#include "measure/trade/greedy_sweep.h"
#include "measure/trade/setup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>

namespace tarn {

namespace {

constexpr double timeTolerance = 0.02;
constexpr std::array<std::ptrdiff_t, 8> aboutGoal{-64, -16, -4, -1, 0, 4, 16, 64}; ///< predicted ones that are measured
constexpr int mostPasses = 3;                                                      ///< of polishing

bool reaches(const TuneGoal& goal, const Tuned& tuned)
{
    return goal.maxError ? tuned.error <= *goal.maxError : tuned.ms <= *goal.budgetMs;
}

/// Measures points, each once.
class Bench {
public:
    Bench(const TuneRequest& request, TradeExperiment& experiment, Progress* progress)
        : request_(request), experiment_(experiment), progress_(progress), base_(request.candidates.front())
    {}

    /// In the order of the points.
    std::vector<Tuned> measure(const std::vector<TradePoint>& points, const char* what)
    {
        std::vector<TradePoint> wanted;
        for (const TradePoint& point : points)
            if (!find(point.id)) addPoint(wanted, point);
        expected_ += static_cast<double>(wanted.size());
        for (std::size_t i = 0; i < wanted.size(); i += pointsOfBatch) {
            const std::size_t end = std::min(i + pointsOfBatch, wanted.size());
            measureBatch(
                {wanted.begin() + static_cast<std::ptrdiff_t>(i), wanted.begin() + static_cast<std::ptrdiff_t>(end)},
                what);
        }
        std::vector<Tuned> results;
        for (const TradePoint& point : points) results.push_back(*find(point.id));
        return results;
    }

    /// Mean FLIP over the views: much sooner known than a cost.
    double error(const TradePoint& point)
    {
        const auto known = errors_.find(point.id);
        if (known != errors_.end()) return known->second;
        double sum = 0.0;
        for (std::size_t view = 0; view < request_.views; ++view)
            sum += experiment_.errors(point, view, request_.time).flip;
        return errors_[point.id] = sum / static_cast<double>(request_.views);
    }

    /// How many more settings are likely to come, for the progress bar.
    void expect(std::size_t more) { expected_ = static_cast<double>(known_.size() + more); }

    const std::vector<Tuned>& known() const { return known_; }

private:
    const Tuned* find(const std::string& id) const
    {
        const auto found =
            std::find_if(known_.begin(), known_.end(), [&](const Tuned& tuned) { return tuned.point.id == id; });
        return found == known_.end() ? nullptr : &*found;
    }

    void measureBatch(const std::vector<TradePoint>& points, const char* what)
    {
        std::vector<TradePoint> batch{base_}; // relates this batch to the others
        std::vector<Tuned> results;
        for (const TradePoint& point : points) {
            if (point.id != base_.id) batch.push_back(point);
            results.push_back({point, 0.0, error(point)});
        }
        const double views = static_cast<double>(request_.views);
        if (baseMs_.empty()) baseMs_.resize(request_.views);
        for (std::size_t view = 0; view < request_.views; ++view) {
            report(what);
            const std::vector<Cost> costs = experiment_.costs(batch, view);
            baseMs_[view].push_back(costs.front().median);
            const double base = percentile(baseMs_[view], 0.5);
            for (Tuned& result : results) {
                std::size_t at = 0;
                while (batch[at].id != result.point.id) ++at;
                result.ms += costs[at].ratio * base / views;
            }
        }
        known_.insert(known_.end(), results.begin(), results.end());
    }

    void report(const char* what)
    {
        if (progress_) progress_->report(static_cast<double>(known_.size()) / std::max(expected_, 1.0), what);
    }

    const TuneRequest& request_;
    TradeExperiment& experiment_;
    Progress* progress_;
    TradePoint base_;
    std::vector<Tuned> known_;
    std::map<std::string, double> errors_;    ///< by id
    std::vector<std::vector<double>> baseMs_; ///< by view
    double expected_ = 0.0;
};

class Search {
public:
    Search(const TuneRequest& request, TradeExperiment& experiment, Progress* progress)
        : request_(request), bench_(request, experiment, progress)
    {}

    TuneOutcome run()
    {
        std::size_t neighbours = 0;
        for (const Sweep& sweep : request_.sweeps) neighbours += sweep.values.size();
        bench_.expect(request_.candidates.size() + 2 * neighbours + aboutGoal.size());
        for (const Tuned& tuned : bench_.measure(request_.candidates, "measuring the presets")) take(tuned);
        const Tuned start = best_;
        for (const Tuned& tuned : bench_.measure(combined(start), "measuring combinations")) take(tuned);
        for (int pass = 0; pass < mostPasses && polish(); ++pass) {
        }
        return {best_, reaches(request_.goal, best_), bench_.known().size()};
    }

private:
    bool take(const Tuned& tuned)
    {
        if (hasBest_ && !isBetter(request_.goal, tuned, best_)) return false;
        best_ = tuned;
        hasBest_ = true;
        return true;
    }

    std::vector<TradePoint> neighbours(const Tuned& from, const Sweep& sweep) const
    {
        std::vector<TradePoint> points;
        for (const std::string& value : sweep.values) {
            Changes changes = from.point.changes;
            changes[sweep.key] = value;
            points.push_back(makePoint(changes, "", "tune", request_.describe));
        }
        return points;
    }

    /// Around `start`, each option alone; from that the combinations that ought to be near the goal.
    std::vector<TradePoint> combined(const Tuned& start)
    {
        std::vector<SweptOption> options;
        for (const Sweep& sweep : request_.sweeps) {
            SweptOption option{sweep.key, {}};
            const std::vector<Tuned> measured = bench_.measure(neighbours(start, sweep), "one option at a time");
            for (std::size_t i = 0; i < measured.size(); ++i) {
                take(measured[i]);
                option.values.push_back({sweep.values[i], measured[i].ms, measured[i].error});
            }
            options.push_back(std::move(option));
        }
        std::vector<TradePoint> points;
        for (const SweepStep& step : nearGoal(predictedFront(options, {start.ms, start.error}))) {
            Changes changes = start.point.changes;
            for (const auto& [key, value] : step.changes) changes[key] = value;
            points.push_back(makePoint(changes, "", "tune", request_.describe));
        }
        return points;
    }

    /// Those on both sides of where the predictions meet the goal: closely about it, should they be right, and further
    /// and further off, should they not.
    std::vector<SweepStep> nearGoal(const std::vector<SweepStep>& front) const
    {
        const auto meets = std::find_if(front.begin(), front.end(), [&](const SweepStep& step) {
            return request_.goal.maxError ? step.error <= *request_.goal.maxError : step.cost > *request_.goal.budgetMs;
        });
        const auto last = static_cast<std::ptrdiff_t>(front.size()) - 1;
        std::vector<SweepStep> steps;
        for (const std::ptrdiff_t offset : aboutGoal)
            if (const std::ptrdiff_t at = meets - front.begin() + offset; at >= 0 && at <= last)
                steps.push_back(front[static_cast<std::size_t>(at)]);
        return steps;
    }

    /// Whether a setting of this error can beat the best, if only its cost is right.
    bool mayWin(double error) const
    {
        if (request_.goal.budgetMs) return error < best_.error || !reaches(request_.goal, best_);
        return reaches(request_.goal, {{}, 0.0, error}) || error < best_.error;
    }

    /// False when no option helps any more.
    bool polish()
    {
        bool changed = false;
        for (const Sweep& sweep : request_.sweeps) {
            std::vector<TradePoint> points = neighbours(best_, sweep);
            std::erase_if(points, [this](const TradePoint& point) { return !mayWin(bench_.error(point)); });
            for (const Tuned& tuned : bench_.measure(points, "polishing")) changed |= take(tuned);
        }
        return changed;
    }

    const TuneRequest& request_;
    Bench bench_;
    Tuned best_;
    bool hasBest_ = false;
};

} // namespace

bool isBetter(const TuneGoal& goal, const Tuned& a, const Tuned& b)
{
    if (std::isnan(a.ms) || std::isnan(a.error)) return false;
    if (std::isnan(b.ms) || std::isnan(b.error)) return true;
    if (reaches(goal, a) != reaches(goal, b)) return reaches(goal, a);
    const bool wantsTime = reaches(goal, a) == goal.maxError.has_value();
    const bool faster = a.ms < (1.0 - timeTolerance) * b.ms, slower = b.ms < (1.0 - timeTolerance) * a.ms;
    if (wantsTime) return faster || (!slower && a.error < b.error);
    return a.error < b.error || (a.error == b.error && faster);
}

TuneOutcome tune(const TuneRequest& request, TradeExperiment& experiment, Progress* progress)
{
    if (request.candidates.empty() || request.goal.maxError.has_value() == request.goal.budgetMs.has_value())
        throw Error("tuning needs settings to start from and one goal; this is a fault of the program");
    return Search(request, experiment, progress).run();
}

} // namespace tarn
