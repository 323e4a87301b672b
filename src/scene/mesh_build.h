// From triangles as a file gives them to a Mesh as a GPU likes it. Private to src/scene.
#pragma once

#include "scene/mesh_source.h"
#include "scene/scene.h"

#include <string>

namespace tarn {

/// Vertices deduplicated, tangents computed, triangles sorted by material and split into compact chunks
/// (MeshPart) of at most 4096, each ordered for the vertex cache and all for fetching (meshoptimizer).
/// @param source triangles only, every corner with a normal
Mesh buildMesh(const MeshSource& source, std::string name);

} // namespace tarn
