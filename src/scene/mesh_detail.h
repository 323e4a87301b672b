// Levels of detail of a mesh: the same surface with fewer triangles, and how far off it is.
//
// Chunks that lie side by side (mesh_build.h) are put together two by two and made half as many triangles
// (mesh_collapse.h), until one is left; that is halved on its own. What borders on other chunks stays as it is, so that
// any two levels meet without a crack. A renderer goes down from the coarsest nodes and draws the first that is
// accurate enough.
#pragma once

#include "scene/scene.h"

#include <array>
#include <vector>

namespace tarn {

struct DetailNode {
    int material = 0;
    std::uint32_t firstIndex = 0, indexCount = 0; ///< counted through Mesh::indices and on into MeshDetail::indices
    Bounds bounds;                                ///< model space
    /// By how much the mesh at full detail may seem to be moved, m of model space: it lies no farther off than that;
    /// where colour, shading or texture differ, a difference that can be seen at all counts as far as it reaches.
    float error = 0.0f;
    std::array<int, 2> finer{-1, -1}; ///< the nodes that it stands for; -1: none
};

struct MeshDetail {
    std::vector<DetailNode> nodes; ///< the mesh's parts first, in their order
    std::vector<int> roots;        ///< the coarsest nodes: together, and no part twice, the mesh
    std::vector<std::uint32_t> indices;
};

/// @param materials of the scene: cut-out foliage is cards with open edges, and may lose them
MeshDetail buildDetail(const Mesh& mesh, const std::vector<Material>& materials);

/// A piece of a mesh with about half the triangles, and its error as in DetailNode, against the piece.
struct Simplified {
    std::vector<std::uint32_t> indices;
    float error = 0.0f;
};
/// @param indices triangles of the piece   @param locksBorder keep every edge that has no second triangle in the piece
Simplified halved(const Mesh& mesh, std::span<const std::uint32_t> indices, bool locksBorder);

} // namespace tarn
