// Runs a trade: every unit that is not in the store yet, once.
#pragma once

#include "measure/trade/results.h"

#include <functional>

namespace tarn {

class Progress;

struct RunArguments {
    int shard = 1, shards = 1;  ///< this part of so many, each about the same work
    std::function<bool()> stop; ///< asked before each unit; may be empty
    Progress* progress = nullptr;
};

/// How a run ended.
struct RunOutcome {
    std::size_t measured = 0; ///< units, in this run
    TradeResults results;     ///< of all runs into this store
};

/// Measures the plan's units, then, when all of them are there, those of the greedy sweep. A unit that is done is
/// stored at once. Throws Error when it was told to stop; what is stored stays, and the next run goes on from
/// it.
RunOutcome runTrade(const TradeSetup& setup, TradeStore& store, TradeExperiment& experiment,
                    const RunArguments& arguments = {});

} // namespace tarn
