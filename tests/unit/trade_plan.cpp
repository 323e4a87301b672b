// What a trade measures: sweeps, plans, Pareto fronts, walks.

#include "measure/trade/greedy_sweep.h"
#include "measure/trade/pareto.h"
#include "synthetic_experiment.h"
#include "temp_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace tarn {
namespace {

using test::messageOf;
using Values = std::vector<std::string>;

Values valuesOf(const std::string& text) { return parseSweep(text, describerOf(Settings{})).values; }

std::string complaint(const std::string& text)
{
    return messageOf<UsageError>([&] { valuesOf(text); });
}

TEST(TradeSweep, RangesGoUpInTheirSteps)
{
    EXPECT_EQ(valuesOf("refraction.steps=1:4"), (Values{"1", "2", "3", "4"}));
    EXPECT_EQ(valuesOf("refraction.steps=1:64:*2"), (Values{"1", "2", "4", "8", "16", "32", "64"}));
    EXPECT_EQ(valuesOf("reflection.distance=0:1:0.25"), (Values{"0", "0.25", "0.5", "0.75", "1"}));
    EXPECT_EQ(valuesOf("reflection.distance=0:0.3:0.1"), (Values{"0", "0.1", "0.2", "0.3"})) << "rounding adds up";
    EXPECT_EQ(valuesOf("refraction.steps=3:3"), Values{"3"});
    EXPECT_EQ(valuesOf("refraction.steps=1:6:2"), (Values{"1", "3", "5"}));
}

TEST(TradeSweep, ListsHoldNumbersAndNames)
{
    EXPECT_EQ(valuesOf("caustics.texture_size=128, 256,512"), (Values{"128", "256", "512"}));
    EXPECT_EQ(valuesOf("caustics.method=cpu,fetch"), (Values{"cpu", "fetch"}));
    EXPECT_EQ(valuesOf("glow.enabled=on,off"), (Values{"true", "false"}));
    EXPECT_EQ(valuesOf("reflection.distance=1,1.0,2"), (Values{"1", "2"})) << "one value, written in two ways";
    EXPECT_EQ(valuesOf("water.absorption=0.1,0.2,0.3;0.5"), (Values{"0.1,0.2,0.3", "0.5,0.5,0.5"}));
}

TEST(TradeSweep, MistakesAreToldBeforeAnyWork)
{
    EXPECT_CONTAINS(complaint("refraction.stpes=1:8"), "refraction.steps");
    EXPECT_CONTAINS(complaint("refraction.steps=0:8"), "1 to 64");
    EXPECT_CONTAINS(complaint("refraction.steps=1:65"), "'65'");
    EXPECT_CONTAINS(complaint("refraction.steps=1:2:0.5"), "whole number");
    EXPECT_CONTAINS(complaint("refraction.steps=8:1"), "goes up");
    EXPECT_CONTAINS(complaint("refraction.steps=1:8:0"), "goes up");
    EXPECT_CONTAINS(complaint("refraction.steps=1:8:*1"), "goes up");
    EXPECT_CONTAINS(complaint("refraction.steps=0:8:*2"), "goes up");
    EXPECT_CONTAINS(complaint("reflection.distance=0:100:0.001"), "1000");
    EXPECT_CONTAINS(complaint("caustics.method=cpu,magic"), "magic");
    EXPECT_CONTAINS(complaint("refraction.steps=1,,2"), "whole number");
    EXPECT_CONTAINS(complaint("refraction.steps"), "key=value");
    EXPECT_CONTAINS(messageOf<UsageError>([] {
                        parseSweeps({"refraction.steps=1", "refraction.steps=2"}, describerOf(Settings{}));
                    }),
                    "twice");
}

TEST(TradeSweep, AnotherOptionMayBeSetMeanwhile)
{
    const DescribeSettings describe = describerOf(Settings{});
    const Sweep sweep =
        parseSweep("heights.march=classic,pyramid@refraction.method=raycast@heights.map_size= 512", describe);
    EXPECT_EQ(sweep.values, (Values{"classic", "pyramid"}));
    EXPECT_EQ(sweep.title(), "heights.march (heights.map_size=512, refraction.method=raycast)");
    EXPECT_EQ(sweep.changes("classic"),
              (Changes{{"heights.map_size", "512"}, {"heights.march", "classic"}, {"refraction.method", "raycast"}}));
    EXPECT_CONTAINS(complaint("heights.march=classic@refraction.method=magic"), "magic");
    EXPECT_CONTAINS(complaint("heights.march=classic@refraction.method"), "key=value");
    EXPECT_CONTAINS(complaint("heights.march=classic@heights.march=pyramid"), "beside its sweep");
    EXPECT_NO_THROW(
        parseSweeps({"heights.march=classic", "heights.march=classic@refraction.method=raycast"}, describe));
    const auto twice = [&] {
        parseSweeps(
            {"heights.march=classic@refraction.method=raycast", "heights.march=pyramid@refraction.method=raycast"},
            describe);
    };
    EXPECT_CONTAINS(messageOf<UsageError>(twice), "heights.march (refraction.method=raycast) is swept twice");
}

// Every way of finding what the water shows is in the default plan, the marches too.
TEST(TradePlan, TheDefaultHasEveryMethod)
{
    const TradePlan plan = planTrade({{}, false, {}}, describerOf(Settings{}));
    const auto has = [&](const Changes& changes) {
        const TradePoint wanted = makePoint(changes, "", "", describerOf(Settings{}));
        return std::any_of(plan.points.begin(), plan.points.end(),
                           [&](const TradePoint& point) { return point.id == wanted.id; });
    };
    for (const char* method : {"planar", "iterative", "raycast"})
        EXPECT_TRUE(has({{"refraction.method", method}})) << method;
    for (const char* method : {"distance", "iterative", "raycast"})
        EXPECT_TRUE(has({{"reflection.method", method}})) << method;
    for (const char* key : {"refraction.method", "reflection.method"})
        EXPECT_TRUE(has({{key, "raycast"}, {"heights.march", "classic"}})) << key;
}

TEST(TradePlan, SweepsAreRoundTheBaseAndEachConfigurationStandsOnce)
{
    const TradePlan plan =
        planTrade({{"refraction.steps=1:4", "caustics.filter=1,2"}, false, {}}, describerOf(Settings{}));
    ASSERT_EQ(plan.points.size(), 5u) << "the defaults, steps 1, 2 and 4, filter 1";
    EXPECT_TRUE(plan.base().changes.empty());
    EXPECT_EQ(plan.sweeps[0].points, (std::vector<std::size_t>{1, 2, 0, 3}));
    EXPECT_EQ(plan.sweeps[1].points, (std::vector<std::size_t>{4, 0}));
    EXPECT_EQ(plan.points[1].label, "refraction.steps=1");
    EXPECT_FALSE(plan.isGreedy);
}

TEST(TradePlan, AGridHasEveryCombination)
{
    const TradePlan plan =
        planTrade({{"refraction.steps=1:4", "caustics.filter=0:2"}, true, {}}, describerOf(Settings{}));
    EXPECT_EQ(plan.points.size(), 12u);
    EXPECT_TRUE(plan.sweeps.empty());
    EXPECT_CONTAINS(
        messageOf<UsageError>([] {
            planTrade({{"refraction.steps=1:64", "refraction.target_size=16:1000"}, true, {}}, describerOf(Settings{}));
        }),
        "10000");
    EXPECT_CONTAINS(messageOf<UsageError>([] { planTrade({{}, true, {}}, describerOf(Settings{})); }), "--sweep");
}

TEST(TradePlan, TheDefaultIsLargeEnoughAndNotTooLarge)
{
    const TradePlan plan = planTrade({{}, false, loadPresets()}, describerOf(Settings{}));
    EXPECT_GE(plan.points.size(), 40u);
    EXPECT_LE(plan.points.size(), 55u) << "with seven steps of the greedy sweep at most 62, which is half an hour";
    EXPECT_EQ(plan.presets.size(), loadPresets().size());
    EXPECT_TRUE(plan.isGreedy);
    for (std::size_t i = 0; i < plan.points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_NE(plan.points[i].id, plan.points[j].id);
}

TEST(TradePlan, PresetsMayStandAlone)
{
    const std::vector<Preset> presets = loadPresets();
    const TradePlan plan = planTrade({{}, false, presets, true}, describerOf(Settings{}));
    EXPECT_EQ(plan.points.size(), presets.size() + 1);
    EXPECT_TRUE(plan.sweeps.empty());
    EXPECT_FALSE(plan.isGreedy);
    EXPECT_CONTAINS(messageOf<UsageError>([&] {
                        planTrade({{"refraction.steps=1:2"}, false, presets, true}, describerOf(Settings{}));
                    }),
                    "--presets-only");
}

TEST(TradePlan, ViewsMayTakeTurnsAtTheTimes)
{
    TradeSetup setup = test::syntheticSetup({{"refraction.steps=1:2"}, false, {}});
    const auto errorUnits = [&] {
        std::vector<std::pair<std::size_t, std::size_t>> places;
        for (const TradeUnit& unit : measuringUnits(setup, std::vector<TradePoint>{setup.plan.base()}))
            if (unit.kind == TradeUnit::Kind::errors) places.emplace_back(unit.view, unit.time);
        return places;
    };
    using Places = std::vector<std::pair<std::size_t, std::size_t>>;
    EXPECT_EQ(errorUnits(), (Places{{0, 0}, {0, 1}, {1, 0}, {1, 1}}));
    const TradeKey every = keyOf(setup);
    setup.takesTurns = true;
    EXPECT_EQ(errorUnits(), (Places{{0, 0}, {1, 1}}));
    for (const TradeUnit& unit : measuringUnits(setup, setup.plan.points)) {
        if (unit.kind != TradeUnit::Kind::costs) continue;
        EXPECT_EQ(unit.view, 0u) << "every second view is timed";
    }
    EXPECT_NE(keyOf(setup), every) << "results of the two do not mix";
}

TEST(TradePlan, AnIdIsOfTheChangesOnly)
{
    const DescribeSettings describe = describerOf(Settings{});
    const TradePoint a = makePoint({{"refraction.steps", "5"}, {"caustics.filter", "2"}}, "a", "sweep", describe);
    const TradePoint b = makePoint({{"refraction.steps", "5"}}, "b", "preset", describe);
    EXPECT_EQ(a.id, b.id) << "the filter is 2 anyway";
    EXPECT_EQ(a.id, "92ddc8e38381") << "results of older runs must still be found";
    EXPECT_NE(a.id, makePoint({{"refraction.steps", "6"}}, "", "", describe).id);
}

using Front = std::vector<std::size_t>;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(TradePareto, KeepsWhatNothingBeats)
{
    EXPECT_EQ(paretoFront(std::vector<CostedError>{{3, 1}, {1, 3}, {2, 2}, {3, 2}, {2, 4}}), (Front{1, 2, 0}));
    EXPECT_EQ(paretoFront(std::vector<CostedError>{}), Front{});
    EXPECT_EQ(paretoFront(std::vector<CostedError>{{5, 5}}), Front{0});
}

TEST(TradePareto, TiesStandOnce)
{
    EXPECT_EQ(paretoFront(std::vector<CostedError>{{1, 1}, {1, 1}, {1, 1}}), Front{0});
    EXPECT_EQ(paretoFront(std::vector<CostedError>{{1, 2}, {1, 1}}), Front{1}) << "same cost, less error";
    EXPECT_EQ(paretoFront(std::vector<CostedError>{{2, 1}, {1, 1}}), Front{1}) << "same error, cheaper";
}

TEST(TradePareto, WhatWasNotMeasuredIsNotOnIt)
{
    EXPECT_EQ(paretoFront(std::vector<CostedError>{{nan, 0}, {1, nan}, {2, 1}, {nan, nan}}), Front{2});
}

TEST(TradePareto, EveryFigureHasAnErrorThatIsLeastAtBest)
{
    ErrorFigures good, bad;
    for (const FigureField& field : errorFigureFields()) {
        good.*field.member = field.smallerIsBetter ? 0.1 : 60.0;
        bad.*field.member = field.smallerIsBetter ? 0.2 : 20.0;
    }
    good.causticsEnergy = 0.99;
    bad.causticsEnergy = 1.2;
    for (const FigureField& field : errorFigureFields())
        EXPECT_LT(errorOf(field, good), errorOf(field, bad)) << field.name;
}

TEST(TradeWalk, PredictsTheFrontOfAllCombinations)
{
    // Over a base of cost 1 and error 1.
    const std::vector<SweptOption> options{
        {"a", {{"1", 1.0, 1.0}, {"2", 2.0, 0.5}, {"3", 9.0, 0.4}}},
        {"b", {{"x", 1.0, 1.0}, {"y", 3.0, 0.2}, {"z", 0.5, nan}}},
    };
    const std::vector<SweepStep> combined = predictedFront(options, {1.0, 1.0});
    ASSERT_EQ(combined.size(), 5u) << "a=3 with b=x is dearer than a=2 with b=y and worse";
    const auto expectStep = [&](std::size_t at, const Changes& changes, double cost, double error) {
        EXPECT_EQ(combined[at].changes, changes) << at;
        EXPECT_DOUBLE_EQ(combined[at].cost, cost) << at;
        EXPECT_NEAR(combined[at].error, error, 1e-12) << at;
    };
    expectStep(0, {{"a", "1"}, {"b", "x"}}, 1.0, 1.0);
    expectStep(1, {{"a", "2"}, {"b", "x"}}, 2.0, 0.5);
    expectStep(2, {{"a", "1"}, {"b", "y"}}, 3.0, 0.2);
    expectStep(3, {{"a", "2"}, {"b", "y"}}, 4.0, -0.3);
    expectStep(4, {{"a", "3"}, {"b", "y"}}, 11.0, -0.4);
    EXPECT_TRUE(predictedFront({}, {1.0, 1.0}).empty());
}

TEST(TradeWalk, FindsWhatIsWorthLessForItsTimeButFitsIn)
{
    // Samples are worth more for their time, but who has no time for them can have texels.
    const std::vector<SweptOption> options{{"samples", {{"1", 1.0, 10.0}, {"4", 5.0, 1.0}}},
                                           {"texels", {{"low", 1.0, 10.0}, {"high", 2.0, 9.0}}}};
    const std::vector<SweepStep> combined = predictedFront(options, {1.0, 10.0});
    ASSERT_EQ(combined.size(), 4u);
    EXPECT_EQ(combined[1].changes, (Changes{{"samples", "1"}, {"texels", "high"}}));
}

TEST(TradeWalk, TheFrontOfManyOptionsStaysSmall)
{
    std::vector<SweptOption> options;
    for (int i = 0; i < 24; ++i) {
        SweptOption option{"option" + std::to_string(i), {}};
        for (int j = 0; j < 4; ++j)
            option.values.push_back({std::to_string(j), 1.0 + j * (1.0 + 0.01 * i), 1.0 / (1.0 + j + 0.1 * i)});
        options.push_back(std::move(option));
    }
    const std::vector<SweepStep> combined = predictedFront(options, {1.0, 1.0});
    EXPECT_GT(combined.size(), 100u);
    EXPECT_LE(combined.size(), 1002u);
    for (std::size_t i = 1; i < combined.size(); ++i) {
        EXPECT_GT(combined[i].cost, combined[i - 1].cost);
        EXPECT_LT(combined[i].error, combined[i - 1].error);
    }
    for (const auto& [key, value] : combined.front().changes)
        EXPECT_EQ(value, "0") << key << ": the cheapest is all of the cheapest";
    for (const auto& [key, value] : combined.back().changes)
        EXPECT_EQ(value, "3") << key << ": the most accurate is all of the most accurate";
}

TEST(TradeWalk, ThinnedKeepsBothEnds)
{
    std::vector<SweepStep> steps;
    for (int i = 0; i < 30; ++i) steps.push_back({{}, static_cast<double>(i), 0.0});
    const std::vector<SweepStep> few = thinned(steps, 5);
    ASSERT_EQ(few.size(), 5u);
    EXPECT_DOUBLE_EQ(few.front().cost, 0.0);
    EXPECT_DOUBLE_EQ(few.back().cost, 29.0);
    EXPECT_EQ(thinned(few, 8).size(), 5u);
}

TEST(TradeWalk, ThinnedFollowsTheFrontsLength)
{
    // A steep part of many steps and a flat one of few: each is half as long as the whole.
    std::vector<SweepStep> steps;
    for (int i = 0; i <= 20; ++i) steps.push_back({{}, 0.0001 * i, 1.0 - 0.05 * i});
    for (int i = 1; i <= 4; ++i) steps.push_back({{}, 0.25 * i, -0.0001 * i});
    const std::vector<SweepStep> few = thinned(steps, 5);
    ASSERT_EQ(few.size(), 5u);
    EXPECT_NEAR(few[1].error, 0.5, 0.051);
    EXPECT_NEAR(few[2].cost, 0.0, 0.26);
    EXPECT_NEAR(few[3].cost, 0.5, 0.26);
    EXPECT_DOUBLE_EQ(few[4].cost, 1.0);
}

} // namespace
} // namespace tarn
