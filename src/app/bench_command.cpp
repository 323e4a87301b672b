// tarn bench: what the frame costs with the water, without it, and with any option changed; or a table of the
// thesis, measured here.
#include "app/bench_interactive.h"
#include "app/command_flags.h"
#include "app/commands.h"
#include "app/machine.h"
#include "app/plan_report.h"
#include "app/rendered_subject.h"
#include "base/error.h"
#include "base/memory.h"
#include "measure/benchmark.h"
#include "measure/paper_tables.h"
#include "measure/yardstick.h"
#include "render/warm_up.h"

#include <nlohmann/json.hpp>

#include <optional>

namespace tarn {

namespace {

Settings changed(Settings settings, const std::string& assignment, const char* origin)
{
    assign(fieldTree(settings), parseAssignment(assignment, origin));
    return settings;
}

using Configuration = std::pair<std::string, Settings>;

/// In how many frames a rule applied.
struct RuleFraction {
    RuleId id;
    int frames = 0;
    int of = 0;
};

std::vector<RuleFraction> fractionsOf(const RenderedSubject& subject)
{
    std::vector<RuleFraction> fractions;
    for (std::size_t i = 0; i < ruleCount; ++i)
        fractions.push_back({static_cast<RuleId>(i), subject.ruleFrames()[i], subject.measuredFrames()});
    return fractions;
}

/// Of the frames that will be measured, drawn once with the settings as they are.
std::vector<RuleFraction> fractionsBefore(const BenchCommand& command, Session& session, const Settings& settings,
                                          const SubjectView& view)
{
    constexpr bool keepsPictures = true;
    RenderedSubject subject("planned", session, settings, view, keepsPictures);
    for (int index = 0; index < command.frames; ++index) {
        subject.prepare(index, index > 0);
        subject.draw(index);
    }
    return fractionsOf(subject);
}

nlohmann::json toJson(const std::vector<RuleFraction>& fractions)
{
    nlohmann::json json = nlohmann::json::array();
    for (const RuleFraction& fraction : fractions)
        json.push_back({{"name", rule(fraction.id).name}, {"frames", fraction.frames}, {"of", fraction.of}});
    return json;
}

std::string toTable(const std::vector<RuleFraction>& fractions)
{
    std::string text = "\nframes in which each rule of the plan applied\n";
    for (const RuleFraction& fraction : fractions)
        text += fmt::format("  {:<22}{:>5} of {}\n", rule(fraction.id).name, fraction.frames, fraction.of);
    return text;
}

/// The frame without any plan, without each rule that applies, and last, as the base, with all of them.
std::vector<Configuration> rulesOf(const Settings& settings, const std::vector<RuleFraction>& applied)
{
    std::vector<Configuration> configurations;
    configurations.emplace_back("full", changed(settings, "plan.enabled=false", "--rules"));
    for (const RuleFraction& fraction : applied) {
        const std::string assignment = fmt::format("plan.{}=false", rule(fraction.id).name);
        if (fraction.frames > 0) configurations.emplace_back(assignment, changed(settings, assignment, "--rules"));
    }
    configurations.emplace_back("planned", settings);
    return configurations;
}

std::vector<Configuration> configurationsOf(const BenchCommand& command, const Settings& settings,
                                            const std::vector<RuleFraction>& applied)
{
    std::vector<Configuration> configurations;
    if (command.table) {
        const std::string origin = fmt::format("--table {}", command.table->number);
        for (const PaperRow& row : command.table->rows) {
            Settings rowSettings = settings;
            for (const std::string& assignment : row.assignments)
                rowSettings = changed(std::move(rowSettings), assignment, origin.c_str());
            configurations.emplace_back(row.name, std::move(rowSettings));
        }
        return configurations;
    }
    if (command.rules) return rulesOf(settings, applied);
    configurations.emplace_back("water", settings);
    for (const std::string& variant : command.variants)
        configurations.emplace_back(variant, changed(settings, variant, "--vary"));
    configurations.emplace_back("dry", changed(settings, "water.enabled=false", "bench"));
    return configurations;
}

} // namespace

void run(const BenchCommand& command)
{
    if (command.interactive) return runInteractive(command);
    requireWritableJson(command.json);
    if (command.startup) return benchStartup(command);
    TerminalProgress progress;
    const SceneSetup sceneSetup = loadSceneSetup(command.scene, &progress);
    const SubjectView view{.camera = chooseCamera(sceneSetup.scene, command.view.camera),
                           .time = command.view.time,
                           .size = command.view.size,
                           .flight = command.flight ? sceneSetup.scene.cameras : std::vector<Camera>{},
                           .frames = command.frames};

    Session session(sceneSetup, command.view.size, &progress);
    if (command.flight) warmUp(session.renderer(), sceneSetup.settings.water);
    std::vector<RuleFraction> fractions;
    if (command.rules) fractions = fractionsBefore(command, session, sceneSetup.settings, view);
    const std::vector<Configuration> configurations = configurationsOf(command, sceneSetup.settings, fractions);
    std::vector<std::unique_ptr<BenchSubject>> subjects;
    std::vector<const RenderedSubject*> rendered; // the same
    for (const auto& [name, settings] : configurations) {
        auto subject = std::make_unique<RenderedSubject>(name, session, settings, view, command.rules);
        rendered.push_back(subject.get());
        subjects.push_back(std::move(subject));
    }
    std::optional<Yardstick> yardstick;
    if (command.yardstick) yardstick.emplace(session.shaders());
    BenchReport report = runBenchmark(subjects, {.frames = command.frames, .warmUp = command.warmUp}, &progress,
                                      yardstick ? &*yardstick : nullptr);
    report.context = {{"machine", machineText()},
                      {"renderer", session.context().renderer()},
                      {"OpenGL", session.context().version()},
                      {"scene", sceneSetup.scene.file.string()},
                      {"camera", command.flight ? "a flight past all of the scene's" : view.camera.name},
                      {"size", fmt::format("{}x{}", command.view.size.x, command.view.size.y)}};
    // The settings as given: the first, or with --rules the last of the configurations.
    const RenderedSubject& given = command.rules ? *rendered.back() : *rendered.front();
    fractions = fractionsOf(given);
    nlohmann::json json = command.table ? toJson(*command.table, report) : toJson(report);
    json["plan"] = toJson(given.plan());
    json["rules"] = toJson(fractions);
    const ProcessMemory memory = processMemory();
    json["memory"] = {{"resident_bytes", memory.resident},
                      {"file_bytes", memory.files},
                      {"peak_bytes", memory.peak},
                      {"geometry_bytes", session.renderer().geometryBytes()}};
    writeJson(command.json, json);
    if (command.json != "-") {
        fmt::print("{}", command.table ? toMarkdown(*command.table, report) + yardstickLines(report) : toTable(report));
        if (!command.table) fmt::print("{}", toTable(fractions));
    }
}

MakeCommand defineBench(Flags& flags)
{
    auto command = std::make_shared<BenchCommand>();
    command->view.size = {1024, 768};
    addSceneFlags(flags, command->scene);
    addViewFlags(flags, command->view);
    flags.count("--frames", "Frames measured of each configuration", command->frames, 1, 1000000);
    flags.count("--warm-up", "Frames drawn first and not counted", command->warmUp, 0, 10000);
    flags.list("--vary", "KEY=VALUE", "Measure one more configuration, with this option set", command->variants);
    flags.toggle("--flight",
                 "Fly past the scene's cameras, from the first to the last, in the frames that are measured",
                 command->flight);
    flags.toggle("--yardstick",
                 "Measure one plain pass of 100,352 textured triangles at 1024x768 too, and tell all else in it",
                 command->yardstick);
    flags.toggle("--rules", "Measure the frame plan: without each rule that applies, and without all of them",
                 command->rules);
    flags.toggle("--interactive",
                 "Fly past the scene's cameras at real speed: times of frames, and from input to picture",
                 command->interactive);
    flags.number("--seconds", "S", "Length of the flight of --interactive, s", command->seconds, 0.1, 3600.0);
    flags.value("--table", "N", "Measure table 2 or 3 of Mihalik 2008, chapter 10, beside its figures",
                [command = command.get()](const std::string& text, const std::string& flag) {
                    command->table = &findPaperTable(text, flag);
                });
    flags.toggle(
        "--startup",
        "Measure when this process, since it began, has its scene, its first picture and all its programs; with "
        "MESA_SHADER_CACHE_DIR set to an empty folder that is a first start",
        command->startup);
    flags.json(command->json);
    return [command] {
        if (command->interactive &&
            (command->table || command->flight || command->rules || command->yardstick || !command->variants.empty()))
            throw UsageError("--interactive has a flight of its own; leave --table, --flight, --rules, --yardstick and "
                             "--vary away");
        if (command->startup && (command->table || command->flight || command->rules || command->yardstick ||
                                 command->interactive || !command->variants.empty()))
            throw UsageError(
                "--startup measures one start; leave --table, --flight, --rules, --yardstick, --interactive and "
                "--vary away");
        if (command->table && !command->variants.empty())
            throw UsageError("--table has configurations of its own; leave --vary away");
        if (command->table && (command->flight || command->rules))
            throw UsageError("--table has a view and configurations of its own; leave --flight and --rules away");
        return *command;
    };
}

} // namespace tarn
