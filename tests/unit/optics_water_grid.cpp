// The lines of the water's grid: ordered, pinned to the rectangle, found again, and gliding with the eye.
#include "optics/water_grid.h"
#include "scene/camera.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tarn {
namespace {

using glm::dvec3;
using glm::dvec4;

optics64::WaterGrid gridOf(const vec3& eye, const vec3& target, const dvec4& rect, int vertices)
{
    Camera camera;
    camera.eye = eye;
    camera.target = target;
    const glm::dmat4 clipFromWorld = glm::dmat4(clipFromView(camera, 4.0f / 3.0f)) * glm::dmat4(viewFromWorld(camera));
    return optics64::focusedGrid(rect, 0.0, 0.1, vertices, dvec3(eye), clipFromWorld);
}

struct Place {
    vec3 eye, target;
};

const Place places[] = {
    {vec3(0.0f, 1.5f, 10.0f), vec3(0.0f, 0.0f, -20.0f)},     // on the shore
    {vec3(3.0f, 0.02f, 2.0f), vec3(4.0f, 0.0f, -20.0f)},     // at the surface
    {vec3(-5.0f, -2.0f, 0.0f), vec3(0.0f, 0.0f, 0.0f)},      // under it
    {vec3(10.0f, 1000.0f, 10.0f), vec3(11.0f, 0.0f, 10.0f)}, // high above
    {vec3(900.0f, 20.0f, 900.0f), vec3(0.0f, 0.0f, 0.0f)},   // far outside
    {vec3(0.0f, 5.0f, 0.0f), vec3(0.0f, 50.0f, -1.0f)},      // looking away from the water
};

TEST(WaterGrid, LinesAreOrderedAndPinnedToTheRectangle)
{
    for (const dvec4& rect : {dvec4(-1, -2, 73, 56), dvec4(0, 0, 0.05, 0.05), dvec4(5e3, 0, 2e4, 1e4)}) {
        for (const Place& place : places) {
            const optics64::WaterGrid grid = gridOf(place.eye, place.target, rect, 97);
            for (int axis = 0; axis < 2; ++axis) {
                const double lower = rect[axis] - rect[axis + 2], upper = rect[axis] + rect[axis + 2];
                const double size = upper - lower;
                double last = lower;
                for (int line = 0; line < 97; ++line) {
                    const double x = optics64::gridPosition(grid[static_cast<std::size_t>(axis)], line);
                    ASSERT_TRUE(std::isfinite(x));
                    EXPECT_GE(x, last - 1e-9 * size);
                    last = x;
                }
                EXPECT_NEAR(optics64::gridPosition(grid[static_cast<std::size_t>(axis)], 0), lower, 1e-6 * size);
                EXPECT_NEAR(last, upper, 1e-6 * size);
            }
        }
    }
}

TEST(WaterGrid, ALineIsFoundAgainAtItsPlace)
{
    const optics64::WaterGrid grid = gridOf(places[0].eye, places[0].target, {-1, -2, 73, 56}, 97);
    for (const optics64::GridAxis& axis : grid)
        for (double line = 0.25; line < 96.0; line += 0.75) {
            const double whole = std::floor(line);
            const double x = optics64::gridPosition(axis, whole);
            EXPECT_NEAR(optics64::gridPosition(axis, std::round(optics64::gridLine(axis, x))), x, 1e-6);
        }
}

TEST(WaterGrid, CellsAreFinestBeforeTheEye)
{
    const optics64::WaterGrid grid = gridOf(places[0].eye, places[0].target, {-1, -2, 73, 56}, 97);
    const auto cellAt = [&](double z) {
        const double line = std::floor(optics64::gridLine(grid[1], z));
        return optics64::gridPosition(grid[1], line + 1.0) - optics64::gridPosition(grid[1], line);
    };
    const double even = 112.0 / 96.0;
    EXPECT_LT(cellAt(6.0), 0.5 * even);
    EXPECT_GT(cellAt(-50.0), cellAt(6.0));
}

// No vertex may jump while the eye moves by millimetres.
TEST(WaterGrid, LinesGlideWithTheEye)
{
    const dvec4 rect(-1, -2, 73, 56);
    optics64::WaterGrid last = gridOf({0.0f, 1.5f, 10.0f}, {0.0f, 0.0f, -20.0f}, rect, 97);
    for (int step = 1; step <= 400; ++step) {
        const float way = 0.005f * static_cast<float>(step);
        const optics64::WaterGrid grid = gridOf({way, 1.5f - 0.5f * way, 10.0f - way}, {0.0f, 0.0f, -20.0f}, rect, 97);
        for (std::size_t axis = 0; axis < 2; ++axis)
            for (int line = 0; line < 97; ++line)
                ASSERT_NEAR(optics64::gridPosition(grid[axis], line), optics64::gridPosition(last[axis], line), 0.5)
                    << "step " << step << " axis " << axis << " line " << line;
        last = grid;
    }
}

} // namespace
} // namespace tarn
