// Meshes and materials as Wavefront files. Numbers are written in a fixed format, so that equal meshes give
// equal bytes.
#pragma once

#include "mesh.h"

#include <filesystem>

namespace tarn::lake {

/// Writes `mesh` with vertex colours; equal texture coordinates and normals are written once.
void writeObj(const std::filesystem::path& file, const Mesh& mesh, const std::string& name);

/// Writes lake.mtl, the materials that all the meshes use.
void writeMaterials(const std::filesystem::path& folder);
inline constexpr const char* materialFile = "lake.mtl";

} // namespace tarn::lake
