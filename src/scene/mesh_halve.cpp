// One step of mesh_detail.h: a piece of a mesh with half the triangles, and how far off that is.
#include "scene/mesh_collapse.h"
#include "scene/mesh_detail.h"
#include "scene/nearest_surface.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace tarn {

namespace {

/// The piece with vertices of its own.
struct Piece {
    std::vector<Vertex> vertices;
    std::vector<vec3> positions;
    std::vector<float> metresPerUv;        ///< of the texture at each vertex
    std::vector<std::uint32_t> vertexOf;   ///< of the mesh
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

/// For each vertex a number that all vertices joined to it by triangles, or in one place with it, share: a tree, a stone.
/// What was joined is compared with what came of it, not with a neighbour that happens to lie there.
std::vector<std::uint32_t> bodies(const Piece& piece)
{
    std::vector<std::uint32_t> parent(piece.positions.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](std::uint32_t v) {
        while (parent[v] != v) v = parent[v] = parent[parent[v]];
        return v;
    };
    for (std::size_t i = 0; i < piece.indices.size(); i += 3)
        for (const std::size_t k : {1u, 2u}) parent[root(piece.indices[i + k])] = root(piece.indices[i]);
    std::vector<std::uint32_t> byPlace(parent.size());
    std::iota(byPlace.begin(), byPlace.end(), 0u);
    const auto key = [&](std::uint32_t v) { return std::tuple(piece.positions[v].x, piece.positions[v].y, piece.positions[v].z); };
    std::sort(byPlace.begin(), byPlace.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    for (std::size_t i = 1; i < byPlace.size(); ++i)
        if (key(byPlace[i]) == key(byPlace[i - 1])) parent[root(byPlace[i])] = root(byPlace[i - 1]);
    for (std::uint32_t v = 0; v < parent.size(); ++v) parent[v] = root(v);
    return parent;
}

/// How far the vertices of a piece and the middles of its edges lie from what came of it.
class DistanceMeter {
public:
    DistanceMeter(const Piece& piece, std::span<const std::uint32_t> coarse)
        : piece_(piece), bodyOf_(bodies(piece)), byBody_(coarse.begin(), coarse.end())
    {
        for (std::uint32_t v = 0; v < piece.positions.size(); ++v) extents_[bodyOf_[v]].add(piece.positions[v]);
        sortByBody();
        for (std::size_t begin = 0, end = 0; begin < byBody_.size(); begin = end) {
            const std::uint32_t body = bodyOf_[byBody_[begin]];
            while (end < byBody_.size() && bodyOf_[byBody_[end]] == body) end += 3;
            const std::span<const std::uint32_t> indices(byBody_.data() + begin, end - begin);
            surfaces_.emplace(body, NearestSurface(piece.positions, indices));
        }
    }

    float largest() const
    {
        if (byBody_.empty()) return std::numeric_limits<float>::infinity();
        float most = 0.0f;
        for (std::uint32_t v = 0; v < piece_.positions.size(); ++v) most = std::max(most, at(piece_.positions[v], bodyOf_[v]));
        for (std::size_t i = 0; i < piece_.indices.size(); ++i) {
            const std::uint32_t a = piece_.indices[i], b = piece_.indices[i % 3 == 2 ? i - 2 : i + 1];
            most = std::max(most, at(0.5f * (piece_.positions[a] + piece_.positions[b]), bodyOf_[a]));
        }
        return most;
    }

private:
    void sortByBody()
    {
        std::vector<std::array<std::uint32_t, 3>> triangles(byBody_.size() / 3);
        for (std::size_t i = 0; i < byBody_.size(); ++i) triangles[i / 3][i % 3] = byBody_[i];
        std::stable_sort(triangles.begin(), triangles.end(),
                         [&](const auto& a, const auto& b) { return bodyOf_[a[0]] < bodyOf_[b[0]]; });
        for (std::size_t i = 0; i < byBody_.size(); ++i) byBody_[i] = triangles[i / 3][i % 3];
    }

    float at(const vec3& place, std::uint32_t body) const
    {
        const auto found = surfaces_.find(body);
        if (found == surfaces_.end()) return glm::length(extents_.at(body).extent()); // it is gone altogether
        return found->second.nearest(place).distance;
    }

    const Piece& piece_;
    std::vector<std::uint32_t> bodyOf_; ///< by vertex
    std::vector<std::uint32_t> byBody_; ///< the simplified triangles, those of a body together
    std::unordered_map<std::uint32_t, Bounds> extents_; ///< of bodies
    std::unordered_map<std::uint32_t, NearestSurface> surfaces_; ///< by body
};

} // namespace

Simplified halved(const Mesh& mesh, std::span<const std::uint32_t> indices, bool locksBorder)
{
    const Piece piece = pieceOf(mesh, indices);
    Simplified result;
    const std::size_t triangles = piece.indices.size() / 3;
    Collapsed collapsed = collapse(piece.vertices, piece.indices, piece.metresPerUv, 2 * triangles / 3, triangles / 2, locksBorder);
    result.indices = std::move(collapsed.indices);
    result.error = std::max(collapsed.worst, DistanceMeter(piece, result.indices).largest());
    meshopt_optimizeVertexCache(result.indices.data(), result.indices.data(), result.indices.size(), piece.vertices.size());
    for (std::uint32_t& index : result.indices) index = piece.vertexOf[index];
    return result;
}

} // namespace tarn
