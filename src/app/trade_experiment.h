// What `tarn trade` and `tarn tune` share: the base that settings change, the views, and the experiment that
// measures them.
#pragma once

#include "app/scene_setup.h"
#include "measure/trade/experiment.h"
#include "measure/trade/plan.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace tarn {

/// The settings with these changes. Throws UsageError as assign() does.
Settings changedSettings(Settings settings, const Changes& changes, const std::string& origin);

/// For planTrade and its like; keeps a copy of the base.
DescribeSettings describerOf(const Settings& base);

/// Every preset that comes with the program. Throws UsageError when one is damaged.
std::vector<Preset> loadPresets();

/// The cameras of these names; without names the scene's first `most`. Throws UsageError for a name that is
/// none.
std::vector<Camera> chooseViews(const Scene& scene, const std::vector<std::string>& names, std::size_t most,
                                const char* flag);

struct ExperimentArguments {
    std::vector<Camera> views;
    ivec2 size{320, 240};             ///< pixels
    std::vector<double> times;        ///< of each view's pictures and of its first frame that is timed, s
    int frames = 3;                   ///< frames timed of each setting
    int samples = 32;                 ///< of the reference, through each pixel
    std::filesystem::path references; ///< folder that keeps the reference's pictures; empty: none does
};

/// Keeps a reference to the set-up, whose settings are the base.
std::unique_ptr<TradeExperiment> makeTradeExperiment(const SceneSetup& sceneSetup, const ExperimentArguments& arguments,
                                                     Progress* progress);

} // namespace tarn
