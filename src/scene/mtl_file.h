// Wavefront MTL files, through tinyobjloader. Private to src/scene.
#pragma once

#include "scene/scene.h"
#include "scene/textures.h"

#include <filesystem>
#include <map>
#include <string>

namespace tarn {

/// Appends the materials of `file` to scene.materials and their numbers to `indexOf` (the first of a name wins).
/// Warns, as file:line, about values that cannot be used. Throws Error when the file cannot be read.
void readMtl(const std::filesystem::path& file, Scene& scene, TextureQueue& textures,
             std::map<std::string, int>& indexOf);

} // namespace tarn
