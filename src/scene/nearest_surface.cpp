#include "scene/nearest_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace tarn {

namespace {

constexpr std::uint32_t trianglesInLeaf = 4;

float distance2(const vec3& p, const Bounds& box)
{
    const vec3 away = p - glm::clamp(p, box.lower, box.upper);
    return glm::dot(away, away);
}

} // namespace

// Ericson 2004, "Real-Time Collision Detection", section 5.1.5.
vec3 nearestWeights(const vec3& p, const vec3& a, const vec3& b, const vec3& c)
{
    const vec3 ab = b - a, ac = c - a, ap = p - a;
    const float d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
    if (d1 <= 0.0f && d2 <= 0.0f) return {1.0f, 0.0f, 0.0f};
    const vec3 bp = p - b;
    const float d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
    if (d3 >= 0.0f && d4 <= d3) return {0.0f, 1.0f, 0.0f};
    const float vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0f && d1 >= 0.0f && d3 <= 0.0f) {
        const float v = d1 / (d1 - d3);
        return {1.0f - v, v, 0.0f};
    }
    const vec3 cp = p - c;
    const float d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    if (d6 >= 0.0f && d5 <= d6) return {0.0f, 0.0f, 1.0f};
    const float vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0f && d2 >= 0.0f && d6 <= 0.0f) {
        const float w = d2 / (d2 - d6);
        return {1.0f - w, 0.0f, w};
    }
    const float va = d3 * d6 - d5 * d4;
    if (va <= 0.0f && d4 - d3 >= 0.0f && d5 - d6 >= 0.0f) {
        const float w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0.0f, 1.0f - w, w};
    }
    const float sum = va + vb + vc;
    return {va / sum, vb / sum, vc / sum};
}

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

} // namespace tarn
