#include "rtin.h"

#include <utility>

namespace tarn::lake {

Rtin::Rtin(int cells, std::function<float(int, int)> height)
    : cells_(cells), height_(std::move(height)),
      wanted_(static_cast<std::size_t>(cells + 1) * static_cast<std::size_t>(cells + 1), 0)
{}

void Rtin::mark(const Split& split)
{
    // All triangles of the hierarchy, smallest first (their ids run like a heap's). A point that is wanted
    // makes the points of the two larger triangles above it wanted, so that no neighbour is left with a gap.
    const long long smallest = 2LL * cells_ * cells_ - 2, parents = smallest - 1LL * cells_ * cells_;
    for (long long i = smallest - 1; i >= 0; --i) {
        long long id = i + 2;
        ivec2 a(0), b(0), c(0);
        if (id & 1)
            b = ivec2(cells_), c.x = cells_;
        else
            a = ivec2(cells_), c.y = cells_;
        while ((id >>= 1) > 1) {
            const ivec2 middle = (a + b) / 2;
            if (id & 1) {
                b = a;
                a = c;
            } else {
                a = b;
                b = c;
            }
            c = middle;
        }
        const ivec2 middle = (a + b) / 2;
        const float error = std::abs(0.5f * (height_(a.x, a.y) + height_(b.x, b.y)) - height_(middle.x, middle.y));
        const ivec2 side = c - a;
        const float leg = std::sqrt(static_cast<float>(side.x * side.x + side.y * side.y));
        char& wanted = wanted_[index(middle)];
        if (split(middle.x, middle.y, leg, error)) wanted = 1;
        if (i >= parents) continue;
        if (wanted_[index((a + c) / 2)] || wanted_[index((b + c) / 2)]) wanted = 1;
    }
}

void Rtin::emit(ivec2 a, ivec2 b, ivec2 c, std::vector<std::array<ivec2, 3>>& triangles) const
{
    const ivec2 middle = (a + b) / 2;
    if (std::abs(a.x - c.x) + std::abs(a.y - c.y) > 1 && wanted_[index(middle)]) {
        emit(c, a, middle, triangles);
        emit(b, c, middle, triangles);
    } else {
        triangles.push_back({a, b, c});
    }
}

std::vector<std::array<ivec2, 3>> Rtin::triangulate(const Split& split)
{
    mark(split);
    std::vector<std::array<ivec2, 3>> triangles;
    emit(ivec2(0), ivec2(cells_), ivec2(cells_, 0), triangles);
    emit(ivec2(cells_), ivec2(0), ivec2(0, cells_), triangles);
    for (auto& triangle : triangles) {
        // Seen from above (y), x right and z down the page: turn those that run the wrong way.
        const ivec2 u = triangle[1] - triangle[0], v = triangle[2] - triangle[0];
        if (u.x * v.y - u.y * v.x > 0) std::swap(triangle[1], triangle[2]);
    }
    return triangles;
}

} // namespace tarn::lake
