// Ladders: what is a fault, how rungs lie under a person's settings, and which options need no programs of their own.

#include "app/ladder_file.h"
#include "base/error.h"
#include "base/files.h"
#include "measure/trade/ladder.h"
#include "measure/trade/presets.h"
#include "measure/trade/runner.h"
#include "plan/ladder.h"
#include "small_ladder.h"
#include "synthetic_experiment.h"
#include "temp_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace tarn {
namespace {

using test::messageOf;
using test::smallLadder;
using test::SyntheticExperiment;
using test::syntheticSetup;

TEST(Ladder, FaultsAreNamedWithTheirRung)
{
    EXPECT_EQ(faultOf(smallLadder()), "");
    const auto fault = [](const std::function<void(Ladder&)>& spoil) {
        Ladder ladder = smallLadder();
        spoil(ladder);
        return faultOf(ladder);
    };
    EXPECT_CONTAINS(fault([](Ladder& l) { l.rungs.clear(); }), "no rungs");
    EXPECT_CONTAINS(fault([](Ladder& l) { l.rungs[2].cost = 0.7; }), "rung 3: its cost 0.7 is not below 0.7");
    EXPECT_CONTAINS(fault([](Ladder& l) { l.rungs[2].flip = 0.11; }), "rung 3: its flip 0.11 is below 0.12");
    EXPECT_CONTAINS(fault([](Ladder& l) { l.rungs[3].wrongHits = 0.01; }),
                    "rung 4: its wrong_hits 0.01 are below 0.05");
    EXPECT_CONTAINS(fault([](Ladder& l) { l.rungs[1].cost = -1.0; }), "rung 2: cost -1 is no positive number");
    EXPECT_CONTAINS(fault([](Ladder& l) { l.rungs[1].cost = std::nan(""); }), "rung 2: cost");
    EXPECT_CONTAINS(fault([](Ladder& l) { l.rungs[1].flip = 1.5; }), "rung 2: flip 1.5 is not between 0 and 1");
    EXPECT_CONTAINS(fault([](Ladder& l) { l.rungs[1].milliseconds = 0.0; }), "rung 2: milliseconds");
    EXPECT_CONTAINS(fault([](Ladder& l) { l.rungs[0].settings["frame.msaa"] = "1"; }),
                    "rung 1: the first rung is the base");
    EXPECT_CONTAINS(fault([](Ladder& l) { l.rungs[1].settings["frame.msaa"] = "4"; }), "the base's value already");
    EXPECT_CONTAINS(fault([](Ladder& l) { l.rungs[1].settings["water.grid_size"] = "17"; }),
                    "water.grid_size has no value in [base]");
    EXPECT_CONTAINS(fault([](Ladder& l) { l.rungs[1].settings["frame.msaa"] = "70"; }), "frame.msaa");
}

TEST(Ladder, RungsOnlyMakeCheaper)
{
    const Ladder ladder = smallLadder();
    Options own;
    own.caustics.photons = 32; // cheaper than any rung
    own.sunlight.taps = 3;     // no rung sets it
    own.caustics.enabled = false;
    own.frame.exposure = 0.3f;
    const Options lowest = below(own, ladder, ladder.rungs.back());
    EXPECT_EQ(lowest.frame.msaa, 1);
    EXPECT_EQ(lowest.reflection.facets, ReflectionOptions::Facets::one);
    EXPECT_EQ(lowest.caustics.photons, 32);
    EXPECT_EQ(lowest.sunlight.taps, 3);
    EXPECT_FALSE(lowest.caustics.enabled);
    EXPECT_EQ(lowest.frame.exposure, 0.3f);

    own.reflection.facets = ReflectionOptions::Facets::five; // dearer than the base
    EXPECT_EQ(below(own, ladder, ladder.rungs[2]).reflection.facets, ReflectionOptions::Facets::one);
    own.frame.msaa = 2;
    EXPECT_EQ(below(own, ladder, ladder.rungs[0]), own) << "the first rung is what the person wants";
}

TEST(Ladder, RungsThatChangeNothingAreLeftOut)
{
    const Ladder ladder = smallLadder();
    EXPECT_EQ(rungsBelow(Options{}, ladder).size(), 4u);
    EXPECT_TRUE(startsAtBase(Options{}, ladder));
    Options own;
    own.frame.msaa = 1;
    own.caustics.photons = 64;
    EXPECT_FALSE(startsAtBase(own, ladder));
    const std::vector<OwnRung> rungs = rungsBelow(own, ladder);
    ASSERT_EQ(rungs.size(), 2u);
    EXPECT_EQ(rungs[0].options, own);
    EXPECT_EQ(rungs[0].cost, 0.7);
    EXPECT_EQ(rungs[1].rung, 3u);
    EXPECT_EQ(rungs[1].cost, 0.25);
    own.reflection.facets = ReflectionOptions::Facets::one;
    EXPECT_EQ(rungsBelow(own, ladder).size(), 1u) << "nothing is left to be saved";
}

TEST(Ladder, ProgramsAreToldFromSizes)
{
    Options a, b;
    EXPECT_TRUE(programsServe(a, b));
    b.caustics.photons = 64;
    b.refraction.targetSize = 128;
    b.frame.exposure = 2.0f;
    b.frame.targetMs = 10.0f;
    EXPECT_TRUE(programsServe(a, b));
    b.sunlight.taps = 1;
    EXPECT_FALSE(programsServe(a, b));
    b = a;
    b.reflection.facets = ReflectionOptions::Facets::one;
    EXPECT_FALSE(programsServe(a, b));
    b = a;
    b.caustics.enabled = false;
    EXPECT_FALSE(programsServe(a, b));
    b = a;
    b.frame.scale = 0.67f;
    EXPECT_FALSE(programsServe(a, b)) << "nothing was upscaled yet";
    EXPECT_TRUE(programsServe(b, a));
    a.frame.scale = 0.5f;
    EXPECT_TRUE(programsServe(a, b));
    a.frame.scale = 2.0f;
    EXPECT_FALSE(programsServe(b, a));
    EXPECT_TRUE(isSizeOnly("water.grid_size"));
    EXPECT_FALSE(isSizeOnly("frame.msaa"));
}

std::string validFile()
{
    return R"(scene = "A pond"
size = "320x240"
machine = "a machine"

[base]
frame.msaa = 4
reflection.facets = "three"

[[rungs]]
cost = 1.0
milliseconds = 100.0
flip = 0.1
wrong_hits = 0.04

[[rungs]]
cost = 0.5
milliseconds = 50
flip = 0.12
wrong_hits = 0.04
[rungs.settings]
frame.msaa = 1
reflection.facets = "one"
)";
}

