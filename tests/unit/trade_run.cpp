// Running a trade: what is stored, how it goes on after a fall, and what is told in the end.

#include "base/files.h"
#include "measure/trade/report.h"
#include "measure/trade/runner.h"
#include "synthetic_lab.h"
#include "temp_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace tarn {
namespace {

using test::messageOf;
using test::SyntheticLab;
using test::syntheticSetup;

const PlanRequest smallPlan{{"refraction.steps=1:6", "caustics.photons=128,256,512"}, false, {}};

TradeResults runIn(const std::filesystem::path& folder, const TradeSetup& setup, SyntheticLab& lab,
                   const RunArguments& arguments = {})
{
    TradeStore store(folder, keyOf(setup), false);
    return runTrade(setup, store, lab, arguments).results;
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
    SyntheticLab lab;
    const TradeResults results = runIn(folder.path() / "new", setup, lab);
    EXPECT_TRUE(results.complete());
    EXPECT_FALSE(lab.repeatsItself());
    EXPECT_EQ(results.points.size(), 8u);
    const PointResult& one = resultOf(results, "refraction.steps=1");
    const double flip = SyntheticLab::flipOf(SyntheticLab::settingsOf(one.point).options);
    EXPECT_NEAR(one.views[0].errors.flip, flip, 1e-12);
    EXPECT_NEAR(one.mean.errors.flip, 1.1 * flip, 1e-12);
    EXPECT_NEAR(one.mean.errors.causticsRmse, 1.5 * flip, 1e-12) << "a view without caustics does not count";
    EXPECT_NEAR(one.mean.price.median, 1.05 * SyntheticLab::priceOf(SyntheticLab::settingsOf(one.point).options), 1e-9);
}

TEST(TradeRun, AFallLosesNothingThatWasDone)
{
    const test::TempFolder folder;
    const TradeSetup setup = syntheticSetup({{}, false, loadPresets()}); // with a walk
    SyntheticLab whole;
    const TradeResults expected = runIn(folder.path() / "whole", setup, whole);
    std::vector<std::string> measured;
    const int inTheWalk = static_cast<int>(whole.measured.size()) - 107 - 5;
    for (const int failAfter : {0, 7, 100, inTheWalk, -1}) {
        SyntheticLab lab;
        lab.failAfter = failAfter;
        if (failAfter >= 0) {
            EXPECT_CONTAINS(messageOf<Error>([&] { runIn(folder.path() / "falls", setup, lab); }), "power");
        } else {
            const TradeResults results = runIn(folder.path() / "falls", setup, lab);
            EXPECT_EQ(toCsv(setup, results), toCsv(setup, expected));
        }
        measured.insert(measured.end(), lab.measured.begin(), lab.measured.end());
    }
    std::sort(measured.begin(), measured.end());
    std::sort(whole.measured.begin(), whole.measured.end());
    EXPECT_EQ(measured, whole.measured) << "each unit once, over all runs";

    SyntheticLab idle;
    runIn(folder.path() / "falls", setup, idle);
    EXPECT_TRUE(idle.measured.empty());
}

TEST(TradeRun, StopsWhenItIsTold)
{
    const test::TempFolder folder;
    SyntheticLab lab;
    const RunArguments arguments{1, 1, [&] { return lab.measured.size() == 5; }, nullptr};
    const std::string told = messageOf<Error>([&] { runIn(folder.path(), syntheticSetup(smallPlan), lab, arguments); });
    EXPECT_CONTAINS(told, "goes on from there");
    EXPECT_EQ(lab.measured.size(), 5u);
}

TEST(TradeRun, ShardsAreTheWholeAndMerge)
{
    const test::TempFolder folder;
    const TradeSetup setup = syntheticSetup(smallPlan);
    SyntheticLab whole;
    const TradeResults expected = runIn(folder.path() / "whole", setup, whole);
    std::vector<std::string> measured;
    std::vector<std::filesystem::path> parts;
    for (int shard = 1; shard <= 3; ++shard) {
        SyntheticLab lab;
        lab.png = "picture";
        parts.push_back(folder.path() / std::to_string(shard));
        EXPECT_FALSE(runIn(parts.back(), setup, lab, {shard, 3, {}, nullptr}).complete());
        EXPECT_GE(lab.measured.size(), 2u) << "a shard does its share";
        measured.insert(measured.end(), lab.measured.begin(), lab.measured.end());
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
        SyntheticLab lab;
        parts.push_back(folder.path() / std::to_string(shard));
        runIn(parts.back(), setup, lab, {shard, 2, {}, nullptr});
    }
    TradeStore merged(folder.path() / "merged", keyOf(setup), false);
    merged.merge(parts);
    EXPECT_FALSE(collectResults(setup, merged).complete());
    SyntheticLab lab;
    const TradeResults results = runTrade(setup, merged, lab).results;
    EXPECT_TRUE(results.complete());
    EXPECT_GT(results.points.size(), setup.plan.points.size() + 4);
    EXPECT_LT(resultOf(results, "walk 1").mean.price.median, results.points.front().mean.price.median);
}

TEST(TradeRun, PricesOfBatchesAreRelatedByTheBase)
{
    const test::TempFolder folder;
    SyntheticLab lab;
    lab.drift = 0.5; // each batch finds the machine half as slow again
    const TradeSetup setup = syntheticSetup({{"refraction.steps=1:40"}, false, {}});
    const TradeResults results = runIn(folder.path(), setup, lab);
    const auto ratio = [&](const std::string& label) {
        return resultOf(results, label).views[0].price.median / results.points.front().views[0].price.median;
    };
    const double base = SyntheticLab::priceOf(Options{});
    for (const int steps : {1, 20, 40}) {
        Options options;
        options.refraction.steps = steps;
        EXPECT_NEAR(ratio(fmt::format("refraction.steps={}", steps)), SyntheticLab::priceOf(options) / base, 1e-9);
    }
}

TEST(TradeStore, ResultsOfAnotherTradeAreRefused)
{
    const test::TempFolder folder;
    TradeSetup setup = syntheticSetup(smallPlan);
    SyntheticLab lab;
    runIn(folder.path(), setup, lab);
    setup.about["size"] = "640x480";
    const std::string told = messageOf<Error>([&] { runIn(folder.path(), setup, lab); });
    EXPECT_CONTAINS(told, "'320x240' size, not '640x480'");
    EXPECT_CONTAINS(told, "--fresh");
    EXPECT_CONTAINS(messageOf<Error>([&] {
                        TradeStore store(folder.path() / "other", keyOf(setup), false);
                        store.merge({folder.path()});
                    }),
                    "merged");
    const TradeSetup otherPlan = syntheticSetup({{"refraction.steps=1:5"}, false, {}});
    EXPECT_CONTAINS(messageOf<Error>([&] { runIn(folder.path(), otherPlan, lab); }), "plan");

    TradeStore fresh(folder.path(), keyOf(setup), true);
    EXPECT_EQ(collectResults(setup, fresh).done, 0u);
}

TEST(TradeStore, DamagedAndMissingResultsAreNamed)
{
    const test::TempFolder folder;
    const TradeSetup setup = syntheticSetup(smallPlan);
    SyntheticLab lab;
    runIn(folder.path(), setup, lab);
    const std::string name = measuringUnits(setup, setup.plan.points).front().name() + ".json";
    writeFile(folder.path() / "results" / name, "{\"figures\":");
    EXPECT_CONTAINS(messageOf<Error>([&] { runIn(folder.path(), setup, lab); }), name);
    EXPECT_CONTAINS(messageOf<Error>([&] { readTradeKey(folder.path() / "nowhere"); }), "no results");
}

TEST(TradeResults, CsvHasARowForEachPointAndView)
{
    const test::TempFolder folder;
    TradeSetup setup = syntheticSetup(smallPlan);
    setup.views = {"a, \"b\"", "far"};
    SyntheticLab lab;
    const std::string csv = toCsv(setup, runIn(folder.path(), setup, lab));
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
    SyntheticLab lab;
    const nlohmann::json json = toJson(setup, runIn(folder.path(), setup, lab), "tarn trade --out x");
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

TEST(TradeRun, ViewsThatTakeTurnsHavePricesAllTheSame)
{
    const test::TempFolder folder;
    TradeSetup setup = syntheticSetup(smallPlan);
    setup.takesTurns = true;
    SyntheticLab lab;
    const TradeResults results = runIn(folder.path(), setup, lab);
    EXPECT_TRUE(results.complete());
    for (const PointResult& point : results.points) {
        EXPECT_TRUE(std::isnan(point.views[1].price.median));
        EXPECT_DOUBLE_EQ(point.mean.price.median, point.views[0].price.median);
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
