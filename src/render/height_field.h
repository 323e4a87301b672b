// Heights over a rectangle of the water's level: what a ray is marched through (shaders/passes/height_march.glsl).
#pragma once

#include "render/sun_views.h"

#include <vector>

namespace tarn {

/// Texel (i, j) stands for its centre, x = lower + (i + 0.5) · texel; rows run along +z.
struct HeightField {
    LevelRect rect;
    int edge = 0;               ///< texels along one edge, a power of two
    std::vector<float> heights; ///< world y, m; `lowest` where nothing lies
    float lowest = 0.0f;

    /// Between the centres of four texels; at the border, the border's. m
    float at(vec2 xz) const;
    /// Whether a point lies within `tolerance` (m) of the heights about its place: of the nine texels nearest to it.
    bool holds(const vec3& point, float tolerance) const;
    /// Of a texel, the longer edge, m.
    float texel() const;
};

/// Level n - 1 of the result holds, for each block of 2^n by 2^n cells between centres, the largest of the heights at the
/// corners of its cells, which no patch within it exceeds (maximum mipmaps, Tevs et al. 2008). The last is a single block.
std::vector<std::vector<float>> largestHeights(const HeightField& field);

/// The least power of two that is not under `texels`.
int powerOfTwo(int texels);

} // namespace tarn
