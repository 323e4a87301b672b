// An experiment whose costs and errors follow from formulas: what a trade must find is known beforehand.
#pragma once

#include "app/settings.h"
#include "app/trade_experiment.h"
#include "base/error.h"
#include "measure/trade/experiment.h"
#include "measure/trade/setup.h"

#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace tarn::test {

class SyntheticExperiment : public TradeExperiment {
public:
    std::vector<std::string> measured; ///< what was asked for, in this order
    int failAfter = -1;                ///< throws at this request; negative: never
    double drift = 0.0;                ///< each batch of costs finds the machine slower by this part
    std::string png;                   ///< every picture's bytes

    static Settings settingsOf(const TradePoint& point) { return changedSettings(Settings{}, point.changes, "test"); }

    /// ms: what more of anything costs.
    static double costOf(const Options& o)
    {
        const auto square = [](int edge, int one) { return std::pow(static_cast<double>(edge) / one, 2.0); };
        return 2.0 + 0.15 * o.refraction.steps + square(o.refraction.targetSize, 512) +
               square(o.reflection.targetSize, 512) + 1.5 * square(o.caustics.photons, 256) +
               0.5 * square(o.caustics.textureSize, 256) + 0.2 * square(o.water.gridSize, 49) + 0.4 * o.frame.msaa +
               0.1 * o.sunlight.taps * o.sunlight.taps + 0.3 * square(o.sunlight.mapSize, 1024) +
               (o.water.normals == WaterOptions::Normals::pixel ? 0.5 : 0.0);
    }

    /// Mean FLIP: what less of anything leaves wrong.
    static double flipOf(const Options& o)
    {
        return 0.01 + 0.04 / o.refraction.steps + 3.0 / o.refraction.targetSize + 2.0 / o.reflection.targetSize +
               3.0 / o.caustics.photons + 1.0 / o.caustics.textureSize + 0.2 / o.water.gridSize + 0.004 / o.frame.msaa +
               0.002 / o.sunlight.taps + 1.0 / o.sunlight.mapSize + 0.004 * std::abs(o.reflection.distance - 4.0) +
               (o.refraction.method == RefractionOptions::Method::planar ? 0.03 : 0.0) +
               (o.water.normals == WaterOptions::Normals::pixel ? 0.0 : 0.02);
    }

    ErrorFigures errors(const TradePoint& point, std::size_t view, double time) override
    {
        note("errors " + point.id + " " + std::to_string(view) + " " + std::to_string(time));
        const double flip = flipOf(settingsOf(point).options) * (1.0 + 0.2 * static_cast<double>(view));
        ErrorFigures figures;
        figures.flip = flip;
        figures.flipWater = 1.6 * flip;
        figures.refractionMedian = 0.5 * flip;
        figures.refractionP95 = 4.0 * flip;
        figures.refractionWrong5cm = 2.0 * flip;
        figures.causticsRmse = view == 1 ? ErrorFigures::none : 1.5 * flip; // a view that shows no bed
        figures.psnr = -20.0 * std::log10(flip);
        return figures;
    }

    std::vector<Cost> costs(std::span<const TradePoint> points, std::size_t view) override
    {
        const double slower = 1.0 + drift * static_cast<double>(batches_++);
        std::vector<Cost> costs;
        std::string asked = "costs " + std::to_string(view);
        for (const TradePoint& point : points) {
            asked += " " + point.id;
            const Options options = settingsOf(point).options;
            const double ms = slower * costOf(options) * (1.0 + 0.1 * static_cast<double>(view));
            const double base =
                slower * costOf(settingsOf(points.front()).options) * (1.0 + 0.1 * static_cast<double>(view));
            costs.push_back({ms,
                             1.1 * ms,
                             1.9 * ms,
                             ms / base,
                             {{"water", 0.3 * ms},
                              {"refraction", 0.25 * ms},
                              {"reflection", 0.15 * ms},
                              {"caustics", 0.2 * ms},
                              {"scene", 0.1 * ms}}});
        }
        note(asked);
        return costs;
    }

    TradePictures pictures(const TradePoint& point, std::size_t view) override
    {
        note("pictures " + point.id + " " + std::to_string(view));
        return {png, png, png};
    }

    std::optional<ErrorBudget> budget(std::size_t view) override
    {
        note("budget " + std::to_string(view));
        return ErrorBudget{.quantity = "mean FLIP",
                           .rows = {{"refraction", 0.03, 0.025, "refraction.steps=24"},
                                    {"caustics", 0.01, 0.012},
                                    {"shadow map", ErrorBudget::none, -0.001}},
                           .total = 0.05,
                           .together = 0.035,
                           .remaining = 0.015,
                           .noise = ErrorBudget::none,
                           .unmodelled = 0.02};
    }

    std::string machine() const override { return "a machine </script> of formulas"; }

    /// Whether anything was asked for twice.
    bool repeatsItself() const
    {
        return std::set<std::string>(measured.begin(), measured.end()).size() != measured.size();
    }

private:
    void note(const std::string& what)
    {
        if (failAfter >= 0 && static_cast<int>(measured.size()) >= failAfter) throw Error("the power failed");
        measured.push_back(what);
    }

    int batches_ = 0;
};

/// A trade over the program's own defaults.
inline TradeSetup syntheticSetup(const PlanRequest& request)
{
    TradeSetup setup;
    setup.describe = describerOf(Settings{});
    setup.plan = planTrade(request, setup.describe);
    setup.views = {"near", "far"};
    setup.times = {0.0, 1.7};
    setup.about = {{"scene", "formulas"}, {"size", "320x240"}, {"version", "0"}};
    return setup;
}

} // namespace tarn::test
