// tarn bench: what the frame costs with the water, without it, and with any option changed; or a table of the
// thesis, measured here.
#include "app/commands.h"
#include "app/machine.h"
#include "app/rendered_subject.h"
#include "base/error.h"
#include "measure/benchmark.h"
#include "measure/paper_tables.h"

#include <nlohmann/json.hpp>

namespace tarn
{

namespace
{

Settings changed(Settings settings, const std::string& assignment, const char* origin)
{
    assign(fieldTree(settings), parseAssignment(assignment, origin));
    return settings;
}

using Configuration = std::pair<std::string, Settings>;

std::vector<Configuration> configurationsOf(const BenchCommand& command, const Settings& settings)
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
    configurations.emplace_back("water", settings);
    for (const std::string& variant : command.variants)
        configurations.emplace_back(variant, changed(settings, variant, "--vary"));
    configurations.emplace_back("dry", changed(settings, "water.enabled=false", "bench"));
    return configurations;
}

} // namespace

void run(const BenchCommand& command)
{
    requireWritableJson(command.json);
    TerminalProgress progress;
    const Stage stage = loadStage(command.scene, &progress);
    const SubjectView view{chooseCamera(stage.scene, command.view.camera), command.view.time,
                           command.view.size};
    const std::vector<Configuration> configurations = configurationsOf(command, stage.settings);

    Session session(stage, command.view.size, &progress);
    std::vector<std::unique_ptr<BenchSubject>> subjects;
    for (const auto& [name, settings] : configurations) {
        if (command.table || command.settled)
            subjects.push_back(std::make_unique<SettledSubject>(name, session, settings, view));
        else
            subjects.push_back(std::make_unique<RenderedSubject>(name, session, settings, view));
    }
    BenchReport report =
        runBenchmark(subjects, {.frames = command.frames, .warmUp = command.warmUp}, &progress);
    report.context = {{"machine", machineText()},
                      {"renderer", session.context().renderer()},
                      {"OpenGL", session.context().version()},
                      {"scene", stage.scene.file.string()},
                      {"camera", view.camera.name},
                      {"size", fmt::format("{}x{}", command.view.size.x, command.view.size.y)}};
    nlohmann::json json = command.table ? toJson(*command.table, report) : toJson(report);
    const ProcessMemory memory = processMemory();
    json["memory"] = {{"resident_bytes", memory.resident},
                      {"peak_bytes", memory.peak},
                      {"geometry_bytes", session.renderer().geometryBytes()}};
    writeJson(command.json, json);
    if (command.json != "-")
        fmt::print("{}", command.table ? toMarkdown(*command.table, report) : toTable(report));
}

} // namespace tarn
