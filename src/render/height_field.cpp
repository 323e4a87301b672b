#include "render/height_field.h"

#include "optics/optics.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace tarn {

namespace {

/// The centre of texel (i, j) is at (i, j); clamped to those that there are.
vec2 placeIn(const HeightField& field, vec2 xz)
{
    const vec2 place = (xz - field.rect.centre + field.rect.halfExtent) * (0.5f * static_cast<float>(field.edge)) /
                           field.rect.halfExtent -
                       vec2(0.5f);
    return glm::clamp(place, vec2(0.0f), vec2(static_cast<float>(field.edge - 1)));
}

float texelAt(const HeightField& field, int i, int j)
{
    return field.heights[static_cast<std::size_t>(j) * static_cast<std::size_t>(field.edge) + static_cast<std::size_t>(i)];
}

} // namespace

bool HeightField::holds(const vec3& point, float tolerance) const
{
    const ivec2 nearest(placeIn(*this, vec2(point.x, point.z)) + 0.5f);
    const ivec2 low = glm::max(nearest - 1, ivec2(0)), high = glm::min(nearest + 1, ivec2(edge - 1));
    float least = texelAt(*this, nearest.x, nearest.y), most = least;
    for (int j = low.y; j <= high.y; ++j)
        for (int i = low.x; i <= high.x; ++i) {
            least = std::min(least, texelAt(*this, i, j));
            most = std::max(most, texelAt(*this, i, j));
        }
    return point.y >= least - tolerance && point.y <= most + tolerance;
}

float HeightField::at(vec2 xz) const
{
    const vec2 inside = placeIn(*this, xz);
    const ivec2 low(glm::floor(inside)), high = glm::min(low + 1, ivec2(edge - 1));
    const vec4 corners(texelAt(*this, low.x, low.y), texelAt(*this, high.x, low.y), texelAt(*this, low.x, high.y),
                       texelAt(*this, high.x, high.y));
    return optics::patchHeight(corners, inside - vec2(low));
}

float HeightField::texel() const
{
    return 2.0f * std::max(rect.halfExtent.x, rect.halfExtent.y) / static_cast<float>(edge);
}

namespace {

/// Level 1: over 3 by 3 centres, those that two cells in each direction share.
std::vector<float> largestOfCells(const HeightField& field)
{
    const int edge = std::max(field.edge / 2, 1);
    std::vector<float> level;
    level.reserve(static_cast<std::size_t>(edge) * static_cast<std::size_t>(edge));
    for (int j = 0; j < edge; ++j)
        for (int i = 0; i < edge; ++i) {
            float most = field.lowest;
            for (int y = 2 * j; y <= std::min(2 * j + 2, field.edge - 1); ++y)
                for (int x = 2 * i; x <= std::min(2 * i + 2, field.edge - 1); ++x)
                    most = std::max(most, field.heights[static_cast<std::size_t>(y) * static_cast<std::size_t>(field.edge) +
                                                        static_cast<std::size_t>(x)]);
            level.push_back(most);
        }
    return level;
}

std::vector<float> largestOfFour(const std::vector<float>& finer, int finerEdge)
{
    const auto edge = static_cast<std::size_t>(finerEdge / 2), row = static_cast<std::size_t>(finerEdge);
    std::vector<float> level;
    level.reserve(edge * edge);
    for (std::size_t j = 0; j < edge; ++j)
        for (std::size_t i = 0; i < edge; ++i) {
            const float* corner = &finer[2 * j * row + 2 * i];
            level.push_back(std::max({corner[0], corner[1], corner[row], corner[row + 1]}));
        }
    return level;
}

} // namespace

std::vector<std::vector<float>> largestHeights(const HeightField& field)
{
    std::vector<std::vector<float>> levels;
    if (field.edge < 2) return levels;
    levels.push_back(largestOfCells(field));
    for (int edge = field.edge / 2; edge > 1; edge /= 2) {
        std::vector<float> coarser = largestOfFour(levels.back(), edge);
        levels.push_back(std::move(coarser));
    }
    return levels;
}

int powerOfTwo(int texels) { return static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(texels, 1)))); }

} // namespace tarn
