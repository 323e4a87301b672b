// What one trade is made of, and how its measurements are cut into units.
#pragma once

#include "measure/trade/experiment.h"
#include "measure/trade/plan.h"
#include "measure/trade/store.h"

#include <span>
#include <string>
#include <vector>

namespace tarn {

struct TradeSetup {
    TradePlan plan;
    DescribeSettings describe;
    std::vector<std::string> views; ///< names of cameras
    std::vector<double> times;      ///< s
    bool takesTurns = false;        ///< views take turns at the times, and every second one is timed

    bool isTimed(std::size_t view) const { return !takesTurns || view % 2 == 0; }

    std::vector<std::size_t> timesOf(std::size_t view) const;
    TradeKey about; ///< scene, size, version, base: what the program knows of the run
};

/// `about`, the plan, the views and the times: what results in one folder must have in common.
TradeKey keyOf(const TradeSetup& setup);

/// The smallest piece of work that is stored.
struct TradeUnit {
    enum class Kind { errors, costs, pictures, budget };
    Kind kind = Kind::errors;
    std::vector<TradePoint> points; ///< one; for costs the base and a batch; for a budget the base
    std::size_t view = 0, time = 0; ///< indices

    /// Of its file, without the extension: the same in every run and shard of a trade.
    std::string name() const;
    /// What a person is told while it runs.
    std::string text(const TradeSetup& setup) const;
    /// Roughly how long it takes, in pictures.
    double work() const;
};

/// Points of one batch take turns with the base, which relates batches to each other.
constexpr std::size_t pointsOfBatch = 8;

/// Error and cost units of these points.
std::vector<TradeUnit> measuringUnits(const TradeSetup& setup, std::span<const TradePoint> points);
/// Everything that the report needs beside them: pictures of base and presets, error budgets.
std::vector<TradeUnit> showingUnits(const TradeSetup& setup);

/// Points that are shown as pictures: the base, then the presets.
std::vector<TradePoint> picturedPoints(const TradePlan& plan);

} // namespace tarn
