// The options of a run, from the five places that may set them; later ones win:
// defaults < the scene file's [options] < --preset NAME < --options FILE < --set key=value.
#pragma once

#include "base/fields.h"
#include "plan/options.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tarn {

/// Everything that --set, the panel and a result's JSON know by key. "water.*" holds both how the surface is
/// drawn and the scene's body of water.
struct Settings {
    Options options;
    WaterBody water;
};

/// The tree refers to `settings`, which must outlive it.
FieldTree fieldTree(Settings& settings);

/// Where options came from on the command line.
struct SettingsArguments {
    std::vector<std::filesystem::path> files; ///< --options
    std::vector<std::string> assignments;     ///< --set, "key=value"
    std::string preset{};                     ///< --preset; empty: none
};

/// Reads a TOML file of the keys that --set takes: [refraction] steps = 3, or refraction.steps = 3.
std::vector<Assignment> readOptionsFile(const std::filesystem::path& file);

/// Throws UsageError for the command line's mistakes and Error for the scene file's.
Settings resolveSettings(const Scene& scene, const SettingsArguments& arguments);

/// Throws Error when the settings draw for two eyes.
/// @param why one is wanted, after a colon: "errors are measured in one eye's picture"
void requireOneEye(const Settings& settings, const char* why);

/// The settings as JSON, for the header of a picture.
std::string settingsJson(Settings settings);

} // namespace tarn
