// Heights over a rectangle of the water's level: what a ray is marched through (shaders/passes/height_march.glsl).
#pragma once

#include "render/sun_views.h"

#include <optional>
#include <vector>

namespace tarn {

/// Texel (i, j) stands for its centre, x = lower + (i + 0.5) · texel; rows run along +z.
struct HeightField {
    LevelRect rect;
    int resolution = 0;         ///< texels along one edge, a power of two
    std::vector<float> heights; ///< world y, m; `lowest` where nothing lies
    float lowest = 0.0f;

    /// Between the centres of four texels; at the border, the border's. m
    float at(vec2 xz) const;
    /// Whether a point lies within `tolerance` (m) of the heights about its place: of the nine texels nearest to it.
    bool holds(const vec3& point, float tolerance) const;
    /// Of a texel, the longer edge, m.
    float texel() const;
    /// How far along a ray it first meets the surface between the heights, m, or nothing where it leaves the map or
    /// comes within a millimetre of `lowest` before. Cell by cell and in double precision: what marches are held
    /// against.
    /// @param direction unit, going down
    std::optional<double> firstMeeting(const glm::dvec3& from, const glm::dvec3& direction) const;
};

/// Level n - 1 of the result holds, for each block of 2^n by 2^n cells between centres, the largest of the heights at
/// the corners of its cells, which no patch within it exceeds (maximum mipmaps, Tevs et al. 2008). The last is a single
/// block.
std::vector<std::vector<float>> largestHeights(const HeightField& field);

/// A coarser level of a pyramid over a square map: each block joined of the texels that it covers, two by two of the
/// finer level, or three by three of the map's own centres, which neighbouring blocks share.
/// @param join called with the block, which begins as `empty`, and each of its texels
template <typename Texel, typename Join>
std::vector<Texel> coarserLevel(const std::vector<Texel>& finer, int finerResolution, bool ofCentres,
                                const Texel& empty, const Join& join)
{
    const int resolution = finerResolution > 1 ? finerResolution / 2 : 1, reach = ofCentres ? 2 : 1;
    std::vector<Texel> level;
    for (int j = 0; j < resolution; ++j)
        for (int i = 0; i < resolution; ++i) {
            Texel block = empty;
            for (int y = 2 * j; y <= 2 * j + reach && y < finerResolution; ++y)
                for (int x = 2 * i; x <= 2 * i + reach && x < finerResolution; ++x)
                    join(block, finer[static_cast<std::size_t>(y) * static_cast<std::size_t>(finerResolution) +
                                      static_cast<std::size_t>(x)]);
            level.push_back(block);
        }
    return level;
}

/// The least power of two that is not under `texels`.
int powerOfTwo(int texels);

} // namespace tarn
