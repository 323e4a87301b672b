#include "app/settings.h"

#include "app/presets.h"
#include "base/error.h"

#include <nlohmann/json.hpp>

namespace tarn {

FieldTree fieldTree(Settings& settings)
{
    return [&settings](FieldVisitor& visitor) {
        visit(visitor, settings.options);
        visit(visitor, settings.water);
    };
}

namespace {

/// A mistake in the scene file is the scene's, not the command line's.
void applySceneOptions(const FieldTree& tree, const Scene& scene)
{
    try {
        for (const Assignment& assignment : scene.options) assign(tree, assignment);
    } catch (const UsageError& error) {
        throw Error("{}", error.what());
    }
}

} // namespace

Settings resolveSettings(const Scene& scene, const SettingsArguments& arguments)
{
    Settings settings{Options{}, scene.water};
    const FieldTree tree = fieldTree(settings);
    applySceneOptions(tree, scene);
    std::vector<std::filesystem::path> files = arguments.files;
    if (!arguments.preset.empty()) files.insert(files.begin(), presetFile(arguments.preset));
    for (const std::filesystem::path& file : files)
        for (const Assignment& assignment : readOptionsFile(file)) assign(tree, assignment);
    for (const std::string& text : arguments.assignments) assign(tree, parseAssignment(text, "--set"));
    return settings;
}

void requireOneEye(const Settings& settings, const char* why)
{
    if (settings.options.stereo.isOn()) throw Error("stereo.output is on: {}; set stereo.output=off", why);
}

std::string settingsJson(Settings settings) { return toJson(fieldTree(settings)).dump(); }

} // namespace tarn