TEST(LadderFile, ReadsWhatIsThere)
{
    const test::TempFolder folder;
    writeFile(folder.path() / "ladder.toml", validFile());
    const Ladder ladder = readLadder(folder.path() / "ladder.toml");
    EXPECT_EQ(ladder.scene, "A pond");
    ASSERT_EQ(ladder.rungs.size(), 2u);
    EXPECT_EQ(ladder.rungs[1].cost, 0.5);
    EXPECT_EQ(ladder.rungs[1].settings, (OptionValues{{"frame.msaa", "1"}, {"reflection.facets", "one"}}));
    EXPECT_EQ(ladder.base.at("frame.msaa"), "4");
}

TEST(LadderFile, EveryMistakeIsOneLineWithItsPlace)
{
    const test::TempFolder folder;
    const std::filesystem::path file = folder.path() / "ladder.toml";
    const auto told = [&](const std::string& from, const std::string& to) {
        std::string text = validFile();
        const std::size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        text.replace(at, from.size(), to);
        writeFile(file, text);
        const std::string message = messageOf<Error>([&] { readLadder(file); });
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        EXPECT_CONTAINS(message, "ladder.toml:");
        EXPECT_CONTAINS(message, "tarn trade --write-ladder");
        return message;
    };
    EXPECT_CONTAINS(told("cost = 0.5", "cost = 1.5"), "ladder.toml:15: rung 2: its cost 1.5 is not below 1");
    EXPECT_CONTAINS(told("flip = 0.12", "flip = 0.05"), "rung 2: its flip 0.05 is below 0.1");
    EXPECT_CONTAINS(told("cost = 0.5", "cots = 0.5"), "ladder.toml:16: unknown key cots, did you mean cost?");
    EXPECT_CONTAINS(told("cost = 0.5", "cost = \"x\""), "ladder.toml:16: cost wants a number");
    EXPECT_CONTAINS(told("cost = 0.5\n", ""), "cost is missing");
    EXPECT_CONTAINS(told("frame.msaa = 1", "frame.mssa = 1"), "ladder.toml:21: there is no option 'frame.mssa'");
    EXPECT_CONTAINS(told("facets = \"one\"", "facets = \"two\""), "ladder.toml:22");
    EXPECT_CONTAINS(told("frame.msaa = 1", "sunlight.taps = 1"), "sunlight.taps has no value in [base]");
    EXPECT_CONTAINS(told("scene = \"A pond\"", "scene = 3"), "ladder.toml:1: scene wants a text in quotes");
    EXPECT_CONTAINS(told("[base]", "[bass]"), "unknown key bass, did you mean base?");
    EXPECT_CONTAINS(told("[base]", "[base"), "ladder.toml:5");
    EXPECT_CONTAINS(told("frame.msaa = 4", "frame.msaa = { a = 1 }"), "frame.msaa");
    EXPECT_CONTAINS(messageOf<Error>([&] { readLadder(folder.path() / "none.toml"); }), "none.toml");
}

