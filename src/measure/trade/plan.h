// Which settings `tarn trade` measures.
//
// A plan's points are known before any work. From their results comes the greedy sweep (measure/trade/greedy_sweep.h):
// combined settings that ought to lie on the Pareto front.
#pragma once

#include "measure/trade/sweep.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace tarn {

/// One configuration: a base and what differs from it.
struct TradePoint {
    std::string id;     ///< of its changes: the same in every run over the same base
    std::string label;  ///< "base", "refraction.steps=1", "thesis"
    std::string origin; ///< "base", "sweep", "grid", "preset", "greedy"
    Changes changes;    ///< only what truly differs from the base
};

struct TradePlan {
    std::vector<TradePoint> points; ///< each configuration once; the base is the first
    struct SweptPoints {
        Sweep sweep;
        std::vector<std::size_t> points; ///< one for each value
    };
    std::vector<SweptPoints> sweeps;                          ///< one at a time; empty with a grid
    std::vector<std::pair<std::string, std::size_t>> presets; ///< name, point
    bool isGreedy = false;                                    ///< combined points are to follow
    bool ladder = false;                                      ///< they are to be rungs (measure/trade/ladder.h)

    const TradePoint& base() const { return points.front(); }
};

/// A file of options under a name: what `--preset NAME` reads.
struct Preset {
    std::string name;
    Changes changes;
};

struct PlanRequest {
    std::vector<std::string>
        sweeps;        ///< --sweep, as written; empty: the default plan, with presets and the greedy sweep
    bool grid = false; ///< every combination instead of one option at a time
    std::vector<Preset> presets;
    bool presetsOnly = false; ///< no sweeps: the base and the presets
    bool ladder = false;      ///< what makes a frame cheaper, and combinations of it
};

/// Throws UsageError for a sweep that cannot be, and when a grid has more than 10000 points.
TradePlan planTrade(const PlanRequest& request, const DescribeSettings& describe);

/// What is swept when a person names nothing: every option that trades accuracy for time.
std::vector<std::string> defaultSweeps();

/// The point with these changes over the base; changes that change nothing are left out.
TradePoint makePoint(const Changes& changes, std::string label, std::string origin, const DescribeSettings& describe);

/// Adds the point unless its configuration is there already. Returns where it is.
std::size_t addPoint(std::vector<TradePoint>& points, TradePoint point);

} // namespace tarn
