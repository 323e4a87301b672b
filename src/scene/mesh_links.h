// Which triangles meet at each place of a surface, while vertices are drawn into others (mesh_collapse.h). Private to
// src/scene.
#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tarn {

inline constexpr std::uint32_t none = ~0u;

/// Corners of triangles, numbered 3t to 3t + 2. Those that stand at one place are a chain.
class MeshLinks {
public:
    /// @param isOneSurface what shares a place is one place; else each vertex is one
    MeshLinks(std::span<const Vertex> vertices, std::span<const std::uint32_t> indices, bool isOneSurface);

    std::uint32_t places() const { return static_cast<std::uint32_t>(first_.size()); }
    std::uint32_t triangles() const { return static_cast<std::uint32_t>(corners_.size() / 3); }
    std::uint32_t placeOf(std::uint32_t vertex) const { return place_[vertex]; }
    std::uint32_t vertexAt(std::uint32_t corner) const { return corners_[corner]; }
    std::uint32_t placeAt(std::uint32_t corner) const { return place_[corners_[corner]]; }

    /// The chain of a place: none ends it.
    std::uint32_t first(std::uint32_t place) const { return first_[place]; }
    std::uint32_t next(std::uint32_t corner) const { return next_[corner]; }
    std::uint32_t count(std::uint32_t place) const { return count_[place]; }

    /// The other two corners of its triangle, in their order.
    static std::uint32_t after(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
    static std::uint32_t before(std::uint32_t corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }

    bool isGone(std::uint32_t triangle) const { return corners_[3 * triangle] == none; }
    void drop(std::uint32_t triangle);
    void setVertex(std::uint32_t corner, std::uint32_t vertex) { corners_[corner] = vertex; }
    /// Appends a place's chain to another's; the vertices there are the caller's to set, before or after.
    void append(std::uint32_t place, std::uint32_t into);

private:
    void unlink(std::uint32_t corner);

    std::vector<std::uint32_t> corners_;       ///< vertices; none first: the triangle is gone
    std::vector<std::uint32_t> place_;         ///< of each vertex
    std::vector<std::uint32_t> first_, count_; ///< of each place
    std::vector<std::uint32_t> next_;          ///< of each corner
};

/// For each triangle a number that all that share vertices with it have in common: what a texture is laid on in one
/// piece.
std::vector<std::uint32_t> chartsOf(std::span<const std::uint32_t> indices, std::size_t vertices);

} // namespace tarn
