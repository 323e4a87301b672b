#include "render/height_field.h"

#include "optics/optics.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace tarn {

namespace {

/// The centre of texel (i, j) is at (i, j); clamped to those that there are.
vec2 placeIn(const HeightField& field, vec2 xz)
{
    const vec2 position = (xz - field.rect.centre + field.rect.halfExtent) *
                              (0.5f * static_cast<float>(field.resolution)) / field.rect.halfExtent -
                          vec2(0.5f);
    return glm::clamp(position, vec2(0.0f), vec2(static_cast<float>(field.resolution - 1)));
}

float texelAt(const HeightField& field, int i, int j)
{
    return field.heights[static_cast<std::size_t>(j) * static_cast<std::size_t>(field.resolution) +
                         static_cast<std::size_t>(i)];
}

} // namespace

bool HeightField::holds(const vec3& point, float tolerance) const
{
    const ivec2 nearest(placeIn(*this, vec2(point.x, point.z)) + 0.5f);
    const ivec2 low = glm::max(nearest - 1, ivec2(0)), high = glm::min(nearest + 1, ivec2(resolution - 1));
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
    const ivec2 low(glm::floor(inside)), high = glm::min(low + 1, ivec2(resolution - 1));
    const vec4 corners(texelAt(*this, low.x, low.y), texelAt(*this, high.x, low.y), texelAt(*this, low.x, high.y),
                       texelAt(*this, high.x, high.y));
    return optics::patchHeight(corners, inside - vec2(low));
}

float HeightField::texel() const
{
    return 2.0f * std::max(rect.halfExtent.x, rect.halfExtent.y) / static_cast<float>(resolution);
}

namespace {

/// Metres to where a ray leaves the cell that it is in, by the side that it nears.
double untilNextCell(double position, double cell, double way)
{
    if (way == 0.0) return std::numeric_limits<double>::infinity();
    return ((way > 0.0 ? cell + 1.0 : cell) - position) / way;
}

glm::dvec4 cornersOf(const HeightField& field, const glm::dvec2& cell)
{
    const ivec2 last(field.resolution - 1);
    const ivec2 low = glm::clamp(ivec2(cell), ivec2(0), last), high = glm::clamp(ivec2(cell) + 1, ivec2(0), last);
    return {texelAt(field, low.x, low.y), texelAt(field, high.x, low.y), texelAt(field, low.x, high.y),
            texelAt(field, high.x, high.y)};
}

} // namespace

std::optional<double> HeightField::firstMeeting(const glm::dvec3& from, const glm::dvec3& direction) const
{
    using glm::dvec2, glm::dvec3;
    const dvec2 texels = 0.5 * static_cast<double>(resolution) / dvec2(rect.halfExtent); // per metre
    const dvec2 start = (dvec2(from.x, from.z) - dvec2(rect.centre) + dvec2(rect.halfExtent)) * texels - 0.5;
    const dvec3 along(dvec2(direction.x, direction.z) * texels, direction.y);
    constexpr double nothing = 1.0e-3; // m over `lowest`, within which nothing lies
    const double end = (from.y - static_cast<double>(lowest) - nothing) / std::max(-direction.y, 1.0e-9);
    dvec2 cell = glm::floor(start);
    for (double t = 0.0; t < end;) {
        const dvec2 position = start + t * dvec2(along);
        if (glm::any(glm::lessThan(position, dvec2(-0.5))) ||
            glm::any(glm::greaterThan(position, dvec2(static_cast<double>(resolution) - 0.5))))
            return std::nullopt;
        // Which side is next is worked out from the start for every cell, so that rounding does not add up.
        const double nextX = untilNextCell(start.x, cell.x, along.x), nextZ = untilNextCell(start.y, cell.y, along.y);
        const double next = std::min(nextX, nextZ);
        const double within = std::max(std::min(next, end) - t, 0.0);
        const dvec3 inCell(position - cell, from.y + t * direction.y);
        const double met = optics64::patchCrossing(cornersOf(*this, cell), inCell, along, within);
        if (met >= 0.0) return t + met;
        if (nextX <= nextZ) cell.x += along.x > 0.0 ? 1.0 : -1.0;
        if (nextZ <= nextX) cell.y += along.y > 0.0 ? 1.0 : -1.0;
        t = std::max(t, next);
    }
    return std::nullopt;
}

std::vector<std::vector<float>> largestHeights(const HeightField& field)
{
    const auto larger = [](float& most, float height) { most = std::max(most, height); };
    std::vector<std::vector<float>> levels;
    for (int resolution = field.resolution; resolution > 1; resolution /= 2)
        levels.push_back(levels.empty() ? coarserLevel(field.heights, resolution, true, field.lowest, larger)
                                        : coarserLevel(levels.back(), resolution, false, field.lowest, larger));
    return levels;
}

int powerOfTwo(int texels) { return static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(texels, 1)))); }

} // namespace tarn
