// The caustics' formulas against closed forms, and in float against double.
#include "optics/optics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace tarn {
namespace {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

constexpr double ior = 1.33;

dvec3 towardsSun(double elevation)
{
    return {std::cos(elevation) * 0.6, std::sin(elevation), std::cos(elevation) * 0.8};
}

// On a surface of constant slope one step of Newton's method is the whole way.
TEST(OpticsCaustics, APhotonEntersAPlaneWhereItMeetsIt)
{
    const dvec2 slope(0.12, -0.3);
    for (const double elevation : {0.4, 0.9, 1.5}) {
        const dvec2 shear = optics64::sunShear(towardsSun(elevation));
        for (const double atLevel : {-0.3, 0.0, 0.2}) {
            const double height = optics64::photonEntryHeight(atLevel, slope, shear);
            EXPECT_NEAR(height, atLevel + glm::dot(slope, shear * height), 1.0e-15);
        }
    }
    // Along the surface the step would have no bound.
    EXPECT_NEAR(optics64::photonEntryHeight(0.1, dvec2(1.0, 0.0), dvec2(1.0, 0.0)), 0.5, 1.0e-15);
}

TEST(OpticsCaustics, PhotonsBringATexelWhatTheSurfaceLetsThrough)
{
    EXPECT_DOUBLE_EQ(optics64::photonFraction(0.5, 1.0), 0.25);
    const double texel = 0.1;
    for (const double cosine : {1.0, 0.7, 0.2}) {
        for (const double cell : {0.025, 0.05, 0.1, 0.2}) {
            const double photonsPerTexel = (texel / cell) * (texel / cell);
            EXPECT_NEAR(photonsPerTexel * optics64::photonFlux(cosine, ior, cell, texel),
                        1.0 - optics64::fresnelExact(cosine, 1.0 / ior), 1.0e-14);
        }
    }
    // Straight down: 1 - ((n - 1) / (n + 1))².
    const double r = (ior - 1.0) / (ior + 1.0);
    EXPECT_NEAR(optics64::photonFlux(1.0, ior, 1.0, 1.0), 1.0 - r * r, 1.0e-15);
}

TEST(OpticsCaustics, ALightRayKeepsItsPointOfTheLevel)
{
    const double level = 1.5;
    for (const double elevation : {0.8, 1.2, 1.5}) {
        const dvec3 toSun = towardsSun(elevation);
        const dvec2 shear = optics64::sunShear(toSun);
        const dvec3 from(2.0, -1.0, 0.3); // x, z, y
        for (const double height : {-4.0, 0.3, 1.5}) {
            const dvec3 to = optics64::sunRayAtHeight(from, height, shear);
            EXPECT_EQ(to.z, height);
            const dvec3 step(to.x - from.x, to.z - from.z, to.y - from.y); // x, y, z
            EXPECT_NEAR(glm::length(glm::cross(step, toSun)), 0.0, 1.0e-13);
            const dvec2 start = optics64::sunPlane({from.x, from.z, from.y}, level, shear);
            const dvec2 end = optics64::sunPlane({to.x, to.z, to.y}, level, shear);
            EXPECT_NEAR(glm::distance(start, end), 0.0, 1.0e-14);
        }
    }
}

TEST(OpticsCaustics, LightFallsOffAlongItsPath)
{
    const dvec3 absorption(0.5, 0.2, 0.0);
    EXPECT_EQ(optics64::photonLight(0.3, 0.0, absorption), dvec3(0.3));
    const dvec3 light = optics64::photonLight(0.3, 4.0, absorption);
    EXPECT_NEAR(light.x, 0.3 * std::exp(-2.0), 1.0e-15);
    EXPECT_NEAR(light.y, 0.3 * std::exp(-0.8), 1.0e-15);
    EXPECT_EQ(light.z, 0.3);
}

TEST(OpticsCaustics, APhotonsWeightsSumToOne)
{
    for (double x = 0.0; x < 1.0; x += 0.09) {
        for (double y = 0.0; y < 1.0; y += 0.11) {
            double sum = 0.0;
            for (int j = -2; j <= 2; ++j)
                for (int i = -2; i <= 2; ++i) sum += optics64::photonWeight(dvec2(i + x, j + y));
            EXPECT_NEAR(sum, 1.0, 1.0e-14);
        }
    }
}

// Of triangles whose corners are moved by a linear map the areas change by its determinant, whatever its sign.
TEST(OpticsCaustics, ATrianglesAreaDoesNotDependOnItsOrientation)
{
    const dvec2 a(1.5, 0.25), b(-0.5, 2.0);
    const double area = 0.5 * (1.5 * 2.0 + 0.5 * 0.25);
    EXPECT_DOUBLE_EQ(optics64::triangleArea(a, b), area);
    EXPECT_DOUBLE_EQ(optics64::triangleArea(b, a), area);
    EXPECT_DOUBLE_EQ(optics64::triangleArea(-a, b), area);
    EXPECT_EQ(optics64::triangleArea(a, 3.0 * a), 0.0);
    EXPECT_TRUE(optics64::isAddedAsPoint(optics64::triangleArea(a, 3.0 * a)));
    EXPECT_FALSE(optics64::isAddedAsPoint(area));
}

TEST(OpticsCaustics, TheFiltersWeightsSumToOne)
{
    for (int radius = 0; radius <= 2; ++radius) {
        double sum = 0.0;
        for (int i = -3; i <= 3; ++i) {
            sum += optics64::causticsFilterWeight(radius, i);
            EXPECT_EQ(optics64::causticsFilterWeight(radius, i), optics64::causticsFilterWeight(radius, -i));
        }
        EXPECT_DOUBLE_EQ(sum, 1.0);
    }
}

TEST(OpticsCaustics, TheMapFadesOutBeforeItsEdgesAndTheWaters)
{
    const dvec4 map(0.0, 0.0, 10.0, 10.0), water(4.0, 0.0, 10.0, 20.0); // the water begins at x = -6
    const auto fade = [&](double x, double z) { return optics64::causticsFade({x, z}, map, water, 2.0, 0.1); };
    EXPECT_EQ(fade(0.0, 0.0), 1.0);
    EXPECT_NEAR(fade(9.0, 0.0), 0.5, 1.0e-15);
    EXPECT_NEAR(fade(0.0, -9.5), 0.25, 1.0e-15);
    EXPECT_NEAR(fade(9.0, 9.5), 0.25, 1.0e-15) << "the nearer edge counts";
    EXPECT_NEAR(fade(-5.0, 0.0), 0.5, 1.0e-15) << "the water's edge is nearer";
    EXPECT_EQ(fade(-6.0, 0.0), 0.0);
    EXPECT_EQ(fade(0.0, 11.0), 0.0);
    // No narrower than two texels.
    EXPECT_NEAR(optics64::causticsFade({9.9, 0.0}, map, water, 0.0, 0.1), 0.5, 1.0e-12);
}

// All of the way: photons through flat water bring what the formula for flat water says.
TEST(OpticsCaustics, FlatWaterIsLitAsWithoutAMap)
{
    const dvec3 sun(90.0, 80.0, 70.0), absorption(0.5, 0.2, 0.05);
    const double depth = 3.0;
    for (const double elevation : {0.3, 0.9, 1.4}) {
        const dvec3 toSun = towardsSun(elevation), toSunBelow = optics64::refractedSunDirection(toSun, ior);
        const double path = depth / toSunBelow.y;
        const dvec3 relative = optics64::photonLight(optics64::photonFlux(toSun.y, ior, 0.1, 0.1), path, absorption);
        const dvec3 lit = optics64::causticsIrradiance(relative, sun, toSun.y, toSunBelow.y);
        const dvec3 expected =
            optics64::sunIrradianceBelow(sun, toSun.y, ior) * optics64::beerLambert(absorption, path);
        EXPECT_NEAR(glm::distance(lit, expected), 0.0, 1.0e-12);
    }
}

/// |float - double| relative to the larger of 1 and the value: each formula is a handful of roundings of 2^-24.
TEST(OpticsCaustics, FloatIsOffByAFewRoundings)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f), offset(-1.5f, 1.5f), metres(-40.0f, 40.0f);
    double worst = 0.0;
    const auto compare = [&](const auto& inFloat, const auto& inDouble) {
        worst = std::max(worst, glm::length(glm::dvec3(inFloat) - inDouble) / std::max(1.0, glm::length(inDouble)));
    };
    for (int i = 0; i < 10000; ++i) {
        const float height = offset(random), path = 20.0f * unit(random), cosine = 0.05f + 0.95f * unit(random);
        const vec2 a(offset(random), offset(random)), b(offset(random), offset(random)),
            plane(metres(random), metres(random));
        const vec3 absorption(unit(random), unit(random), unit(random)), W(metres(random), metres(random), height);
        const vec4 map(1.0f, -2.0f, 30.0f, 25.0f), water(-3.0f, 4.0f, 28.0f, 35.0f);
        compare(vec3(optics::photonEntryHeight(height, 0.2f * a, b)),
                dvec3(optics64::photonEntryHeight(height, dvec2(0.2f * a), dvec2(b))));
        compare(vec3(optics::photonFlux(cosine, 1.33f, 0.11f, 0.13f)),
                dvec3(optics64::photonFlux(cosine, 1.33f, 0.11f, 0.13f)));
        compare(optics::sunRayAtHeight(W, path, b), optics64::sunRayAtHeight(dvec3(W), path, dvec2(b)));
        compare(optics::photonLight(cosine, path, absorption), optics64::photonLight(cosine, path, dvec3(absorption)));
        compare(vec3(optics::photonWeight(a)), dvec3(optics64::photonWeight(dvec2(a))));
        compare(vec3(optics::triangleArea(a, b)), dvec3(optics64::triangleArea(dvec2(a), dvec2(b))));
        compare(vec3(optics::causticsFade(plane, map, water, 2.0f, 0.1f)),
                dvec3(optics64::causticsFade(dvec2(plane), dvec4(map), dvec4(water), 2.0, 0.1f)));
        compare(optics::causticsIrradiance(absorption, vec3(90.0f), cosine, 0.8f),
                optics64::causticsIrradiance(dvec3(absorption), dvec3(90.0), cosine, 0.8f));
    }
    EXPECT_LT(worst, std::ldexp(1.0, -19));
    EXPECT_GT(worst, std::ldexp(1.0, -26)) << "float and double are the same code";
}

} // namespace
} // namespace tarn
