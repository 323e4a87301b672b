#include "scene/mesh_build.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tarn {

namespace {

constexpr std::size_t trianglesPerChunk = 1024;

/// What makes two corners the same vertex. Mirrored texture coordinates turn the tangent frame inside out, so
/// the two hands must not share vertices.
struct VertexKey {
    Corner corner;
    std::int32_t hand; ///< 1 or -1
};

std::int32_t handOf(const MeshSource& source, const Corner* corners)
{
    vec2 uv[3];
    for (int i = 0; i < 3; ++i) {
        if (corners[i].uv < 0) return 1;
        uv[i] = source.uvs[static_cast<std::size_t>(corners[i].uv)];
    }
    const vec2 a = uv[1] - uv[0], b = uv[2] - uv[0];
    return a.x * b.y - a.y * b.x < 0.0f ? -1 : 1;
}

/// Makes equal elements one and renumbers `indices` (empty: one per element, in order).
template <typename T> void mergeEqual(std::vector<std::uint32_t>& indices, std::vector<T>& elements)
{
    std::vector<std::uint32_t> remap(elements.size());
    const std::size_t count = meshopt_generateVertexRemap(remap.data(), indices.empty() ? nullptr : indices.data(),
                                                          indices.empty() ? elements.size() : indices.size(),
                                                          elements.data(), elements.size(), sizeof(T));
    if (indices.empty()) {
        indices = remap;
    } else {
        for (std::uint32_t& index : indices) index = remap[index];
    }
    std::vector<T> merged(count);
    for (std::size_t i = 0; i < elements.size(); ++i)
        if (remap[i] < count) merged[remap[i]] = elements[i];
    elements = std::move(merged);
}

Vertex vertexOf(const MeshSource& source, const VertexKey& key)
{
    Vertex vertex;
    const auto position = static_cast<std::size_t>(key.corner.position);
    vertex.position = source.positions[position];
    vertex.normal = source.normals[static_cast<std::size_t>(key.corner.normal)];
    vertex.uv = key.corner.uv >= 0 ? source.uvs[static_cast<std::size_t>(key.corner.uv)] : vec2(0.0f);
    vertex.tangent = vec4(0.0f, 0.0f, 0.0f, static_cast<float>(key.hand));
    if (position < source.colours.size()) vertex.colour = source.colours[position];
    return vertex;
}

void weldVertices(const MeshSource& source, Mesh& mesh)
{
    std::vector<VertexKey> keys;
    keys.reserve(source.corners.size());
    for (std::size_t i = 0; i + 2 < source.corners.size(); i += 3) {
        const std::int32_t hand = handOf(source, &source.corners[i]);
        for (std::size_t k = 0; k < 3; ++k) keys.push_back({source.corners[i + k], hand});
    }
    mergeEqual(mesh.indices, keys); // by index first: small keys, and most duplicates are found here

    mesh.vertices.reserve(keys.size());
    for (const VertexKey& key : keys) mesh.vertices.push_back(vertexOf(source, key));
    mergeEqual(mesh.indices, mesh.vertices); // by value: files that repeat every record for every face
}

/// Any unit vector across the normal.
vec3 acrossNormal(const vec3& normal)
{
    const vec3 other = std::abs(normal.x) < 0.9f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 0.0f, 1.0f);
    return glm::normalize(other - normal * glm::dot(normal, other));
}

/// Tangents along +u, mean over the triangles around each vertex (Lengyel 2001).
void computeTangents(Mesh& mesh)
{
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        Vertex* v[3];
        for (std::size_t k = 0; k < 3; ++k) v[k] = &mesh.vertices[mesh.indices[i + k]];
        const vec3 e1 = v[1]->position - v[0]->position, e2 = v[2]->position - v[0]->position;
        const vec2 d1 = v[1]->uv - v[0]->uv, d2 = v[2]->uv - v[0]->uv;
        // Divided by the determinant's sign only: the length then weighs a triangle by its size.
        const float sign = d1.x * d2.y - d1.y * d2.x < 0.0f ? -1.0f : 1.0f;
        const vec3 along = sign * (e1 * d2.y - e2 * d1.y);
        for (Vertex* vertex : v) vertex->tangent += vec4(along, 0.0f);
    }
    for (Vertex& vertex : mesh.vertices) {
        vec3 along(vertex.tangent);
        along -= vertex.normal * glm::dot(vertex.normal, along);
        const float length = glm::length(along);
        const bool usable = length > 1e-20f && std::isfinite(length);
        vertex.tangent = vec4(usable ? along / length : acrossNormal(vertex.normal), vertex.tangent.w);
    }
}

/// Splits triangles where their middles lie farthest apart, at the median, until chunks are small enough.
class Chunker {
public:
    explicit Chunker(std::vector<vec3> middles) : middles_(std::move(middles)) {}

