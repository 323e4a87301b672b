// Wavefront OBJ files, through tinyobjloader. Private to src/scene.
#pragma once

#include "scene/scene.h"
#include "scene/textures.h"

#include <filesystem>

namespace tarn {

/// Reads a mesh; its materials are appended to scene.materials, their pictures asked for.
/// Records that cannot be used are left out with a warning that names file and line.
/// Throws Error when the file cannot be read or nothing in it can be drawn.
/// @param material an index that replaces the file's own materials, or -1
Mesh readObj(const std::filesystem::path& file, Scene& scene, TextureQueue& textures, int material);

} // namespace tarn
