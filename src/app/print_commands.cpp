// The commands that only tell: --help, options, explain; and where JSON goes.
#include "app/command_flags.h"
#include "app/commands.h"
#include "app/options_markdown.h"
#include "app/output.h"
#include "app/plan_report.h"
#include "app/scene_setup.h"
#include "base/error.h"
#include "base/files.h"
#include "render/debug_view.h"
#include "render/frame_light.h"
#include "render/gather_visibility.h"
#include "scene/sky.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>

namespace tarn {

void writeJson(const std::string& file, const nlohmann::json& json)
{
    if (file.empty()) return;
    // Names of files and cameras may hold bytes that are no UTF-8: replaced, not thrown at.
    const std::string text = json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
    if (file == "-") {
        fmt::print("{}", text);
    } else {
        writeFile(file, text);
    }
}

void requireWritableJson(const std::string& file)
{
    if (file.empty() || file == "-") return;
    if (std::filesystem::is_directory(file)) throw Error("--json {}: is a folder; give a file", file);
    requireWritableFolder(std::filesystem::path(file).parent_path());
}

void run(const PrintCommand& command) { fmt::print("{}", command.text); }

namespace {

/// Rows of one group together, in the order in which groups first appear.
std::vector<FieldRow> groupedRows(const FieldTree& tree)
{
    std::vector<FieldRow> rows = listFields(tree);
    std::vector<std::string> groups;
    const auto groupOf = [](const FieldRow& row) { return row.key.substr(0, row.key.find('.')); };
    for (const FieldRow& row : rows)
        if (std::find(groups.begin(), groups.end(), groupOf(row)) == groups.end()) groups.push_back(groupOf(row));
    const auto rank = [&](const FieldRow& row) { return std::find(groups.begin(), groups.end(), groupOf(row)); };
    std::stable_sort(rows.begin(), rows.end(), [&](const FieldRow& a, const FieldRow& b) { return rank(a) < rank(b); });
    return rows;
}

} // namespace

void run(const OptionsCommand& command)
{
    requireWritableJson(command.json);
    Settings settings;
    const std::vector<FieldRow> rows = groupedRows(fieldTree(settings));
    if (!command.json.empty()) {
        nlohmann::json json = nlohmann::json::array();
        for (const FieldRow& row : rows)
            json.push_back({{"key", row.key},
                            {"type", row.type},
                            {"default", row.value},
                            {"range", row.range},
                            {"unit", row.unit},
                            {"doc", row.doc}});
        writeJson(command.json, json);
        return;
    }
    if (command.markdown) {
        fmt::print("{}", optionsPage(rows, fieldTree(settings)));
        return;
    }
    fmt::print("{:<31}{:<8}{:<12}{:<28}{:<10}{}\n", "key", "type", "default", "range", "unit", "what it is");
    for (const FieldRow& row : rows)
        fmt::print("{:<31}{:<8}{:<12}{:<28}{:<10}{}\n", row.key, row.type, row.value, row.range, row.unit, row.doc);
    fmt::print("\n{:<31}{:<20}{:<10}{}\n", "debug view (--view)", "written by", "unit", "what it is");
    for (const DebugViewInfo& view : debugViews)
        fmt::print("{:<31}{:<20}{:<10}{}\n", view.name, passesOf(view.writer), view.unit, view.doc);
}

void run(const ExplainCommand& command)
{
    requireWritableJson(command.json);
    SceneSetup sceneSetup;
    {
        TerminalProgress progress;
        sceneSetup = loadSceneSetup(command.scene, &progress);
    }
    const Camera camera = chooseCamera(sceneSetup.scene, command.view.camera);
    std::optional<DepthComplexity> complexity;
    if (wantsDepthComplexity(sceneSetup.settings.options))
        complexity = depthComplexity(sceneSetup.scene, sceneSetup.settings.water);
    const Options& options = sceneSetup.settings.options;
    const WaterBody& water = sceneSetup.settings.water;
    const VisibilityFacts visibility =
        gatherVisibility(listBoxes(sceneSetup.scene), sceneSetup.scene, water, camera, command.view.size, options,
                         frameBlock(sceneSetup.scene, water, SkyModel(sceneSetup.scene), options));
    const FramePlan plan = planFrame(sceneSetup.scene, water, camera, options, command.view.size, command.view.time,
                                     complexity ? &*complexity : nullptr, &visibility);
    writeJson(command.json, toJson(plan));
    if (command.json != "-") fmt::print("{}", toTable(plan));
}

MakeCommand defineExplain(Flags& flags)
{
    auto command = std::make_shared<ExplainCommand>();
    command->view.size = {1024, 768};
    addSceneFlags(flags, command->scene);
    addViewFlags(flags, command->view);
    flags.json(command->json);
    return [command] { return *command; };
}

MakeCommand defineOptions(Flags& flags)
{
    auto command = std::make_shared<OptionsCommand>();
    flags.optionalText("--json", "FILE", "As JSON, to this file or to standard output", command->json, "-");
    flags.toggle("--markdown", "As tables in Markdown, one for each group", command->markdown);
    return [command]() -> Command {
        if (command->markdown && !command->json.empty())
            throw UsageError("--markdown or --json: options writes one of them");
        return *command;
    };
}

} // namespace tarn
