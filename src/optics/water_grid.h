// Where the vertices of the drawn water stand, for a view: the parameters of shaders/shared/water_grid.glsl.
//
//     const optics64::WaterGrid grid = optics64::focusedGrid(rect, level, amplitude, 97, eye, clipFromWorld);
//     const double x = optics64::gridPosition(grid[0], 12);
//
// rect: centre x, z and half extent x, z of the water. Metres.
#pragma once

#include "optics/optics.h"

#include <array>

namespace tarn::optics64 {

/// Lines of vertices along x and along z.
using WaterGrid = std::array<GridAxis, 2>;

/// vertices x vertices, evenly over the rectangle.
WaterGrid uniformGrid(const dvec4& rect, int vertices);

/// As many, over what a view sees of the rectangle and the closer the nearer to the eye. Fewer than 6 stay even.
/// Changes continuously with eye and view, so that vertices glide.
/// @param amplitude    the surface stays within level ± this
WaterGrid focusedGrid(const dvec4& rect, double level, double amplitude, int vertices, const dvec3& eye,
                      const dmat4& clipFromWorld);

/// How much steeper than the waves the surface may be because gridFade changes from vertex to vertex: a factor.
double fadeSteepening(const WaterGrid& grid);

} // namespace tarn::optics64

namespace tarn {

/// For the GPU.
blocks::GridAxis narrowed(const optics64::GridAxis& axis);

} // namespace tarn
