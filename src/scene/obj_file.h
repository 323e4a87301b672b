// Wavefront OBJ files, through tinyobjloader. Private to src/scene.
#pragma once

#include "scene/mtl_file.h"
#include "scene/scene.h"

#include <filesystem>

namespace tarn
{

/// Reads a mesh; its materials are those of the libraries it names.
/// Records that cannot be used are left out with a warning that names file and line.
/// Throws Error when the file cannot be read or nothing in it can be drawn.
/// @param material an index that replaces the file's own materials, or -1
Mesh readObj(const std::filesystem::path& file, Scene& scene, MtlLibrary& libraries, int material);

} // namespace tarn
