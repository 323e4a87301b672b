// Presets and tuning on a surface of costs and errors that is known.

#include "app/presets.h"
#include "measure/trade/presets.h"
#include "measure/trade/runner.h"
#include "measure/trade/tune.h"
#include "synthetic_experiment.h"
#include "temp_folder.h"

#include <gtest/gtest.h>

#include <limits>

namespace tarn {
namespace {

using test::messageOf;
using test::SyntheticExperiment;
using test::syntheticSetup;

const std::vector<std::string> fewSweeps{"refraction.steps=1,2,3,6,12,24", "refraction.target_size=128:2048:*2",
                                         "caustics.photons=128:1024:*2", "water.normals=vertex,pixel",
                                         "frame.msaa=1,2,4,8"};

TuneRequest requestOf(const TuneGoal& goal)
{
    const DescribeSettings describe = describerOf(Settings{});
    return {goal, {makePoint({}, "", "base", describe)}, parseSweeps(fewSweeps, describe), describe, 1, 0.0};
}

/// The best of every combination.
Tuned exhaustive(const TuneGoal& goal)
{
    Tuned best{{}, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    const DescribeSettings describe = describerOf(Settings{});
    for (const TradePoint& point : planTrade({fewSweeps, true, {}}, describe).points) {
        const Options options = SyntheticExperiment::settingsOf(point).options;
        const Tuned tuned{point, SyntheticExperiment::costOf(options), SyntheticExperiment::flipOf(options)};
        const double value = goal.maxError ? tuned.ms : tuned.error, least = goal.maxError ? best.ms : best.error;
        const bool reached = goal.maxError ? tuned.error <= *goal.maxError : tuned.ms <= *goal.budgetMs;
        if (reached && value < least) best = tuned;
    }
    return best;
}

TEST(Tune, FindsTheCheapestThatIsAccurateEnough)
{
    for (const double limit : {0.08, 0.07, 0.06, 0.055}) {
        SyntheticExperiment experiment;
        const TuneGoal goal{limit, {}};
        const TuneOutcome outcome = tune(requestOf(goal), experiment);
        EXPECT_TRUE(outcome.reached) << limit;
        EXPECT_LE(outcome.best.error, limit);
        EXPECT_LE(outcome.best.ms, 1.05 * exhaustive(goal).ms) << "limit " << limit;
        EXPECT_LT(outcome.tried, 100u) << "of 960 combinations";
    }
}

TEST(Tune, FindsTheMostAccurateWithinTheBudget)
{
    for (const double budget : {7.0, 9.0, 15.0, 40.0}) {
        SyntheticExperiment experiment;
        const TuneGoal goal{{}, budget};
        const TuneOutcome outcome = tune(requestOf(goal), experiment);
        EXPECT_TRUE(outcome.reached) << budget;
        EXPECT_LE(outcome.best.ms, budget);
        EXPECT_LE(outcome.best.error, 1.05 * exhaustive(goal).error) << "budget " << budget;
    }
}

TEST(Tune, TellsTheNearestWhenTheGoalIsOutOfReach)
{
    SyntheticExperiment experiment;
    const TuneOutcome accurate = tune(requestOf({0.001, {}}), experiment);
    EXPECT_FALSE(accurate.reached);
    EXPECT_EQ(accurate.best.point.changes.at("refraction.steps"), "24");
    EXPECT_EQ(accurate.best.point.changes.at("caustics.photons"), "1024");
    const TuneOutcome cheap = tune(requestOf({{}, 0.1}), experiment);
    EXPECT_FALSE(cheap.reached);
    EXPECT_EQ(cheap.best.point.changes.at("frame.msaa"), "1");
    EXPECT_EQ(cheap.best.point.changes.at("caustics.photons"), "128");
}

TEST(Tune, MeasuresNothingTwiceAndNeverChoosesWhatItCouldNotMeasure)
{
    SyntheticExperiment experiment;
    tune(requestOf({0.06, {}}), experiment);
    std::vector<std::string> errors;
    for (const std::string& what : experiment.measured)
        if (what.starts_with("errors")) errors.push_back(what);
    EXPECT_EQ(std::set<std::string>(errors.begin(), errors.end()).size(), errors.size());

    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(isBetter({0.1, {}}, {{}, 1.0, nan}, {{}, 5.0, 0.5}));
    EXPECT_TRUE(isBetter({0.1, {}}, {{}, 5.0, 0.5}, {{}, 1.0, nan}));
    EXPECT_TRUE(isBetter({0.1, {}}, {{}, 9.0, 0.1}, {{}, 1.0, 0.2})) << "accurate enough";
    EXPECT_FALSE(isBetter({0.1, {}}, {{}, 0.99, 0.09}, {{}, 1.0, 0.08})) << "one per cent is chance";
    EXPECT_TRUE(isBetter({{}, 5.0}, {{}, 4.9, 0.1}, {{}, 1.0, 0.2}));
}

/// Results with one view, from costs and errors; the first is the base, the second the thesis.
TradeResults resultsOf(const TradeSetup& setup, const std::vector<std::pair<double, double>>& costed)
{
    TradeResults results;
    for (std::size_t i = 0; i < costed.size(); ++i) {
        PointResult result;
        result.point = setup.plan.points[i];
        result.mean.cost.median = costed[i].first;
        result.mean.errors.flip = costed[i].second;
        results.points.push_back(result);
    }
    return results;
}

std::vector<std::size_t> picksOf(const std::vector<std::pair<double, double>>& costed, bool thesis)
{
    TradeSetup setup = syntheticSetup({{"refraction.steps=1:20"}, false, {}});
    if (thesis) setup.plan.presets = {{"thesis", 1}};
    std::vector<std::size_t> points;
    for (const PresetPick& pick : pickPresets(setup, resultsOf(setup, costed))) points.push_back(pick.point);
    return points;
}

TEST(Presets, ArePickedFromTheFrontByTheRule)
{
    // The front is 2 3 4 5 6 7; costs from 1 to 64, thirds at 4 and 16.
    const std::vector<std::pair<double, double>> costed{{70, 9}, {9, 6.5}, {1, 8},  {3, 6},
                                                        {4, 5},  {15, 4},  {20, 3}, {64, 1}};
    EXPECT_EQ(picksOf(costed, false), (std::vector<std::size_t>{2, 2, 4, 5, 7}));
    // The thesis costs 9, and 4 is the most accurate up to there; thirds of 4 to 64 are at 10.1 and 25.4.
    // 3 is the cheapest that is no less accurate.
    EXPECT_EQ(picksOf(costed, true), (std::vector<std::size_t>{3, 4, 4, 6, 7}));
    // A thesis on the front itself: 3 is what its own cost buys.
    EXPECT_EQ(picksOf({{70, 9}, {3, 6}, {1, 8}, {64, 1}}, true), (std::vector<std::size_t>{1, 1, 1, 1, 3}));
    // Nothing is known of what the thesis costs.
    EXPECT_EQ(picksOf({{70, 9}, {std::nan(""), 6}, {1, 8}, {64, 1}}, true), (std::vector<std::size_t>{2, 2, 2, 2, 3}));
    EXPECT_EQ(picksOf({{2, 2}}, false), (std::vector<std::size_t>{0, 0, 0, 0, 0}));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_CONTAINS(messageOf<Error>([&] { picksOf({{nan, 2}, {2, nan}}, false); }), "presets");
}

TEST(Presets, AreFilesThatOptionsTakes)
{
    const test::TempFolder folder;
    const TradeSetup setup = syntheticSetup({{"refraction.steps=1,9", "caustics.method=cpu,fetch",
                                              "water.grid_size=33,49", "water.absorption=0.1,0.2,0.3;1"},
                                             false,
                                             {}});
    const auto at = [&](const char* label) {
        for (const TradePoint& point : setup.plan.points)
            if (point.label == label) return point;
        throw Error("no {}", label);
    };
    const std::string text = presetText(setup, at("water.absorption=0.1,0.2,0.3"), {"measured", "here"});
    EXPECT_EQ(text.rfind("# measured\n# here\n", 0), 0u) << text;
    const auto file = folder.file("preset.toml", text);
    const Settings settings = resolveSettings(Scene{}, {.files = {file}, .assignments = {}, .preset = ""});
    EXPECT_EQ(settings.water.absorption, vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(settings.options.refraction.steps, 3);
    EXPECT_CONTAINS(text, "method = \"fetch\"");
}

TEST(Presets, AutoIsByTheMachine)
{
    EXPECT_EQ(presetForMachine("llvmpipe (LLVM 15.0.6, 256 bits)", true).name, "fast");
    EXPECT_CONTAINS(presetForMachine("llvmpipe (LLVM 15.0.6, 256 bits)", true).why, "llvmpipe (LLVM 15.0.6, 256 bits)");
    const MachinePreset card = presetForMachine("A card", false);
    EXPECT_EQ(card.name, "high");
    EXPECT_CONTAINS(card.why, "none was measured on a card");
    for (const bool isSoftware : {false, true}) EXPECT_NO_THROW(presetFile(presetForMachine("x", isSoftware).name));
    EXPECT_CONTAINS(messageOf<UsageError>([] { presetFile("slow"); }), "auto");
}

TEST(Presets, ThatComeWithTarnAreValid)
{
    const std::vector<std::string> names = presetNames();
    EXPECT_EQ(names, (std::vector<std::string>{"fast", "low", "medium", "high", "best", "thesis"}));
    for (const std::string& name : names)
        EXPECT_NO_THROW(resolveSettings(Scene{}, {.files = {}, .assignments = {}, .preset = name})) << name;
    const auto scaleOf = [](const char* name) {
        return resolveSettings(Scene{}, {.files = {}, .assignments = {}, .preset = name}).options.frame.scale;
    };
    EXPECT_EQ(scaleOf("medium"), 2.0f);
    EXPECT_EQ(scaleOf("best"), 4.0f);
    const Settings thesis = resolveSettings(Scene{}, {.files = {}, .assignments = {}, .preset = "thesis"});
    EXPECT_EQ(thesis.options.refraction.steps, 3);
    EXPECT_EQ(thesis.options.underwater.refraction, UnderwaterOptions::Refraction::paper);
    EXPECT_EQ(thesis.options.caustics.method, CausticsOptions::Method::points);
    EXPECT_FLOAT_EQ(thesis.options.reflection.distance, 1.0f);
}

TEST(Presets, StandBetweenTheSceneAndTheOtherOptions)
{
    const test::TempFolder folder;
    Scene scene;
    scene.options = {{"refraction.steps", "9", "scene"}, {"frame.exposure", "0.5", "scene"}};
    const auto file = folder.file("options.toml", "reflection.distance = 7\n");
    const Settings settings =
        resolveSettings(scene, {.files = {file}, .assignments = {"caustics.filter=0"}, .preset = "thesis"});
    EXPECT_EQ(settings.options.refraction.steps, 3) << "the preset's";
    EXPECT_FLOAT_EQ(settings.options.frame.exposure, 0.5f) << "the scene's";
    EXPECT_FLOAT_EQ(settings.options.reflection.distance, 7.0f) << "the file's";
    EXPECT_EQ(settings.options.caustics.filter, 0) << "the assignment's";
    EXPECT_CONTAINS(
        messageOf<UsageError>([&] { resolveSettings(scene, {.files = {}, .assignments = {}, .preset = "tesis"}); }),
        "did you mean thesis?");
}

} // namespace
} // namespace tarn
