// tarn tune: the settings for this machine that keep a limit of error, or of time.
#include "app/command_flags.h"
#include "app/commands.h"
#include "app/output.h"
#include "app/trade_experiment.h"
#include "app/version.h"
#include "base/error.h"
#include "base/files.h"
#include "measure/trade/presets.h"
#include "measure/trade/tune.h"

namespace tarn {

namespace {

constexpr std::size_t mostViews = 4; // when none are named

std::string goalText(const TuneGoal& goal)
{
    return goal.maxError ? fmt::format("mean FLIP of at most {}", *goal.maxError)
                         : fmt::format("at most {} ms a frame", *goal.budgetMs);
}

std::string foundText(const Tuned& tuned)
{
    return fmt::format("{:.1f} ms a frame, mean FLIP {:.4f}", tuned.ms, tuned.error);
}

/// A machine or scene that cannot reach the goal is told what it can reach.
void requireReached(const TuneGoal& goal, const TuneOutcome& outcome)
{
    if (outcome.reached) return;
    std::string changes;
    for (const auto& [key, value] : outcome.best.point.changes) changes += fmt::format(" --set {}={}", key, value);
    throw Error("{} is out of reach here; the nearest of {} settings has {}:{}", goalText(goal), outcome.tried,
                foundText(outcome.best), changes.empty() ? " the base" : changes);
}

std::string fileText(const TuneCommand& command, const SceneSetup& sceneSetup, const TradeSetup& setup,
                     const TuneOutcome& outcome, const std::string& machine)
{
    return presetText(setup, outcome.best.point,
                      {fmt::format("{}.", foundText(outcome.best)),
                       fmt::format("Found by tarn tune {}: {}, the best of {} settings.", versionText(),
                                   goalText({command.maxError, command.budgetMs}), outcome.tried),
                       fmt::format("{} at {}x{}, {}.", sceneSetup.scene.file.filename().string(), command.size.x,
                                   command.size.y, fmt::join(setup.views, ", ")),
                       fmt::format("On {}.", machine)});
}

} // namespace

void run(const TuneCommand& command)
{
    if (!command.out.empty()) requireWritableFolder(command.out.parent_path());
    TerminalProgress progress;
    const SceneSetup sceneSetup = loadSceneSetup(command.scene, &progress);
    requireOneEye(sceneSetup.settings, "errors are measured in one eye's picture");
    const std::vector<Camera> views = chooseViews(sceneSetup.scene, command.cameras, mostViews, "--camera");
    TradeSetup setup;
    setup.describe = describerOf(sceneSetup.settings);
    setup.plan = planTrade({{}, false, loadPresets()}, setup.describe);
    for (const Camera& camera : views) setup.views.push_back(camera.name);

    TuneRequest request{
        {command.maxError, command.budgetMs}, {setup.plan.base()}, {}, setup.describe, views.size(), command.time};
    for (const auto& [name, index] : setup.plan.presets) addPoint(request.candidates, setup.plan.points[index]);
    for (const TradePlan::SweptPoints& swept : setup.plan.sweeps)
        if (swept.sweep.with.empty()) request.sweeps.push_back(swept.sweep); // the search changes one option at a time

    const auto experiment = makeTradeExperiment(sceneSetup,
                                                {.views = views,
                                                 .size = command.size,
                                                 .times = std::vector<double>(views.size(), command.time),
                                                 .frames = command.frames,
                                                 .samples = command.samples,
                                                 .references = {}},
                                                &progress);
    const TuneOutcome outcome = tune(request, *experiment, &progress);
    requireReached(request.goal, outcome);
    const std::string text = fileText(command, sceneSetup, setup, outcome, experiment->machine());
    if (command.out.empty()) {
        fmt::print("{}", text);
    } else {
        writeFile(command.out, text);
        fmt::print("{}: {}\n", command.out.string(), foundText(outcome.best));
    }
}

MakeCommand defineTune(Flags& flags)
{
    auto command = std::make_shared<TuneCommand>();
    TuneCommand& c = *command;
    addSceneFlags(flags, c.scene);
    flags.number("--max-error", "FLIP", "The cheapest settings with at most this mean FLIP", c.maxError, 0.0, 1.0);
    flags.number("--budget-ms", "MS", "The most accurate settings within so many milliseconds a frame", c.budgetMs,
                 1e-3, 1e6);
    flags.list("--camera", "NAME", "A camera to tune for; may be repeated; the scene's first four by default",
               c.cameras);
    flags.size("Size of the picture, pixels", c.size);
    flags.number("--time", "S", "Time of the waves, s", c.time, -1e6, 1e6);
    flags.count("--frames", "Frames timed of each setting", c.frames, 1, 100000);
    flags.count("--samples", "Paths through each pixel of the reference", c.samples, 1, 65536);
    flags.path("--out", "FILE", "A file for --options; standard output by default", c.out);
    return [command]() -> Command {
        if (command->maxError.has_value() == command->budgetMs.has_value())
            throw UsageError("tune needs one goal: --max-error FLIP or --budget-ms MS");
        return *command;
    };
}

} // namespace tarn
