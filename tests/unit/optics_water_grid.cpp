// The lines of the water's grid: ordered, pinned to the rectangle, found again, and gliding with the eye.
#include "optics/water_grid.h"
#include "optics/waves.h"
#include "scene/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tarn {
namespace {

using glm::dvec2;
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

const std::vector<optics64::WaveTerm> waves{optics64::makeWaveTerm(0.05, 4.0, 0.3, 0.1),
                                            optics64::makeWaveTerm(0.03, 2.3, 1.7, 1.0),
                                            optics64::makeWaveTerm(0.01, 0.6, -2.5, 2.0)};

optics64::WaveSum vertex(const dvec2& position, const dvec2& cell)
{
    return optics64::gridSum(waves.data(), static_cast<int>(waves.size()), position, cell, 0.7);
}

double drawnHeight(const optics64::WaterGrid& grid, const dvec2& x)
{
    return optics64::gridHeight(waves.data(), static_cast<int>(waves.size()), x, 0.7, grid[0], grid[1]);
}

// Fine cells show all of the waves; from one and a half to a wavelength on there is nothing left of any.
TEST(WaterGrid, AVertexShowsWhatItsCellsCanCarry)
{
    for (int i = 0; i < 50; ++i) {
        const dvec2 x(0.7 * i - 10.0, 3.0 - 0.4 * i);
        const optics64::WaveSum all = optics64::waveAt(waves, x, 0.7), fine = vertex(x, dvec2(0.01));
        EXPECT_EQ(fine.height, all.height);
        EXPECT_EQ(fine.slope, all.slope);
        EXPECT_EQ(vertex(x, dvec2(100.0)).height, 0.0);
        EXPECT_NEAR(vertex(x, dvec2(0.5)).height, optics64::waveHeight({waves.data(), 2}, x, 0.7), 1e-15);
    }
}

// The triangles go through the vertices, and are flat in between.
TEST(WaterGrid, TheDrawnHeightIsLinearBetweenTheVertices)
{
    const optics64::WaterGrid grid = gridOf(places[0].eye, places[0].target, {-1, -2, 73, 56}, 97);
    const auto at = [&](double line, double row) {
        return dvec2(optics64::gridPosition(grid[0], line), optics64::gridPosition(grid[1], row));
    };
    const auto height = [&](double line, double row) {
        return vertex(at(line, row), {optics64::gridCell(grid[0], line), optics64::gridCell(grid[1], row)}).height;
    };
    double highest = 0.0;
    for (double line = 1.0; line < 95.0; line += 3.0) {
        for (double row = 1.0; row < 95.0; row += 3.0) {
            const dvec2 lower = at(line, row), size = at(line + 1.0, row + 1.0) - lower;
            const double first = height(line, row), last = height(line + 1.0, row + 1.0);
            const double x = height(line + 1.0, row), z = height(line, row + 1.0);
            highest = std::max(highest, std::abs(first));
            EXPECT_NEAR(drawnHeight(grid, lower + 1e-9 * size), first, 1e-8);
            EXPECT_NEAR(drawnHeight(grid, lower + 0.25 * size), 0.5 * first + 0.25 * (x + z), 1e-12);
            EXPECT_NEAR(drawnHeight(grid, lower + 0.75 * size), 0.5 * last + 0.25 * (x + z), 1e-12);
        }
    }
    EXPECT_GT(highest, 0.05);
}

} // namespace
} // namespace tarn
