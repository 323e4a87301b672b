#include "scene/mesh_links.h"

#include <numeric>
#include <unordered_map>
#include <utility>

namespace tarn {

namespace {

/// Equal for places that are bit for bit the same (and for the two zeros).
struct PlaceHash {
    std::size_t operator()(const vec3& p) const
    {
        std::size_t key = 0;
        for (int axis = 0; axis < 3; ++axis) key = key * 0x9e3779b97f4a7c15ull + std::hash<float>{}(p[axis]);
        return key;
    }
};

} // namespace

MeshLinks::MeshLinks(std::span<const Vertex> vertices, std::span<const std::uint32_t> indices, bool isOneSurface)
    : corners_(indices.begin(), indices.end()), next_(indices.size())
{
    std::unordered_map<vec3, std::uint32_t, PlaceHash> known;
    if (isOneSurface) known.reserve(vertices.size());
    place_.reserve(vertices.size());
    for (std::uint32_t i = 0; i < vertices.size(); ++i)
        place_.push_back(
            isOneSurface
                ? known.try_emplace(vertices[i].position, static_cast<std::uint32_t>(known.size())).first->second
                : i);
    const std::size_t places = isOneSurface ? known.size() : vertices.size();
    first_.assign(places, none);
    count_.assign(places, 0);
    for (auto corner = static_cast<std::uint32_t>(corners_.size()); corner-- > 0;) {
        const std::uint32_t place = placeAt(corner);
        next_[corner] = std::exchange(first_[place], corner);
        ++count_[place];
    }
}

void MeshLinks::unlink(std::uint32_t corner)
{
    const std::uint32_t place = placeAt(corner);
    std::uint32_t* link = &first_[place];
    while (*link != corner) link = &next_[*link];
    *link = next_[corner];
    --count_[place];
}

void MeshLinks::drop(std::uint32_t triangle)
{
    for (std::uint32_t k = 0; k < 3; ++k) unlink(3 * triangle + k);
    corners_[3 * triangle] = none;
}

void MeshLinks::append(std::uint32_t place, std::uint32_t into)
{
    std::uint32_t* link = &first_[into];
    while (*link != none) link = &next_[*link];
    *link = std::exchange(first_[place], none);
    count_[into] += std::exchange(count_[place], 0u);
}

std::vector<std::uint32_t> chartsOf(std::span<const std::uint32_t> indices, std::size_t vertices)
{
    std::vector<std::uint32_t> parent(vertices);
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](std::uint32_t v) {
        while (parent[v] != v) v = parent[v] = parent[parent[v]];
        return v;
    };
    for (std::size_t i = 0; i < indices.size(); i += 3)
        for (const std::size_t k : {1u, 2u}) parent[root(indices[i + k])] = root(indices[i]);
    std::vector<std::uint32_t> charts;
    charts.reserve(indices.size() / 3);
    for (std::size_t i = 0; i < indices.size(); i += 3) charts.push_back(root(indices[i]));
    return charts;
}

} // namespace tarn