    /// Reorders triangle numbers [begin, end) and calls done(begin, end) per chunk.
    template <typename Done> void split(std::uint32_t* begin, std::uint32_t* end, const Done& done)
    {
        const auto count = static_cast<std::size_t>(end - begin);
        if (count <= trianglesPerChunk) return done(begin, end);
        Bounds bounds;
        for (const auto* at = begin; at != end; ++at) bounds.add(middles_[*at]);
        const vec3 extent = bounds.extent();
        const int axis = extent.x > extent.y ? (extent.x > extent.z ? 0 : 2) : (extent.y > extent.z ? 1 : 2);
        auto* middle = begin + count / 2;
        std::nth_element(begin, middle, end,
                         [&](std::uint32_t a, std::uint32_t b) { return middles_[a][axis] < middles_[b][axis]; });
        split(begin, middle, done);
        split(middle, end, done);
    }

private:
    std::vector<vec3> middles_;
};

std::vector<vec3> triangleMiddles(const Mesh& mesh)
{
    std::vector<vec3> middles(mesh.indices.size() / 3);
    for (std::size_t i = 0; i < middles.size(); ++i) {
        vec3 sum(0.0f);
        for (std::size_t k = 0; k < 3; ++k) sum += mesh.vertices[mesh.indices[3 * i + k]].position;
        middles[i] = sum / 3.0f;
    }
    return middles;
}

/// Orders one chunk's triangles for the vertex cache. meshoptimizer's work grows with the number of vertices
/// that it is told of, so the chunk is numbered on its own.
class CacheOptimiser {
public:
    explicit CacheOptimiser(std::size_t vertexCount) : localOf_(vertexCount, unused) {}

    void optimise(std::uint32_t* indices, std::size_t count)
    {
        global_.clear();
        local_.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            std::uint32_t& local = localOf_[indices[i]];
            if (local == unused) {
                local = static_cast<std::uint32_t>(global_.size());
                global_.push_back(indices[i]);
            }
            local_[i] = local;
        }
        meshopt_optimizeVertexCache(local_.data(), local_.data(), count, global_.size());
        for (std::size_t i = 0; i < count; ++i) indices[i] = global_[local_[i]];
        for (const std::uint32_t vertex : global_) localOf_[vertex] = unused;
    }

private:
    static constexpr std::uint32_t unused = ~0u;
    std::vector<std::uint32_t> localOf_, global_, local_;
};

/// Triangle numbers sorted by material, in file order within one.
std::vector<std::uint32_t> sortedByMaterial(const MeshSource& source)
{
    std::vector<std::uint32_t> order(source.faces.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return source.faces[a].material < source.faces[b].material;
    });
    return order;
}

void addPart(Mesh& mesh, CacheOptimiser& cache, std::vector<std::uint32_t>& ordered, int material,
             const std::uint32_t* begin, const std::uint32_t* end)
{
    MeshPart part;
    part.material = material;
    part.firstIndex = static_cast<std::uint32_t>(ordered.size());
    part.indexCount = static_cast<std::uint32_t>(3 * (end - begin));
    for (const auto* triangle = begin; triangle != end; ++triangle) {
        for (std::size_t k = 0; k < 3; ++k) {
            ordered.push_back(mesh.indices[3 * static_cast<std::size_t>(*triangle) + k]);
            part.bounds.add(mesh.vertices[ordered.back()].position);
        }
    }
    cache.optimise(ordered.data() + part.firstIndex, part.indexCount);
    mesh.bounds.add(part.bounds);
    mesh.parts.push_back(part);
}

void chunkByMaterial(const MeshSource& source, Mesh& mesh)
{
    std::vector<std::uint32_t> order = sortedByMaterial(source);
    Chunker chunker(triangleMiddles(mesh));
    CacheOptimiser cache(mesh.vertices.size());
    std::vector<std::uint32_t> ordered;
    ordered.reserve(mesh.indices.size());
    for (std::size_t begin = 0; begin < order.size();) {
        const int material = source.faces[order[begin]].material;
        std::size_t end = begin;
        while (end < order.size() && source.faces[order[end]].material == material) ++end;
        chunker.split(order.data() + begin, order.data() + end,
                      [&](const std::uint32_t* first, const std::uint32_t* last) {
                          addPart(mesh, cache, ordered, material, first, last);
                      });
        begin = end;
    }
    mesh.indices = std::move(ordered);
}

} // namespace

Mesh buildMesh(const MeshSource& source, std::string name)
{
    Mesh mesh;
    mesh.name = std::move(name);
    if (source.faces.empty()) return mesh;
    weldVertices(source, mesh);
    computeTangents(mesh);
    chunkByMaterial(source, mesh);
    const std::size_t used = meshopt_optimizeVertexFetch(mesh.vertices.data(), mesh.indices.data(), mesh.indices.size(),
                                                         mesh.vertices.data(), mesh.vertices.size(), sizeof(Vertex));
    mesh.vertices.resize(used);
    return mesh;
}

} // namespace tarn
