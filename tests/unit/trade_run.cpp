// Running a trade: what is stored, how it goes on after a fall, and what is told in the end.

#include "base/files.h"
#include "measure/trade/report.h"
#include "measure/trade/runner.h"
#include "synthetic_experiment.h"
#include "temp_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace tarn {
namespace {

using test::messageOf;
using test::SyntheticExperiment;
using test::syntheticSetup;

const PlanRequest smallPlan{{"refraction.steps=1:6", "caustics.photons=128,256,512"}, false, {}};

TradeResults runIn(const std::filesystem::path& folder, const TradeSetup& setup, SyntheticExperiment& experiment,
                   const RunArguments& arguments = {})
{
    TradeStore store(folder, keyOf(setup), false);
    return runTrade(setup, store, experiment, arguments).results;
}

const PointResult& resultOf(const TradeResults& results, const std::string& label)
{
    const auto found = std::find_if(results.points.begin(), results.points.end(),
                                    [&](const PointResult& result) { return result.point.label == label; });
    if (found == results.points.end()) throw Error("no point {}", label);
    return *found;
}

TEST(TradeRun, MeasuresEverythingOnce)
{
    const test::TempFolder folder;
    const TradeSetup setup = syntheticSetup(smallPlan);
    SyntheticExperiment experiment;
    const TradeResults results = runIn(folder.path() / "new", setup, experiment);
    EXPECT_TRUE(results.complete());
    EXPECT_FALSE(experiment.repeatsItself());
    EXPECT_EQ(results.points.size(), 8u);
    const PointResult& one = resultOf(results, "refraction.steps=1");
    const double flip = SyntheticExperiment::flipOf(SyntheticExperiment::settingsOf(one.point).options);
    EXPECT_NEAR(one.views[0].errors.flip, flip, 1e-12);
    EXPECT_NEAR(one.mean.errors.flip, 1.1 * flip, 1e-12);
    EXPECT_NEAR(one.mean.errors.causticsRmse, 1.5 * flip, 1e-12) << "a view without caustics does not count";
    EXPECT_NEAR(one.mean.cost.median,
                1.05 * SyntheticExperiment::costOf(SyntheticExperiment::settingsOf(one.point).options), 1e-9);
}

TEST(TradeRun, AFallLosesNothingThatWasDone)
{
    const test::TempFolder folder;
    const TradeSetup setup = syntheticSetup({{}, false, loadPresets()}); // with a greedy sweep
    SyntheticExperiment whole;
    const TradeResults expected = runIn(folder.path() / "whole", setup, whole);
    std::vector<std::string> measured;
    const int inTheWalk = static_cast<int>(whole.measured.size()) - 107 - 5;
    for (const int failAfter : {0, 7, 100, inTheWalk, -1}) {
        SyntheticExperiment experiment;
        experiment.failAfter = failAfter;
        if (failAfter >= 0) {
            EXPECT_CONTAINS(messageOf<Error>([&] { runIn(folder.path() / "falls", setup, experiment); }), "power");
        } else {
            const TradeResults results = runIn(folder.path() / "falls", setup, experiment);
            EXPECT_EQ(toCsv(setup, results), toCsv(setup, expected));
        }
        measured.insert(measured.end(), experiment.measured.begin(), experiment.measured.end());
    }
    std::sort(measured.begin(), measured.end());
    std::sort(whole.measured.begin(), whole.measured.end());
    EXPECT_EQ(measured, whole.measured) << "each unit once, over all runs";

    SyntheticExperiment idle;
    runIn(folder.path() / "falls", setup, idle);
    EXPECT_TRUE(idle.measured.empty());
}

TEST(TradeRun, StopsWhenItIsTold)
{
    const test::TempFolder folder;
    SyntheticExperiment experiment;
    const RunArguments arguments{1, 1, [&] { return experiment.measured.size() == 5; }, nullptr};
    const std::string told =
        messageOf<Error>([&] { runIn(folder.path(), syntheticSetup(smallPlan), experiment, arguments); });
    EXPECT_CONTAINS(told, "goes on from there");
    EXPECT_EQ(experiment.measured.size(), 5u);
}

TEST(TradeRun, ShardsAreTheWholeAndMerge)
{
    const test::TempFolder folder;
    const TradeSetup setup = syntheticSetup(smallPlan);
    SyntheticExperiment whole;
    const TradeResults expected = runIn(folder.path() / "whole", setup, whole);
    std::vector<std::string> measured;
    std::vector<std::filesystem::path> parts;
    for (int shard = 1; shard <= 3; ++shard) {
        SyntheticExperiment experiment;
        experiment.png = "picture";
        parts.push_back(folder.path() / std::to_string(shard));
        EXPECT_FALSE(runIn(parts.back(), setup, experiment, {shard, 3, {}, nullptr}).complete());
        EXPECT_GE(experiment.measured.size(), 2u) << "a shard does its share";
        measured.insert(measured.end(), experiment.measured.begin(), experiment.measured.end());
    }
    std::sort(measured.begin(), measured.end());
    std::sort(whole.measured.begin(), whole.measured.end());
    EXPECT_EQ(measured, whole.measured);

    TradeStore merged(folder.path() / "merged", keyOf(setup), false);
    merged.merge(parts);
    const TradeResults results = collectResults(setup, merged);
    EXPECT_TRUE(results.complete());
    EXPECT_EQ(toCsv(setup, results), toCsv(setup, expected));
    EXPECT_EQ(merged.read("reference-view0.png"), "picture");
}

TEST(TradeRun, TheWalkFollowsTheMergedShards)
{
    const test::TempFolder folder;
    const TradeSetup setup = syntheticSetup({{}, false, {}});
    std::vector<std::filesystem::path> parts;
    for (int shard = 1; shard <= 2; ++shard) {
        SyntheticExperiment experiment;
        parts.push_back(folder.path() / std::to_string(shard));
        runIn(parts.back(), setup, experiment, {shard, 2, {}, nullptr});
    }
    TradeStore merged(folder.path() / "merged", keyOf(setup), false);
    merged.merge(parts);
    EXPECT_FALSE(collectResults(setup, merged).complete());
    SyntheticExperiment experiment;
    const TradeResults results = runTrade(setup, merged, experiment).results;
    EXPECT_TRUE(results.complete());
    EXPECT_GT(results.points.size(), setup.plan.points.size() + 4);
    EXPECT_LT(resultOf(results, "greedy 1").mean.cost.median, results.points.front().mean.cost.median);
}

TEST(TradeRun, CostsOfBatchesAreRelatedByTheBase)
{
    const test::TempFolder folder;
    SyntheticExperiment experiment;
    experiment.drift = 0.5; // each batch finds the machine half as slow again
    const TradeSetup setup = syntheticSetup({{"refraction.steps=1:40"}, false, {}});
    const TradeResults results = runIn(folder.path(), setup, experiment);
    const auto ratio = [&](const std::string& label) {
        return resultOf(results, label).views[0].cost.median / results.points.front().views[0].cost.median;
    };
    const double base = SyntheticExperiment::costOf(Options{});
    for (const int steps : {1, 20, 40}) {
        Options options;
        options.refraction.steps = steps;
        EXPECT_NEAR(ratio(fmt::format("refraction.steps={}", steps)), SyntheticExperiment::costOf(options) / base,
                    1e-9);
    }
}

TEST(TradeStore, ResultsOfAnotherTradeAreRefused)
{
    const test::TempFolder folder;
    TradeSetup setup = syntheticSetup(smallPlan);
    SyntheticExperiment experiment;
    runIn(folder.path(), setup, experiment);
    setup.about["size"] = "640x480";
    const std::string told = messageOf<Error>([&] { runIn(folder.path(), setup, experiment); });
    EXPECT_CONTAINS(told, "'320x240' size, not '640x480'");
    EXPECT_CONTAINS(told, "--fresh");
    EXPECT_CONTAINS(messageOf<Error>([&] {
                        TradeStore store(folder.path() / "other", keyOf(setup), false);
                        store.merge({folder.path()});
                    }),
                    "merged");
    const TradeSetup otherPlan = syntheticSetup({{"refraction.steps=1:5"}, false, {}});
    EXPECT_CONTAINS(messageOf<Error>([&] { runIn(folder.path(), otherPlan, experiment); }), "plan");

    TradeStore fresh(folder.path(), keyOf(setup), true);
    EXPECT_EQ(collectResults(setup, fresh).done, 0u);
}

TEST(TradeStore, DamagedAndMissingResultsAreNamed)
{
    const test::TempFolder folder;
    const TradeSetup setup = syntheticSetup(smallPlan);
    SyntheticExperiment experiment;
    runIn(folder.path(), setup, experiment);
    const std::string name = measuringUnits(setup, setup.plan.points).front().name() + ".json";
    writeFile(folder.path() / "results" / name, "{\"figures\":");
    EXPECT_CONTAINS(messageOf<Error>([&] { runIn(folder.path(), setup, experiment); }), name);
    EXPECT_CONTAINS(messageOf<Error>([&] { readTradeKey(folder.path() / "nowhere"); }), "no results");
}

TEST(TradeResults, CsvHasARowForEachPointAndView)
{
    const test::TempFolder folder;
    TradeSetup setup = syntheticSetup(smallPlan);
    setup.views = {"a, \"b\"", "far"};
    SyntheticExperiment experiment;
    const std::string csv = toCsv(setup, runIn(folder.path(), setup, experiment));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 8 * 3);
    EXPECT_EQ(csv.rfind("id,label,origin,view,median_ms,p95_ms,cpu_ms,refraction.median,", 0), 0u);
    EXPECT_CONTAINS(csv, "\"a, \"\"b\"\"\"");
    EXPECT_CONTAINS(csv, ",refraction.steps=1\n");
    const std::string firstRow =
        csv.substr(csv.find('\n') + 1, csv.find('\n', csv.find('\n') + 1) - csv.find('\n') - 1);
    EXPECT_EQ(std::count(firstRow.begin(), firstRow.end(), ','),
              static_cast<std::ptrdiff_t>(7 + errorFigureFields().size()));
}

