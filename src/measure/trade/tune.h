// The cheapest settings that are accurate enough, or the most accurate that are fast enough, on this machine.
//
// The search measures the candidates it is given, then every option alone around the best of them. What that
// tells predicts combinations (measure/trade/greedy_sweep.h); those near the goal are measured, and the best is
// polished by changing one option at a time until no change helps.
#pragma once

#include "measure/trade/experiment.h"
#include "measure/trade/sweep.h"

#include <optional>
#include <vector>

namespace tarn {

class Progress;

/// Exactly one of the two.
struct TuneGoal {
    std::optional<double> maxError; ///< mean FLIP: then the cheapest
    std::optional<double> budgetMs; ///< a frame: then the most accurate
};

struct Tuned {
    TradePoint point;
    double ms = 0.0;    ///< median, mean over the views
    double error = 0.0; ///< mean FLIP over the views
};

struct TuneRequest {
    TuneGoal goal;
    std::vector<TradePoint> candidates; ///< the base first
    std::vector<Sweep> sweeps;
    DescribeSettings describe;
    std::size_t views = 1;
    double time = 0.0; ///< s
};

struct TuneOutcome {
    Tuned best; ///< the nearest to the goal when it was not reached
    bool reached = false;
    std::size_t tried = 0; ///< settings that were measured
};

TuneOutcome tune(const TuneRequest& request, TradeExperiment& experiment, Progress* progress = nullptr);

/// Whether `a` serves the goal better than `b`. Times within 2 % are equal: that much is chance.
bool isBetter(const TuneGoal& goal, const Tuned& a, const Tuned& b);

} // namespace tarn
