// Where settings are measured. The trade's plan, runner and report know only this face of it, so that they
// can be tested without a renderer and without a reference.
#pragma once

#include "measure/error_figures.h"
#include "measure/trade/budget.h"
#include "measure/trade/plan.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tarn {

/// What a frame costs. All in milliseconds.
struct Cost {
    /// Of a frame, wall time. Where targets are drawn in some frames only, which differ by design, the mean stands for
    /// the median, here and in the ratio.
    double median = 0.0, p95 = 0.0;
    double cpu = 0.0;   ///< of the process, median
    double ratio = 1.0; ///< to the first point of the batch, median over frames that were neighbours
    struct Pass {
        std::string name;
        double median = 0.0;
    };
    std::vector<Pass> passes;
};

/// Whole PNG files of one size; empty for one that the experiment cannot make.
struct TradePictures {
    std::string realTime, reference, flip;
};

class TradeExperiment {
public:
    virtual ~TradeExperiment() = default;

    /// The figures of one picture. @param view index of a camera  @param time s
    virtual ErrorFigures errors(const TradePoint& point, std::size_t view, double time) = 0;
    /// All points take turns, so that drift of the machine strikes all alike. One cost for each.
    virtual std::vector<Cost> costs(std::span<const TradePoint> points, std::size_t view) = 0;
    virtual TradePictures pictures(const TradePoint& point, std::size_t view) = 0;
    /// Of the base; nothing when this experiment makes none of this view.
    virtual std::optional<ErrorBudget> budget(std::size_t /*view*/) { return std::nullopt; }
    /// "llvmpipe …; 2 threads": what the costs hold for.
    virtual std::string machine() const = 0;
};

} // namespace tarn
