// One step of mesh_detail.h: a piece of a mesh with half the triangles, and how far off that is.
#include "scene/mesh_collapse.h"
#include "scene/mesh_detail.h"

#include <meshoptimizer.h>

#include <cmath>
#include <unordered_map>

namespace tarn {

namespace {

/// The piece with vertices of its own.
struct Piece {
    std::vector<Vertex> vertices;
    std::vector<vec3> positions;
    std::vector<float> metresPerUv;      ///< of the texture at each vertex
    std::vector<std::uint32_t> vertexOf; ///< of the mesh
    std::vector<std::uint32_t> indices;
};

/// How large the texture is about each vertex: the root of its triangles' areas over those in the texture.
std::vector<float> textureScales(const Piece& piece)
{
    std::vector<vec2> areas(piece.vertices.size(), vec2(0.0f)); // of the surface, of the texture
    for (std::size_t i = 0; i < piece.indices.size(); i += 3) {
        const Vertex &a = piece.vertices[piece.indices[i]], &b = piece.vertices[piece.indices[i + 1]],
                     &c = piece.vertices[piece.indices[i + 2]];
        const vec2 d1 = b.uv - a.uv, d2 = c.uv - a.uv;
        const vec2 area(glm::length(glm::cross(b.position - a.position, c.position - a.position)),
                        std::abs(d1.x * d2.y - d1.y * d2.x));
        for (std::size_t k = 0; k < 3; ++k) areas[piece.indices[i + k]] += area;
    }
    std::vector<float> scales;
    for (const vec2& area : areas) scales.push_back(area.y > 1.0e-12f ? std::sqrt(area.x / area.y) : 0.0f);
    return scales;
}

Piece pieceOf(const Mesh& mesh, std::span<const std::uint32_t> indices)
{
    Piece piece;
    std::unordered_map<std::uint32_t, std::uint32_t> known;
    known.reserve(indices.size());
    piece.indices.reserve(indices.size());
    for (const std::uint32_t vertex : indices) {
        const auto [found, isNew] = known.try_emplace(vertex, static_cast<std::uint32_t>(piece.vertices.size()));
        if (isNew) {
            piece.vertices.push_back(mesh.vertices[vertex]);
            piece.positions.push_back(mesh.vertices[vertex].position);
            piece.vertexOf.push_back(vertex);
        }
        piece.indices.push_back(found->second);
    }
    piece.metresPerUv = textureScales(piece);
    return piece;
}

} // namespace

Simplified halved(const Mesh& mesh, std::span<const std::uint32_t> indices, bool locksBorder)
{
    const Piece piece = pieceOf(mesh, indices);
    Simplified result;
    const std::size_t triangles = piece.indices.size() / 3;
    const Collapsed collapsed =
        collapse(piece.vertices, piece.indices, piece.metresPerUv, 2 * triangles / 3, triangles / 2, locksBorder);
    result.error = collapsed.worst;
    result.indices.resize(collapsed.indices.size());
    meshopt_optimizeVertexCache(result.indices.data(), collapsed.indices.data(), result.indices.size(),
                                piece.vertices.size());
    for (std::uint32_t& index : result.indices) index = piece.vertexOf[index];
    return result;
}

} // namespace tarn
