// From one option at a time to combinations that ought to be worth their cost.
//
// What an option adds to cost and error when it is changed alone is taken for what it adds in company. The
// greedy sweep is the Pareto front of all combinations under that assumption. It proposes; what the combinations
// truly cost is measured afterwards.
#pragma once

#include "measure/trade/pareto.h"
#include "measure/trade/sweep.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace tarn {

/// One option around the base, as measured.
struct SweptOption {
    struct Value {
        std::string value;
        double cost = 0.0, error = 0.0; ///< NaN: not measured, never taken
    };
    std::string key;
    std::vector<Value> values;
};

struct SweepStep {
    Changes changes;                ///< a value for every option
    double cost = 0.0, error = 0.0; ///< the base's, and what each option adds to it
};

/// Along the predicted front, from the cheapest to the most accurate. Of steps whose costs differ by less
/// than a thousandth of all that there is between them, only the most accurate is there.
std::vector<SweepStep> predictedFront(std::span<const SweptOption> options, const CostedError& base);

/// At most `count` of them, the first and the last among them, spread evenly over the front as it is drawn:
/// along its length, with both axes as long as the front.
std::vector<SweepStep> thinned(const std::vector<SweepStep>& steps, std::size_t count);

} // namespace tarn
