// What a trade found, put together from its units: figures and costs of every point, in every view and on
// average.
#pragma once

#include "measure/trade/setup.h"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tarn {

/// A point in one view (mean over the times) or over all of them. NaN where it was not measured.
struct Measured {
    ErrorFigures errors;
    /// Ratio to the base within the batch, times the base's median over all batches: costs of different
    /// batches, and of different machines, are comparable.
    Cost cost{ErrorFigures::none, ErrorFigures::none, ErrorFigures::none, ErrorFigures::none, {}};
};

struct PointResult {
    TradePoint point;
    std::vector<Measured> views; ///< as the setup's
    Measured mean;
    std::vector<std::vector<ErrorFigures>> byTime; ///< [view][time]
};

struct TradeResults {
    std::vector<PointResult> points; ///< the plan's, in its order, then the greedy sweep's
    std::vector<std::string> machines;
    std::vector<std::optional<ErrorBudget>> budgets; ///< one for each view
    std::size_t done = 0, total = 0; ///< units; what is missing in total is not known before the greedy sweep
    bool complete() const { return done == total; }
};

/// Reads what the store holds; what is missing stays NaN. The greedy sweep is there once all points of the plan are
/// measured.
TradeResults collectResults(const TradeSetup& setup, const TradeStore& store);

/// The combined points that these results ask for; empty when the plan wants none. Throws nothing.
std::vector<TradePoint> greedySweepPoints(const TradeSetup& setup, const std::vector<PointResult>& results);

/// The error that the greedy sweep goes by, from the results of the plan's sweeps.
std::function<double(const Measured&)> greedySweepError(const TradeSetup& setup,
                                                        const std::vector<PointResult>& results);

/// One row for each point and view, and one for each point's mean.
std::string toCsv(const TradeSetup& setup, const TradeResults& results);
/// Everything, with Pareto fronts; `command` is the command line.
nlohmann::json toJson(const TradeSetup& setup, const TradeResults& results, const std::string& command);

/// Indices of the points on the front of mean cost against a figure, in view `view` (past the last: the
/// mean).
std::vector<std::size_t> frontOf(const TradeResults& results, const FigureField& figure, std::size_t view);

} // namespace tarn
