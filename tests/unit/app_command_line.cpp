// Command lines, right and wrong, and what a person is told.

#include "app/command_line.h"
#include "app/parse.h"
#include "app/program.h"
#include "base/error.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>

namespace tarn {
namespace {

template <typename C> C parsed(const std::vector<std::string>& words) { return std::get<C>(parseCommandLine(words)); }

std::string complaint(const std::vector<std::string>& words)
{
    try {
        parseCommandLine(words);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}

TEST(CommandLine, ViewIsTheDefault)
{
    EXPECT_TRUE(parsed<ViewCommand>({}).scene.file.empty());
    EXPECT_EQ(parsed<ViewCommand>({"lake.toml"}).scene.file, "lake.toml");
    EXPECT_EQ(parsed<ViewCommand>({"--size", "640x480"}).view.size, ivec2(640, 480));
    EXPECT_EQ(parsed<ViewCommand>({"--frames", "3", "a/b.obj"}).frames, 3);
    EXPECT_FALSE(parsed<ViewCommand>({}).fps);
    EXPECT_EQ(parsed<ViewCommand>({"--fps", "0"}).fps, 0.0);
    EXPECT_EQ(parsed<ViewCommand>({"--fps", "60", "--ladder", "l.toml"}).ladder, "l.toml");
    EXPECT_EQ(parsed<ViewCommand>({"view", "lake.toml", "--camera", "pier"}).view.camera.name, "pier");
    EXPECT_TRUE(parsed<ViewCommand>({}).vsync);
    EXPECT_FALSE(parsed<ViewCommand>({"--no-vsync"}).vsync);
    EXPECT_TRUE(parsed<ViewCommand>({"--fullscreen"}).fullscreen);
}

TEST(CommandLine, RenderTakesAllItsFlags)
{
    const auto c = parsed<RenderCommand>({"render",
                                          "s.toml",
                                          "--eye",
                                          "-1,2.5,3e1",
                                          "--target=0,0,-4",
                                          "--up",
                                          "0,0,-1",
                                          "--fov",
                                          "90",
                                          "--size",
                                          "320x240",
                                          "--time",
                                          "-1.5",
                                          "--view",
                                          "path-length",
                                          "--set",
                                          "refraction.steps=3",
                                          "--set",
                                          "water.level=1",
                                          "--options",
                                          "o.toml",
                                          "--water-level",
                                          "-0.5",
                                          "--out",
                                          "f_%04d.png",
                                          "--frames",
                                          "5",
                                          "--fps",
                                          "25",
                                          "--check",
                                          "--json",
                                          "-"});
    EXPECT_EQ(c.scene.file, "s.toml");
    EXPECT_EQ(*c.view.camera.eye, vec3(-1.0f, 2.5f, 30.0f));
    EXPECT_EQ(*c.view.camera.target, vec3(0.0f, 0.0f, -4.0f));
    EXPECT_EQ(*c.view.camera.up, vec3(0.0f, 0.0f, -1.0f));
    EXPECT_NEAR(*c.view.camera.verticalFov, pi / 2.0f, 1e-6f);
    EXPECT_EQ(c.view.size, ivec2(320, 240));
    EXPECT_DOUBLE_EQ(c.view.time, -1.5);
    EXPECT_EQ(c.debugView, DebugView::pathLength);
    EXPECT_EQ(c.scene.settings.assignments, (std::vector<std::string>{"refraction.steps=3", "water.level=1"}));
    ASSERT_EQ(c.scene.settings.files.size(), 1u);
    EXPECT_EQ(c.scene.settings.files[0], "o.toml");
    EXPECT_FLOAT_EQ(*c.scene.waterLevel, -0.5f);
    EXPECT_EQ(c.out, "f_%04d.png");
    EXPECT_EQ(c.frames, 5);
    EXPECT_DOUBLE_EQ(c.fps, 25.0);
    EXPECT_TRUE(c.check);
    EXPECT_EQ(c.json, "-");
}

TEST(CommandLine, SetDoesNotSwallowTheScene)
{
    const auto c = parsed<RenderCommand>({"render", "--set", "refraction.steps=3", "s.toml", "--out", "a.png"});
    EXPECT_EQ(c.scene.file, "s.toml");
    EXPECT_EQ(c.scene.settings.assignments.size(), 1u);
}

TEST(CommandLine, OptionsJsonMayLeaveTheFileOut)
{
    EXPECT_EQ(parsed<OptionsCommand>({"options"}).json, "");
    EXPECT_EQ(parsed<OptionsCommand>({"options", "--json"}).json, "-");
    EXPECT_EQ(parsed<OptionsCommand>({"options", "--json", "o.json"}).json, "o.json");
}

TEST(CommandLine, OptionsAreWrittenInOneForm)
{
    EXPECT_FALSE(parsed<OptionsCommand>({"options"}).markdown);
    EXPECT_TRUE(parsed<OptionsCommand>({"options", "--markdown"}).markdown);
    EXPECT_THROW(parseCommandLine({"options", "--markdown", "--json"}), UsageError);
}

/// Every command and every flag that --help shows, in a form for other programs.
TEST(CommandLine, DescribesItself)
{
    const auto json = nlohmann::json::parse(parsed<PrintCommand>({"--describe"}).text);
    EXPECT_EQ(json["name"], "tarn");
    std::map<std::string, nlohmann::json> commands;
    for (const auto& command : json["commands"]) commands[command["name"]] = command["options"];
    EXPECT_EQ(commands.size(), 13u);
    const auto option = [&](const std::string& command, const std::string& name) -> nlohmann::json {
        for (const auto& candidate : commands[command])
            for (const auto& known : candidate["names"])
                if (known == name) return candidate;
        return {};
    };
    EXPECT_EQ(option("render", "--out")["value"], "FILE");
    EXPECT_EQ(option("bench", "--flight")["value"], "");
    EXPECT_TRUE(option("options", "--json")["value_optional"]);
    EXPECT_TRUE(option("render", "--set").contains("repeated"));
    EXPECT_FALSE(option("render", "--out").contains("repeated"));
    EXPECT_FALSE(option("view", "--no-vsync").is_null());
    EXPECT_TRUE(option("compare", "--set").is_null());
    EXPECT_EQ(commands["compare"][1]["argument"], "REFERENCE");
    EXPECT_THROW(parseCommandLine({"--describe", "render"}), UsageError);
}

TEST(CommandLine, AnErrorMapNeedsAReference)
{
    const auto c = parsed<RenderCommand>(
        {"render", "--error", "reflection", "--reference", "truth.exr", "--error-scale", "2.5", "--out", "map.png"});
    ASSERT_TRUE(c.error);
    EXPECT_EQ(*c.error, ErrorKind::reflection);
    EXPECT_EQ(c.reference, "truth.exr");
    EXPECT_DOUBLE_EQ(c.errorScale, 2.5);
    EXPECT_FALSE(c.view.sizeGiven);
    EXPECT_FALSE(c.view.timeGiven);
    const auto given = parsed<RenderCommand>({"render", "--size", "8x8", "--time", "0", "--out", "a.png"});
    EXPECT_TRUE(given.view.sizeGiven);
    EXPECT_TRUE(given.view.timeGiven);

    EXPECT_NE(complaint({"render", "--error", "path", "--out", "a.png"}).find("tarn reference"), std::string::npos);
    EXPECT_NE(complaint({"render", "--error", "colour", "--reference", "t.exr", "--out", "a.png"}).find("fresnel"),
              std::string::npos);
    EXPECT_NE(complaint({"render", "--reference", "t.exr", "--out", "a.png"}).find("--error"), std::string::npos);
    EXPECT_NE(complaint({"render", "--error-scale", "1", "--out", "a.png"}).find("--error"), std::string::npos);
    for (const std::vector<std::string>& other :
         {std::vector<std::string>{"--view", "fresnel"}, {"--all-cameras"}, {"--frames", "2"}}) {
        std::vector<std::string> words{"render", "--error", "path", "--reference", "t.exr", "--out", "a_%d.png"};
        words.insert(words.end(), other.begin(), other.end());
        EXPECT_NE(complaint(words).find("--error makes one map"), std::string::npos) << other.front();
    }
}

TEST(CommandLine, TheViewerTakesAReference)
{
    EXPECT_EQ(parsed<ViewCommand>({"view", "--reference", "truth.exr"}).reference, "truth.exr");
    EXPECT_TRUE(parsed<ViewCommand>({}).reference.empty());
}

TEST(CommandLine, BenchVariants)
{
    const auto c = parsed<BenchCommand>({"bench", "--frames", "7", "--vary", "refraction.steps=1", "--vary", "a.b=c"});
    EXPECT_EQ(c.frames, 7);
    EXPECT_EQ(c.variants, (std::vector<std::string>{"refraction.steps=1", "a.b=c"}));
}

TEST(CommandLine, BenchYardstick)
{
    EXPECT_FALSE(parsed<BenchCommand>({"bench"}).yardstick);
    EXPECT_TRUE(parsed<BenchCommand>({"bench", "--yardstick", "--table", "2"}).yardstick);
}

TEST(CommandLine, BenchInteractive)
{
    const auto c = parsed<BenchCommand>({"bench", "--interactive", "s.toml", "--seconds", "2.5"});
    EXPECT_TRUE(c.interactive);
    EXPECT_EQ(c.scene.file, "s.toml");
    EXPECT_DOUBLE_EQ(c.seconds, 2.5);
    for (const std::vector<std::string>& other :
         {std::vector<std::string>{"--flight"}, {"--rules"}, {"--yardstick"}, {"--table", "2"}, {"--vary", "a.b=c"}}) {
        std::vector<std::string> words{"bench", "--interactive"};
        words.insert(words.end(), other.begin(), other.end());
        EXPECT_NE(complaint(words).find("a flight of its own"), std::string::npos) << other.front();
    }
    EXPECT_NE(complaint({"bench", "--interactive", "--seconds", "0"}).find("--seconds 0"), std::string::npos);
}

TEST(CommandLine, BenchTables)
{
    EXPECT_EQ(parsed<BenchCommand>({"bench"}).table, nullptr);
    for (const int number : {2, 3}) {
        const auto c = parsed<BenchCommand>({"bench", "s.toml", "--table", std::to_string(number)});
        ASSERT_NE(c.table, nullptr);
        EXPECT_EQ(c.table->number, number);
        EXPECT_EQ(c.scene.file, "s.toml");
    }
    for (const char* wrong : {"1", "4", "-2", "2.0", "02", "two", ""}) {
        const std::string told = complaint({"bench", "--table", wrong});
        EXPECT_NE(told.find("--table " + std::string(wrong)), std::string::npos) << told;
        EXPECT_NE(told.find("2 (caustics on and off) and 3 ("), std::string::npos) << told;
    }
    EXPECT_NE(complaint({"bench", "--vary", "refraction.steps=1", "--table", "2"}).find("--vary"), std::string::npos);
    EXPECT_NE(complaint({"render", "--table", "2", "--out", "a.png"}).find("--table"), std::string::npos);
}

TEST(CommandLine, BenchStartup)
{
    EXPECT_FALSE(parsed<BenchCommand>({"bench"}).startup);
    EXPECT_TRUE(parsed<BenchCommand>({"bench", "--startup"}).startup);
    for (const char* other : {"--flight", "--rules"})
        EXPECT_NE(complaint({"bench", "--startup", other}).find("--startup measures one start"), std::string::npos)
            << other;
}

TEST(CommandLine, Compare)
{
    const auto bare = parsed<CompareCommand>({"compare", "a.png", "b.png"});
    EXPECT_EQ(bare.reference, "a.png");
    EXPECT_EQ(bare.test, "b.png");
    EXPECT_TRUE(bare.out.empty());
    EXPECT_FALSE(bare.exposure || bare.maxFlip);
    EXPECT_DOUBLE_EQ(bare.pixelsPerDegree, defaultPixelsPerDegree);
    const auto full =
        parsed<CompareCommand>({"compare", "--ppd", "40", "a.exr", "--exposure", "0.5", "b.exr", "--tone-curve",
                                "reinhard", "--out", "heat.png", "--max-flip", "0.1", "--json", "-"});
    EXPECT_EQ(full.reference, "a.exr");
    EXPECT_EQ(full.test, "b.exr");
    EXPECT_EQ(full.out, "heat.png");
    EXPECT_DOUBLE_EQ(*full.exposure, 0.5);
    EXPECT_EQ(full.toneCurve, "reinhard");
    EXPECT_DOUBLE_EQ(full.pixelsPerDegree, 40.0);
    EXPECT_DOUBLE_EQ(*full.maxFlip, 0.1);
    EXPECT_EQ(full.json, "-");
}

TEST(CommandLine, CompareUsedWrongly)
{
    const auto with = [](const std::string& flag, const std::string& value) {
        return complaint({"compare", "a.png", "b.png", flag, value});
    };
    EXPECT_NE(complaint({"compare"}).find("two pictures"), std::string::npos);
    EXPECT_NE(complaint({"compare", "a.png"}).find("two pictures"), std::string::npos);
    EXPECT_NE(complaint({"compare", "a.png", "b.png", "c.png"}).find("c.png"), std::string::npos);
    EXPECT_NE(with("--tone-curve", "filmic").find("linear, reinhard, aces"), std::string::npos);
    EXPECT_NE(with("--ppd", "0").find("--ppd 0"), std::string::npos);
    EXPECT_NE(with("--max-flip", "2").find("--max-flip 2"), std::string::npos);
    EXPECT_NE(with("--exposure", "-1").find("--exposure -1"), std::string::npos);
    EXPECT_NE(with("--max-flop", "1").find("did you mean --max-flip?"), std::string::npos);
}

TEST(CommandLine, Trade)
{
    const auto d = parsed<TradeCommand>({"trade", "--out", "o"});
    EXPECT_EQ(d.size, ivec2(320, 240));
    EXPECT_TRUE(d.times.empty());
    EXPECT_EQ(d.shards, 1);
    const auto c = parsed<TradeCommand>({"trade",    "s.toml",
                                         "--out",    "o",
                                         "--sweep",  "refraction.steps=1:8",
                                         "--sweep",  "caustics.filter=0:2",
                                         "--grid",   "--views",
                                         "pier,bed", "--times",
                                         "0.5",      "--size",
                                         "64x48",    "--frames",
                                         "9",        "--samples",
                                         "7",        "--shard",
                                         "2/4",      "--fresh",
                                         "--preset", "thesis"});
    EXPECT_EQ(c.sweeps.size(), 2u);
    EXPECT_TRUE(c.grid && c.fresh);
    EXPECT_EQ(c.views, (std::vector<std::string>{"pier", "bed"}));
    EXPECT_EQ(c.times, std::vector<double>{0.5});
    EXPECT_EQ(c.samples, 7);
    EXPECT_EQ(c.shard, 2);
    EXPECT_EQ(c.shards, 4);
    EXPECT_EQ(c.scene.settings.preset, "thesis");
    EXPECT_EQ(c.commandLine.rfind("tarn trade s.toml --out o", 0), 0u);
    EXPECT_EQ(parsed<TradeCommand>({"trade", "--out", "o", "--merge", "a", "--merge", "b"}).merge.size(), 2u);
    EXPECT_NE(complaint({"trade"}).find("--out"), std::string::npos);
    EXPECT_NE(complaint({"trade", "--out", "o", "--shard", "1/2", "--merge", "a"}).find("--merge"), std::string::npos);
    for (const char* wrong : {"0/4", "5/4", "1", "1/", "/2", "a/b", "1/2/3"})
        EXPECT_NE(complaint({"trade", "--out", "o", "--shard", wrong}).find("1/4"), std::string::npos) << wrong;
    for (const char* wrong : {"", "1,", "soon", "1,1", "nan"})
        EXPECT_NE(complaint({"trade", "--out", "o", "--times", wrong}), "") << wrong;
}

TEST(CommandLine, TuneHasOneGoal)
{
    EXPECT_DOUBLE_EQ(*parsed<TuneCommand>({"tune", "--max-error", "0.05"}).maxError, 0.05);
    EXPECT_DOUBLE_EQ(*parsed<TuneCommand>({"tune", "--budget-ms", "16"}).budgetMs, 16.0);
    EXPECT_NE(complaint({"tune"}).find("--budget-ms"), std::string::npos);
    EXPECT_NE(complaint({"tune", "--max-error", "0.1", "--budget-ms", "3"}).find("one goal"), std::string::npos);
    EXPECT_NE(complaint({"tune", "--max-error", "2"}), "");
}

TEST(CommandLine, BudgetHasAViewAndAReference)
{
    const auto c =
        parsed<BudgetCommand>({"budget", "s.toml", "--camera", "bed", "--samples", "8", "--preset", "thesis"});
    EXPECT_EQ(c.view.camera.name, "bed");
    EXPECT_EQ(c.reference.samples, 8);
    EXPECT_EQ(c.view.size, ivec2(320, 240));
    EXPECT_NE(complaint({"budget", "--samples", "0"}).find("--samples"), std::string::npos);
}

TEST(CommandLine, HelpAndVersionAreText)
{
    EXPECT_NE(parsed<PrintCommand>({"--help"}).text.find("bench"), std::string::npos);
    EXPECT_NE(parsed<PrintCommand>({"render", "--help"}).text.find("--all-cameras"), std::string::npos);
    EXPECT_EQ(parsed<PrintCommand>({"--version"}).text.rfind("tarn ", 0), 0u);
}

TEST(CommandLine, UnknownWordsAreToldWithTheNearest)
{
    EXPECT_NE(complaint({"rendr"}).find("did you mean render?"), std::string::npos);
    EXPECT_NE(complaint({"render", "--out", "a.png", "--camra", "x"}).find("did you mean --camera?"),
              std::string::npos);
    EXPECT_NE(complaint({"--frame=3"}).find("--frame: no such flag, did you mean --frames?"), std::string::npos);
    EXPECT_NE(complaint({"render", "a.toml", "b.toml", "--out", "c.png"}).find("b.toml"), std::string::npos);
    EXPECT_NE(complaint({"render", "--out", "a.png", "--view", "depth"}).find("scene-depth"), std::string::npos);
}

TEST(CommandLine, WrongUses)
{
    EXPECT_NE(complaint({"render"}).find("--out"), std::string::npos);
    EXPECT_NE(complaint({"render", "--out"}), "");
    EXPECT_NE(complaint({"render", "--all-cameras", "--frames", "2", "--out", "d"}), "");
    EXPECT_NE(complaint({"render", "--all-cameras", "--camera", "a", "--out", "d"}), "");
    EXPECT_NE(complaint({"bench", "--frames", "0"}).find("--frames 0"), std::string::npos);
    EXPECT_NE(complaint({"render", "--fov", "180", "--out", "a.png"}), "");
    EXPECT_NE(complaint({"render", "--time", "soon", "--out", "a.png"}).find("soon"), std::string::npos);
}

TEST(Parse, Sizes)
{
    EXPECT_EQ(parseSize("1x16384", "--size"), ivec2(1, 16384));
    for (const char* wrong : {"", "x", "640", "640x", "x480", "0x5", "5x0", "-4x4", "640x480x3", "1e2x5", "16385x1",
                              "640 x480", "99999999999x1"})
        EXPECT_THROW(parseSize(wrong, "--size"), UsageError) << wrong;
}

TEST(Parse, Vectors)
{
    EXPECT_EQ(parseVec3("1,+2,-.5", "--eye"), vec3(1.0f, 2.0f, -0.5f));
    for (const char* wrong :
         {"", "1", "1,2", "1,2,3,4", "1,2,", ",,", "a,b,c", "nan,0,0", "inf,0,0", "1e99,0,0", "1 2 3"})
        EXPECT_THROW(parseVec3(wrong, "--eye"), UsageError) << wrong;
}

TEST(Parse, NumbersKeepTheirRange)
{
    EXPECT_DOUBLE_EQ(parseNumber("2", "--fov", 1.0, 2.0), 2.0);
    for (const char* wrong : {"", "0.99", "2.01", "nan", "inf", "1x", "0x1p0"})
        EXPECT_THROW(parseNumber(wrong, "--fov", 1.0, 2.0), UsageError) << wrong;
    EXPECT_EQ(parseCount("10", "--frames", 1, 10), 10);
    for (const char* wrong : {"0", "11", "1.5", "ten", "99999999999"})
        EXPECT_THROW(parseCount(wrong, "--frames", 1, 10), UsageError) << wrong;
}

TEST(Program, ExitStatusAndOneLineOfError)
{
    const auto unused = [](const ViewCommand&) { FAIL() << "the viewer was not asked for"; };
    testing::internal::CaptureStderr();
    EXPECT_EQ(runProgram({"render", "--no-such-flag"}, unused), 2);
    const std::string usage = testing::internal::GetCapturedStderr();
    EXPECT_EQ(usage.rfind("tarn: error: --no-such-flag", 0), 0u) << usage;
    EXPECT_EQ(usage.find('\n'), usage.size() - 1) << usage;

    testing::internal::CaptureStderr();
    EXPECT_EQ(runProgram({"explain", "no/such/scene.toml"}, unused), 1);
    const std::string missing = testing::internal::GetCapturedStderr();
    EXPECT_NE(missing.find("no/such/scene.toml"), std::string::npos) << missing;
    EXPECT_EQ(missing.find('\n'), missing.size() - 1) << missing;

    testing::internal::CaptureStderr();
    EXPECT_EQ(runProgram({"view"}, [](const ViewCommand&) { throw Error("two\nlines"); }), 1);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "tarn: error: two lines\n");
}

TEST(Program, ViewRunsTheViewerOnce)
{
    int views = 0;
    EXPECT_EQ(runProgram({"--time", "2"},
                         [&](const ViewCommand& command) {
                             ++views;
                             EXPECT_DOUBLE_EQ(command.view.time, 2.0);
                         }),
              0);
    EXPECT_EQ(views, 1);
}

} // namespace
} // namespace tarn
