// The sun's coordinates on the water level, and those of the maps that cover a part of it.
#include "optics/optics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tarn {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

// Moving a point along the light does not move its place on the plane; on the plane itself it is x and z.
TEST(OpticsSunlight, APlaceIsKeptAlongTheLight)
{
    const double level = 1.5;
    for (const double elevation : {0.05, 0.4, 1.0, 1.5}) {
        const dvec3 toSun(std::cos(elevation) * 0.6, std::sin(elevation), std::cos(elevation) * 0.8);
        const dvec2 shear = optics64::sunShear(toSun);
        const dvec3 crossing(3.0, level, -2.0);
        for (const double way : {-20.0, -1.0, 0.0, 0.5, 30.0}) {
            const dvec2 plane = optics64::sunPlane(crossing + way * toSun, level, shear);
            EXPECT_NEAR(plane.x, crossing.x, 1.0e-11);
            EXPECT_NEAR(plane.y, crossing.z, 1.0e-11);
        }
    }
}

// The gradient against two points of a plane.
TEST(OpticsSunlight, TheGradientIsThatOfThePlane)
{
    const dvec3 toSun = glm::normalize(dvec3(0.5, 0.7, -0.3));
    const dvec2 shear = optics64::sunShear(toSun);
    for (const dvec3& n : {dvec3(0.0, 1.0, 0.0), dvec3(0.3, 0.9, 0.1), dvec3(0.0, 0.0, -1.0), dvec3(-0.9, 0.4, 0.2)}) {
        const dvec3 other = std::abs(n.x) < 0.5 ? dvec3(1.0, 0.0, 0.0) : dvec3(0.0, 0.0, 1.0);
        const dvec3 along = glm::normalize(glm::cross(n, other));
        const dvec2 step = optics64::sunPlane(along, 0.0, shear);
        for (const double sign : {1.0, -1.0})
            EXPECT_NEAR(glm::dot(optics64::sunPlaneGradient(sign * n, shear), step), along.y, 1.0e-12);
    }
    // Along the light there is none, and the limit holds.
    const dvec3 sideways = glm::normalize(glm::cross(toSun, dvec3(0.0, 1.0, 0.0)));
    const dvec2 gradient = optics64::sunPlaneGradient(glm::cross(sideways, toSun), shear);
    EXPECT_TRUE(std::isfinite(gradient.x) && std::isfinite(gradient.y));
    EXPECT_LE(glm::length(gradient), 8.0 + 1.0e-9);
}

TEST(OpticsSunlight, AMapsCoordinatesGoFromEdgeToEdge)
{
    const dvec4 rect(3.0, -2.0, 8.0, 5.0);
    const auto expectUv = [&](const dvec2& plane, const dvec2& uv) {
        EXPECT_NEAR(glm::distance(optics64::sunMapUv(rect, plane), uv), 0.0, 1.0e-15);
        EXPECT_NEAR(glm::distance(optics64::sunMapPlane(rect, uv), plane), 0.0, 1.0e-14);
    };
    expectUv({3.0, -2.0}, {0.5, 0.5});
    expectUv({-5.0, -7.0}, {0.0, 0.0});
    expectUv({11.0, 3.0}, {1.0, 1.0});
    expectUv({7.0, 8.0}, {0.75, 1.5});
    const dvec2 a(1.0, 2.0), b(-4.0, 0.5);
    EXPECT_NEAR(glm::distance(optics64::sunMapUvDifference(rect, a - b),
                              optics64::sunMapUv(rect, a) - optics64::sunMapUv(rect, b)),
                0.0, 1.0e-15);
}

} // namespace tarn
