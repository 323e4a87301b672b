// The nearest point on a set of triangles, to check how far a simplified surface lies from the one it stands for.
#pragma once

#include "scene/nearest_point.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tarn::test {

/// Boxes about triangles, and boxes about those. Keeps references to its triangles.
class NearestSurface {
public:
    /// @param positions of vertices, any space   @param indices three for each triangle; at least one triangle
    NearestSurface(std::span<const vec3> positions, std::span<const std::uint32_t> indices);

    struct Point {
        std::size_t triangle = 0; ///< counted from 0
        vec3 weights{0.0f};       ///< of its corners; they add up to 1
        float distance = 0.0f;
    };
    Point nearest(const vec3& to) const;

private:
    struct Node {
        Bounds bounds;
        std::uint32_t begin = 0, end = 0; ///< of order_, in a leaf
        std::uint32_t second = 0;         ///< the first child follows its parent; 0: a leaf
    };
    std::uint32_t build(std::uint32_t begin, std::uint32_t end);
    vec3 corner(std::size_t triangle, std::size_t k) const { return positions_[indices_[3 * triangle + k]]; }

    std::span<const vec3> positions_;
    std::span<const std::uint32_t> indices_;
    std::vector<std::uint32_t> order_; ///< triangles
    std::vector<Node> nodes_;
};

} // namespace tarn::test
