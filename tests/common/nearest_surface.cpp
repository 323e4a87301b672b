#include "nearest_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace tarn::test {

namespace {

constexpr std::uint32_t trianglesInLeaf = 4;

float distance2(const vec3& p, const Bounds& box)
{
    const vec3 away = p - glm::clamp(p, box.lower, box.upper);
    return glm::dot(away, away);
}

} // namespace

NearestSurface::NearestSurface(std::span<const vec3> positions, std::span<const std::uint32_t> indices)
    : positions_(positions), indices_(indices), order_(indices.size() / 3)
{
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.reserve(order_.size());
    build(0, static_cast<std::uint32_t>(order_.size()));
}

std::uint32_t NearestSurface::build(std::uint32_t begin, std::uint32_t end)
{
    const auto self = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    Bounds bounds;
    for (std::uint32_t i = begin; i < end; ++i)
        for (std::size_t k = 0; k < 3; ++k) bounds.add(corner(order_[i], k));
    nodes_[self].bounds = bounds;
    nodes_[self].begin = begin;
    nodes_[self].end = end;
    if (end - begin <= trianglesInLeaf) return self;
    const vec3 extent = bounds.extent();
    const int axis = extent.x > extent.y ? (extent.x > extent.z ? 0 : 2) : (extent.y > extent.z ? 1 : 2);
    const auto middleOf = [&](std::uint32_t triangle) {
        return corner(triangle, 0)[axis] + corner(triangle, 1)[axis] + corner(triangle, 2)[axis];
    };
    const std::uint32_t half = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + half, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) { return middleOf(a) < middleOf(b); });
    build(begin, half);
    const std::uint32_t second = build(half, end);
    nodes_[self].second = second;
    return self;
}

NearestSurface::Point NearestSurface::nearest(const vec3& to) const
{
    Point best;
    float least = std::numeric_limits<float>::max();
    std::array<std::uint32_t, 64> stack{}; // halving 2^32 triangles goes no deeper
    std::size_t depth = 1;
    while (depth > 0) {
        const std::uint32_t index = stack[--depth];
        const Node& node = nodes_[index];
        if (distance2(to, node.bounds) >= least) continue;
        if (node.second != 0) {
            const bool firstIsNearer =
                distance2(to, nodes_[index + 1].bounds) <= distance2(to, nodes_[node.second].bounds);
            stack[depth++] = firstIsNearer ? node.second : index + 1;
            stack[depth++] = firstIsNearer ? index + 1 : node.second;
            continue;
        }
        for (std::uint32_t i = node.begin; i < node.end; ++i) {
            const std::size_t t = order_[i];
            const vec3 a = corner(t, 0), b = corner(t, 1), c = corner(t, 2);
            const vec3 w = nearestWeights(to, a, b, c);
            const vec3 away = to - (w.x * a + w.y * b + w.z * c);
            const float d2 = glm::dot(away, away);
            if (d2 >= least) continue;
            least = d2;
            best = {t, w, 0.0f};
        }
    }
    best.distance = std::sqrt(least);
    return best;
}

} // namespace tarn::test
