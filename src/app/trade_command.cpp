// tarn trade: what every setting costs in time and in accuracy, measured, stored and told.
#include "app/command_flags.h"
#include "app/commands.h"
#include "app/interrupt.h"
#include "app/output.h"
#include "app/parse.h"
#include "app/trade_experiment.h"
#include "app/version.h"
#include "base/error.h"
#include "base/files.h"
#include "base/hash.h"
#include "measure/trade/ladder.h"
#include "measure/trade/presets.h"
#include "measure/trade/report.h"
#include "measure/trade/runner.h"

#include <fmt/chrono.h>
#include <nlohmann/json.hpp>

#include <ctime>
#include <tuple>

namespace tarn {

namespace {

constexpr std::size_t mostViews = 8; // when none are named
constexpr std::size_t mostLadderViews = 4;

std::string titleOf(const Scene& scene) { return scene.name.empty() ? scene.file.stem().string() : scene.name; }

/// What tells one scene from another that has its name: its file's text and how much there is in it.
std::string contentOf(const Scene& scene)
{
    std::size_t vertices = 0, faces = 0;
    for (const Mesh& mesh : scene.meshes) {
        vertices += mesh.vertices.size();
        faces += mesh.indices.size() / 3;
    }
    std::string text = readFile(scene.file);
    for (const GivenMap* map : {&scene.maps.bed, &scene.maps.aboveWater})
        if (map->picture) text += readFile(map->picture->file);
    return fmt::format("{} vertices, {} faces, file {:016x}", vertices, faces, fnv1a(text));
}

TradeSetup setupOf(const TradeCommand& command, const SceneSetup& sceneSetup, const std::vector<Camera>& views)
{
    TradeSetup setup;
    setup.describe = describerOf(sceneSetup.settings);
    const bool isLadder = !command.writeLadder.empty();
    std::vector<Preset> presets = command.sweeps.empty() ? loadPresets() : std::vector<Preset>{};
    if (isLadder) std::erase_if(presets, [](const Preset& preset) { return preset.name != "thesis"; }); // for `fast`
    setup.plan = planTrade({command.sweeps, command.grid, presets, command.presetsOnly, isLadder}, setup.describe);
    for (const Camera& camera : views) setup.views.push_back(camera.name);
    setup.takesTurns = command.times.empty() && !isLadder; // few views, each of them timed
    setup.times = command.times;
    if (setup.times.empty()) setup.times = isLadder ? std::vector<double>{0.0} : std::vector<double>{0.0, 1.7};
    setup.about = {{"scene", sceneSetup.scene.file.filename().string()},
                   {"content", contentOf(sceneSetup.scene)},
                   {"size", fmt::format("{}x{}", command.size.x, command.size.y)},
                   {"frames", fmt::format("{}", command.frames)},
                   {"samples", fmt::format("{}", command.samples)},
                   {"version", versionText()},
                   {"base", settingsJson(sceneSetup.settings)}};
    return setup;
}

std::string today()
{
    const std::time_t now = std::time(nullptr);
    return fmt::format("{:%d %B %Y}", fmt::localtime(now));
}

std::string joined(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, "; ")); }

void writeResults(const TradeCommand& command, const SceneSetup& sceneSetup, const TradeSetup& setup,
                  const TradeStore& store, const TradeResults& results)
{
    const auto write = [&](const char* name, const std::string& text) {
        writeFile(command.out / name, text);
        fmt::print("{}\n", (command.out / name).string());
    };
    write("results.csv", toCsv(setup, results));
    write("results.json",
          toJson(setup, results, command.commandLine).dump(1, ' ', false, nlohmann::json::error_handler_t::replace) +
              "\n");
    write("report.html", tradeReport(setup, results, store, {titleOf(sceneSetup.scene), today(), command.commandLine}));
}

void writePresets(const TradeCommand& command, const SceneSetup& sceneSetup, const TradeSetup& setup,
                  const TradeResults& results)
{
    for (const PresetPick& pick : pickPresets(setup, results)) {
        const PointResult& result = results.points[pick.point];
        const std::vector<std::string> comment{fmt::format("Preset {}: {}.", pick.name, measuredText(result.mean)),
                                               fmt::format("Measured by tarn trade {}: {}, {}, mean of {}.",
                                                           versionText(), titleOf(sceneSetup.scene),
                                                           setup.about.at("size"), fmt::join(setup.views, ", ")),
                                               fmt::format("On {}.", joined(results.machines))};
        const std::filesystem::path file = command.writePresets / (pick.name + ".toml");
        writeFile(file, presetText(setup, result.point, comment));
        fmt::print("{}\n", file.string());
    }
}

void writeLadder(const TradeCommand& command, const SceneSetup& sceneSetup, const TradeSetup& setup,
                 const TradeResults& results)
{
    Ladder ladder = pickLadder(setup, results, greedySweepError(setup, results.points));
    ladder.scene = titleOf(sceneSetup.scene);
    ladder.size = setup.about.at("size");
    ladder.machine = joined(results.machines);
    const std::vector<std::string> comment{
        "What the viewer's governor moves along (docs/governor.md). Costs are ratios to the first rung, which is the",
        "scene's own settings; flip is the mean FLIP, wrong_hits the fraction of refracted rays that end 5 cm off or "
        "more.",
        fmt::format("Measured by tarn trade {}: {}, {}, mean of {}.", versionText(), ladder.scene, ladder.size,
                    fmt::join(setup.views, ", "))};
    writeFile(command.writeLadder, ladderText(setup, ladder, comment));
    fmt::print("{}\n", command.writeLadder.string());
}

