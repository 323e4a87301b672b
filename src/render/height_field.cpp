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

std::vector<std::vector<float>> largestHeights(const HeightField& field)
{
    const auto larger = [](float& most, float height) { most = std::max(most, height); };
    std::vector<std::vector<float>> levels;
    for (int edge = field.edge; edge > 1; edge /= 2)
        levels.push_back(levels.empty() ? coarserLevel(field.heights, edge, true, field.lowest, larger)
                                        : coarserLevel(levels.back(), edge, false, field.lowest, larger));
    return levels;
}

int powerOfTwo(int texels) { return static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(texels, 1)))); }

} // namespace tarn