TEST(LadderFile, TheShippedOneIsValid)
{
    const Ladder ladder = readLadder(shippedLadder());
    EXPECT_GE(ladder.rungs.size(), 3u);
    EXPECT_LT(ladder.rungs.back().cost, 0.25);
    std::vector<Options> sets;
    std::vector<OwnRung> rungs = rungsBelow(Options{}, ladder);
    std::reverse(rungs.begin(), rungs.end()); // as they are built
    for (const OwnRung& rung : rungs) {
        const auto same = [&](const Options& other) { return programsServe(other, rung.options); };
        if (std::none_of(sets.begin(), sets.end(), same)) sets.push_back(rung.options);
    }
    EXPECT_LE(sets.size(), 5u) << "sets of programs";
}

TEST(TradeLadder, SweepsOnlyWhatIsCheaper)
{
    Settings settings;
    settings.options.frame.msaa = 1;
    settings.options.water.surfaceSteps = 1;
    settings.options.caustics.photons = 200;
    for (const Sweep& sweep : cheaperSweeps(describerOf(settings))) {
        EXPECT_NE(sweep.key, "frame.msaa");
        if (sweep.key == "water.surface_steps") {
            EXPECT_EQ(sweep.values, (std::vector<std::string>{"0"}));
        } else if (sweep.key == "caustics.photons") {
            EXPECT_EQ(sweep.values, (std::vector<std::string>{"128"}));
        }
    }
}

TEST(TradeLadder, WritesWhatTheGovernorReads)
{
    const test::TempFolder folder;
    PlanRequest request;
    request.ladder = true;
    const TradeSetup setup = syntheticSetup(request);
    SyntheticExperiment experiment;
    TradeStore store(folder.path() / "trade", keyOf(setup), false);
    const TradeResults results = runTrade(setup, store, experiment).results;
    EXPECT_TRUE(results.complete());
    EXPECT_FALSE(experiment.repeatsItself());
    Ladder ladder = pickLadder(setup, results, greedySweepError(setup, results.points));
    ladder.scene = "for\"mulas";
    ladder.size = "1x1";
    ladder.machine = "none";
    EXPECT_EQ(faultOf(ladder), "");
    ASSERT_GE(ladder.rungs.size(), 5u);
    for (std::size_t i = 1; i < ladder.rungs.size(); ++i) {
        const Options options = changedSettings(Settings{}, ladder.rungs[i].settings, "test").options;
        EXPECT_NEAR(ladder.rungs[i].cost, SyntheticExperiment::costOf(options) / SyntheticExperiment::costOf(Options{}),
                    1e-9);
        EXPECT_GE(ladder.rungs[i].flip, ladder.rungs[i - 1].flip);
    }

    writeFile(folder.path() / "ladder.toml", ladderText(setup, ladder, {"a comment"}));
    const Ladder read = readLadder(folder.path() / "ladder.toml");
    EXPECT_EQ(read.scene, "for\"mulas");
    EXPECT_EQ(read.base, ladder.base);
    ASSERT_EQ(read.rungs.size(), ladder.rungs.size());
    for (std::size_t i = 0; i < read.rungs.size(); ++i) {
        EXPECT_EQ(read.rungs[i].settings, ladder.rungs[i].settings);
        EXPECT_NEAR(read.rungs[i].cost, ladder.rungs[i].cost, 1e-4);
    }
    const std::vector<PresetPick> picks = pickPresets(setup, results);
    ASSERT_EQ(picks.size(), 1u);
    EXPECT_EQ(picks[0].name, "fast");
}

TEST(TradeLadder, GoesOnAfterAFall)
{
    const test::TempFolder folder;
    PlanRequest request;
    request.ladder = true;
    const TradeSetup setup = syntheticSetup(request);
    SyntheticExperiment failing;
    failing.failAfter = 20;
    {
        TradeStore store(folder.path(), keyOf(setup), false);
        EXPECT_CONTAINS(messageOf<Error>([&] { runTrade(setup, store, failing); }), "power");
    }
    SyntheticExperiment experiment;
    TradeStore store(folder.path(), keyOf(setup), false);
    EXPECT_TRUE(runTrade(setup, store, experiment).results.complete());
    for (const std::string& unit : failing.measured)
        EXPECT_EQ(std::count(experiment.measured.begin(), experiment.measured.end(), unit), 0) << unit;
}

} // namespace
} // namespace tarn