TradeResults measure(const TradeCommand& command, const SceneSetup& sceneSetup, const std::vector<Camera>& views,
                     const TradeSetup& setup, TradeStore& store)
{
    const auto experiment = [&] {
        TerminalProgress progress;
        std::vector<double> times;
        for (std::size_t view = 0; view < views.size(); ++view)
            times.push_back(setup.times[setup.timesOf(view).front()]);
        return makeTradeExperiment(sceneSetup,
                                   {.views = views,
                                    .size = command.size,
                                    .times = times,
                                    .frames = command.frames,
                                    .samples = command.samples,
                                    .references = command.out / "references"},
                                   &progress);
    }();
    TerminalProgress progress;  // starts counting here
    const InterruptGuard guard; // the unit that is being measured comes to its end
    const RunArguments arguments{command.shard, command.shards, [] { return InterruptGuard::flag().load(); },
                                 &progress};
    return runTrade(setup, store, *experiment, arguments).results;
}

} // namespace

void run(const TradeCommand& command)
{
    requireReportParts();
    if (!command.writePresets.empty()) {
        makeFolder(command.writePresets);
        requireWritableFolder(command.writePresets);
    }
    const SceneSetup sceneSetup = [&] {
        TerminalProgress progress;
        return loadSceneSetup(command.scene, &progress);
    }();
    requireOneEye(sceneSetup.settings, "errors are measured in one eye's picture");
    for (const std::string& sweep : command.sweeps)
        if (sweep.starts_with("stereo."))
            throw UsageError(
                "--sweep {}: errors are measured in one eye's picture; tarn bench --vary tells what two cost", sweep);
    const std::size_t most = command.writeLadder.empty() ? mostViews : mostLadderViews;
    const std::vector<Camera> views = chooseViews(sceneSetup.scene, command.views, most, "--views");
    const TradeSetup setup = setupOf(command, sceneSetup, views);
    TradeStore store(command.out, keyOf(setup), command.fresh);

    TradeResults results;
    if (command.merge.empty()) {
        results = measure(command, sceneSetup, views, setup, store);
    } else {
        store.merge(command.merge);
        results = collectResults(setup, store);
    }
    if (!results.complete())
        fmt::print(stderr,
                   "tarn: {} of {} measurements are there; the same command without --shard and --merge "
                   "makes the rest\n",
                   results.done, results.total);
    if (command.shards > 1 && !results.complete()) return;
    writeResults(command, sceneSetup, setup, store, results);
    if (!command.writePresets.empty()) writePresets(command, sceneSetup, setup, results);
    if (!command.writeLadder.empty() && results.complete()) writeLadder(command, sceneSetup, setup, results);
}

MakeCommand defineTrade(Flags& flags)
{
    auto command = std::make_shared<TradeCommand>();
    TradeCommand& c = *command;
    addSceneFlags(flags, c.scene);
    flags.path("--out", "DIR", "Folder of the results, the tables and report.html; made when it is not there", c.out);
    flags.list("--sweep", "KEY=VALUES",
               "Sweep an option: 1:8, 1:64:*2, 0:1:0.25 or a,b,c, and a,b@OTHER=c while another is set; a plan of "
               "its own by default",
               c.sweeps);
    flags.toggle("--grid", "Every combination of the sweeps, instead of one option at a time", c.grid);
    flags.toggle("--presets-only", "Measure the options as given and the presets, and sweep nothing", c.presetsOnly);
    flags.value("--views", "NAMES", "Cameras, a,b,c; the scene's first eight by default",
                [&c](const std::string& text, const std::string& flag) { c.views = parseNames(text, flag); });
    flags.value("--times", "S,S",
                "Times of the waves, s, all of them in each view; by default the views take turns at 0 and 1.7",
                [&c](const std::string& text, const std::string& flag) { c.times = parseNumbers(text, flag); });
    flags.size("Size of the pictures, pixels", c.size);
    flags.count("--frames", "Frames timed of each setting", c.frames, 1, 100000);
    flags.count("--samples", "Paths through each pixel of the reference", c.samples, 1, 65536);
    flags.value("--shard", "I/N", "Measure only part I of N; --merge puts the parts together",
                [&c](const std::string& text, const std::string& flag) {
                    std::tie(c.shard, c.shards) = parseShard(text, flag);
                });
    auto merge = std::make_shared<std::vector<std::string>>();
    flags.list("--merge", "DIR", "Put another folder's results into --out and measure nothing; may be repeated",
               *merge);
    flags.toggle("--fresh", "Throw the results in --out away and start anew", c.fresh);
    flags.path("--write-presets", "DIR",
               "Write fast, low, medium, high and best.toml, picked from the front; with --write-ladder fast.toml",
               c.writePresets);
    flags.path("--write-ladder", "FILE",
               "Measure what is cheaper than the settings, and write the front as a ladder for the viewer's governor",
               c.writeLadder);
    flags.finally([merge, &c] { c.merge.assign(merge->begin(), merge->end()); });
    return [command]() -> Command {
        if (command->out.empty()) throw UsageError("trade needs --out DIR, a folder for its results");
        if (!command->writeLadder.empty() && (!command->sweeps.empty() || command->grid || command->presetsOnly))
            throw UsageError("--write-ladder has a plan of its own; leave --sweep, --grid and --presets-only away");
        if (command->shards > 1 && !command->writeLadder.empty())
            throw UsageError("--shard measures a part only; leave --write-ladder away");
        if (command->shards > 1 && (!command->merge.empty() || !command->writePresets.empty()))
            throw UsageError("--shard measures a part only; leave --merge and --write-presets away");
        return *command;
    };
}

} // namespace tarn
