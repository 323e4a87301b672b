// From one option at a time to combinations that ought to be worth their price.
//
// What an option adds to price and error when it is changed alone is taken for what it adds in company. With
// that, the walk starts with the cheapest value of each option and takes, step by step, the change that
// removes most error for its time. It proposes; what the combinations truly cost is measured afterwards.
#pragma once

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
        double price = 0.0, error = 0.0; ///< NaN: not measured, never taken
    };
    std::string key;
    std::vector<Value> values;
};

struct WalkStep {
    Changes changes;                 ///< a value for every option
    double price = 0.0, error = 0.0; ///< as the sum of the single changes tells, over those of the base
};

/// All steps from the cheapest to the most accurate.
std::vector<WalkStep> greedyWalk(std::span<const SweptOption> options);

/// At most `count` of them, spread evenly, the first and the last among them.
std::vector<WalkStep> thinned(const std::vector<WalkStep>& steps, std::size_t count);

} // namespace tarn
