// Right-triangulated irregular network (Evans, Kirkpatrick & Townsend 2001): a height field as triangles that
// are fine only where that is wanted, without cracks.
#pragma once

#include "base/math.h"

#include <array>
#include <functional>
#include <vector>

namespace tarn::lake {

class Rtin {
public:
    /// `cells` a side is a power of two; heights are asked for at 0..cells.
    Rtin(int cells, std::function<float(int x, int z)> height);

    /// Whether a triangle must be cut at (x, z), the middle of its long side; leg: its short sides, in cells;
    /// error: how far the ground there is from the triangle.
    using Split = std::function<bool(int x, int z, float leg, float error)>;

    /// Counter-clockwise from above with x to the right and z towards the viewer.
    std::vector<std::array<ivec2, 3>> triangulate(const Split& split);

private:
    void mark(const Split& split);
    void emit(ivec2 a, ivec2 b, ivec2 c, std::vector<std::array<ivec2, 3>>& triangles) const;
    std::size_t index(ivec2 p) const
    {
        return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(cells_ + 1) + static_cast<std::size_t>(p.x);
    }

    int cells_;
    std::function<float(int, int)> height_;
    std::vector<char> wanted_; ///< per grid point: a triangle is cut here
};

} // namespace tarn::lake
