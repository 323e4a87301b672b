// Scene files: TOML (README, "The scene file"), or a bare Wavefront OBJ.
#pragma once

#include "base/progress.h"
#include "scene/scene.h"

#include <filesystem>

namespace tarn {

struct LoadOptions {
    std::optional<float> waterLevel; ///< overrides the file's (and gives a bare OBJ its lake)
    Progress* progress = nullptr;    ///< told about files read and pictures decoded; may be null
};

/// Loads `file` and everything it names. Throws Error (one line: file, place, what to do) when nothing can be
/// drawn; warns (file:line) and carries on when something can.
Scene loadScene(const std::filesystem::path& file, const LoadOptions& options = {});

/// Writes the TOML that loadScene reads back to the same scene (models and pictures stay in their files).
/// The file appears whole or not at all.
void saveScene(const Scene& scene, const std::filesystem::path& file);

} // namespace tarn
