// A ladder for the governor (plan/ladder.h), out of a trade of its own.
//
// The plan sweeps, one at a time, what makes a frame cheaper than the base. The greedy sweep combines: sizes and counts
// freely, but of what needs programs of its own (plan/ladder.h, isSizeOnly) only few sets, so that moving along the
// ladder seldom changes programs. What it proposes is measured; the rungs are the front of that.
#pragma once

#include "measure/trade/results.h"
#include "plan/ladder.h"

#include <string>
#include <vector>

namespace tarn {

/// Of options that trade accuracy for time, the values that are cheaper than the base's.
std::vector<Sweep> cheaperSweeps(const DescribeSettings& describe);

/// The combinations that may become rungs, from the sweeps' results. @param errorOf of a point, on any one scale
std::vector<TradePoint> ladderWalk(const TradeSetup& setup, const std::vector<PointResult>& results,
                                   const std::function<double(const Measured&)>& errorOf);

/// From the base down the front of time against error; a rung costs clearly less than the one before. An error that was
/// measured to be smaller than a dearer rung's is written as that one's. Throws Error when nothing is cheaper than the
/// base.
Ladder pickLadder(const TradeSetup& setup, const TradeResults& results,
                  const std::function<double(const Measured&)>& errorOf);

/// The file's text. @param comment lines at its head
std::string ladderText(const TradeSetup& setup, const Ladder& ladder, const std::vector<std::string>& comment);

} // namespace tarn
