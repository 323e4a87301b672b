#include "optics/water_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tarn::optics64 {

namespace {

/// A convex body of six planes (xyz: inward normal, w: distance) and eight corners, whose bits are their x, y and z.
struct Hexahedron {
    std::array<dvec4, 6> planes;
    std::array<dvec3, 8> corners;
};

Hexahedron frustumOf(const dmat4& clipFromWorld)
{
    Hexahedron body;
    const dmat4 rows = glm::transpose(clipFromWorld);
    for (int axis = 0; axis < 3; ++axis) {
        body.planes[static_cast<std::size_t>(2 * axis)] = rows[3] + rows[axis];
        body.planes[static_cast<std::size_t>(2 * axis + 1)] = rows[3] - rows[axis];
    }
    const dmat4 worldFromClip = glm::inverse(clipFromWorld);
    for (std::size_t i = 0; i < 8; ++i) {
        const dvec4 p = worldFromClip * dvec4(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0, 1.0);
        body.corners[i] = dvec3(p) / p.w;
    }
    return body;
}

Hexahedron boxOf(const dvec3& lower, const dvec3& upper)
{
    Hexahedron body;
    for (int axis = 0; axis < 3; ++axis) {
        dvec4 plane(0.0);
        plane[axis] = 1.0;
        plane.w = -lower[axis];
        body.planes[static_cast<std::size_t>(2 * axis)] = plane;
        body.planes[static_cast<std::size_t>(2 * axis + 1)] = {-dvec3(plane), upper[axis]};
    }
    for (std::size_t i = 0; i < 8; ++i)
        body.corners[i] = {i & 1 ? upper.x : lower.x, i & 2 ? upper.y : lower.y, i & 4 ? upper.z : lower.z};
    return body;
}

/// Adds what lies within `walls` of the edges of `body` to a range of x and z.
void addEdges(const Hexahedron& body, const Hexahedron& walls, dvec2& lower, dvec2& upper)
{
    for (std::size_t i = 0; i < 8; ++i) {
        for (std::size_t bit = 1; bit < 8; bit *= 2) {
            if (i & bit) continue;
            const dvec3 a = body.corners[i], way = body.corners[i | bit] - a;
            double from = 0.0, to = 1.0;
            for (const dvec4& plane : walls.planes) {
                const double distance = dot(dvec3(plane), a) + plane.w, rate = dot(dvec3(plane), way);
                if (rate > 0.0)
                    from = std::max(from, -distance / rate);
                else if (rate < 0.0)
                    to = std::min(to, -distance / rate);
                else if (distance < 0.0)
                    to = -1.0;
            }
            if (from > to) continue;
            for (const double t : {from, to}) {
                const dvec2 p(a.x + t * way.x, a.z + t * way.z);
                lower = glm::min(lower, p);
                upper = glm::max(upper, p);
            }
        }
    }
}

GridAxis uniformAxis(double lower, double upper, int vertices)
{
    return {lower, upper, 0.5 * (lower + upper), 0.0, 0.0, 0.0, static_cast<double>(vertices), 0.0};
}

} // namespace

WaterGrid uniformGrid(const dvec4& rect, int vertices)
{
    return {uniformAxis(rect.x - rect.z, rect.x + rect.z, vertices),
            uniformAxis(rect.y - rect.w, rect.y + rect.w, vertices)};
}

WaterGrid focusedGrid(const dvec4& rect, double level, double amplitude, int vertices, const dvec3& eye,
                      const dmat4& clipFromWorld)
{
    WaterGrid grid = uniformGrid(rect, vertices);
    if (vertices < 6) return grid;
    const dvec2 ends[2] = {{rect.x - rect.z, rect.y - rect.w}, {rect.x + rect.z, rect.y + rect.w}};
    const double room = amplitude + 1e-3; // never flat
    const Hexahedron water = boxOf({ends[0].x, level - room, ends[0].y}, {ends[1].x, level + room, ends[1].y});
    const Hexahedron frustum = frustumOf(clipFromWorld);
    // The corners of what two convex bodies share lie on edges of one within the other.
    dvec2 lower(std::numeric_limits<double>::max()), upper(std::numeric_limits<double>::lowest());
    addEdges(water, frustum, lower, upper);
    addEdges(frustum, water, lower, upper);
    if (!(lower.x <= upper.x)) return grid; // not in the view
    const dvec2 margin = 0.01 * (upper - lower) + dvec2(0.01);
    lower = glm::clamp(lower - margin, ends[0], ends[1]);
    upper = glm::clamp(upper + margin, ends[0], ends[1]);

    const dvec2 under(eye.x, eye.z);
    const dvec2 centre = glm::clamp(under, lower, upper);
    // Even to twice the eye's distance, where perspective begins to shrink cells.
    const double scale = 2.0 * std::max(glm::length(dvec3(under - centre, eye.y - level)), 0.1);
    for (int axis = 0; axis < 2; ++axis) {
        GridAxis& a = grid[static_cast<std::size_t>(axis)];
        a.centre = centre[axis];
        a.scale = scale;
        a.from = std::asinh((lower[axis] - a.centre) / scale);
        a.to = std::asinh((upper[axis] - a.centre) / scale);
    }
    return grid;
}

double fadeSteepening(const WaterGrid& grid)
{
    // Along an axis cells grow by no more than this per metre, and gridFade, a cubic over 2.62 rad, falls by no more
    // than 1.5 / 2.62 per radian.
    double growth = 0.0;
    for (const GridAxis& axis : grid)
        if (axis.scale > 0.0) growth = std::max(growth, (axis.to - axis.from) / (axis.vertices - 3.0));
    return 1.0 + 0.573 * growth;
}

} // namespace tarn::optics64

namespace tarn {

blocks::GridAxis narrowed(const optics64::GridAxis& axis)
{
    return {static_cast<float>(axis.lower),    static_cast<float>(axis.upper),
            static_cast<float>(axis.centre),   static_cast<float>(axis.scale),
            static_cast<float>(axis.from),     static_cast<float>(axis.to),
            static_cast<float>(axis.vertices), 0.0f};
}

} // namespace tarn