TEST(TradeResults, JsonHoldsEverything)
{
    const test::TempFolder folder;
    const TradeSetup setup = syntheticSetup(smallPlan);
    SyntheticExperiment experiment;
    const nlohmann::json json = toJson(setup, runIn(folder.path(), setup, experiment), "tarn trade --out x");
    EXPECT_EQ(json["command"], "tarn trade --out x");
    EXPECT_EQ(json["points"].size(), 8u);
    EXPECT_EQ(json["sweeps"][0]["key"], "refraction.steps");
    EXPECT_EQ(json["fronts"]["flip"].size(), 3u) << "the mean and two views";
    EXPECT_FALSE(json["fronts"]["flip"][0].empty());
    EXPECT_TRUE(json["fronts"]["fresnel.max"][0].empty()) << "which nobody measured";
    const nlohmann::json& far = json["points"][0]["views"][1];
    EXPECT_TRUE(far["errors"]["caustics.rmse"].is_null());
    EXPECT_EQ(far["times"].size(), 2u);
    EXPECT_EQ(json["budgets"][0]["rows"][0]["part"], "refraction");
    EXPECT_TRUE(json["budgets"][0]["rows"][2]["alone"].is_null());
    EXPECT_EQ(json["budgets"][1]["remaining"], 0.015);
}

TEST(TradeRun, ViewsThatTakeTurnsHaveCostsAllTheSame)
{
    const test::TempFolder folder;
    TradeSetup setup = syntheticSetup(smallPlan);
    setup.takesTurns = true;
    SyntheticExperiment experiment;
    const TradeResults results = runIn(folder.path(), setup, experiment);
    EXPECT_TRUE(results.complete());
    for (const PointResult& point : results.points) {
        EXPECT_TRUE(std::isnan(point.views[1].cost.median));
        EXPECT_DOUBLE_EQ(point.mean.cost.median, point.views[0].cost.median);
        EXPECT_FALSE(std::isnan(point.mean.errors.flip));
    }
}

TEST(TradeReport, TextCannotLeaveItsPlace)
{
    const std::string text = scriptJson({{"name", "</script><script>alert(1)</script>"}});
    EXPECT_EQ(text.find('<'), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(text)["name"], "</script><script>alert(1)</script>");
}

} // namespace
} // namespace tarn
