// Snell, Fresnel and Beer-Lambert against closed forms.

#include "optics/optics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tarn {
namespace {

using glm::dvec3;

constexpr double n = 1.33;
constexpr double degree = std::numbers::pi / 180.0;
const dvec3 up(0.0, 1.0, 0.0);

/// Going down at an angle of incidence from a surface whose normal is up.
dvec3 falling(double angle) { return {std::sin(angle), -std::cos(angle), 0.0}; }

double angleBelow(const dvec3& direction) { return std::atan2(std::hypot(direction.x, direction.z), -direction.y); }

TEST(Snell, BendsTowardsTheNormalOnTheWayIn)
{
    for (double angle = 0.0; angle < 90.0; angle += 0.37) {
        const dvec3 refracted = optics64::refractRay(falling(angle * degree), up, 1.0 / n);
        EXPECT_NEAR(std::sin(angleBelow(refracted)), std::sin(angle * degree) / n, 1e-14) << angle;
        EXPECT_NEAR(glm::length(refracted), 1.0, 1e-14) << angle;
        EXPECT_NEAR(refracted.z, 0.0, 1e-15);
    }
}

TEST(Snell, TheWayOutIsTheWayInReversed)
{
    for (double angle = 0.0; angle < 89.95; angle += 0.37) {
        const dvec3 incident = falling(angle * degree);
        const dvec3 refracted = optics64::refractRay(incident, up, 1.0 / n);
        const dvec3 back = optics64::refractRay(-refracted, -up, n);
        EXPECT_LT(glm::length(back + incident), 1e-12) << angle;
    }
}

TEST(Snell, TotalReflectionBeginsAtTheCriticalAngle)
{
    const double critical = std::asin(1.0 / n);
    EXPECT_NEAR(critical / degree, 48.75, 0.005);
    EXPECT_GT(glm::length(optics64::refractRay(falling(critical - 1e-6), up, n)), 0.5);
    EXPECT_EQ(optics64::refractRay(falling(critical + 1e-6), up, n), dvec3(0.0));
    EXPECT_LT(optics64::fresnelExact(std::cos(critical - 1e-3), n), 1.0);
    EXPECT_EQ(optics64::fresnelExact(std::cos(critical + 1e-6), n), 1.0);
}

TEST(Snell, EqualMediaLeaveTheRayAlone)
{
    for (double angle = 0.0; angle < 90.0; angle += 5.0) {
        const dvec3 incident = falling(angle * degree);
        EXPECT_LT(glm::length(optics64::refractRay(incident, up, 1.0) - incident), 1e-12);
    }
}

TEST(RefractRayOfPaper, IsSnellsNearTheNormalAndNeverZero)
{
    // R1 = n(-N - E) + N; E points down to the eye, as falling() does.
    for (double angle = 0.0; angle < 90.0; angle += 1.0) {
        const dvec3 ray = optics64::refractRayOfPaper(falling(angle * degree), up, n);
        const dvec3 expected(-n * std::sin(angle * degree), 1.0 - n * (1.0 - std::cos(angle * degree)), 0.0);
        EXPECT_LT(glm::length(ray - expected), 1e-14) << angle;
        EXPECT_GT(glm::length(ray), 0.9) << angle;
    }
    const dvec3 paper = glm::normalize(optics64::refractRayOfPaper(falling(2.0 * degree), up, n));
    EXPECT_LT(glm::length(paper - optics64::refractRay(-falling(2.0 * degree), -up, n)), 1e-3);
}

TEST(Reflection, MirrorsTheRayWhicheverWayTheNormalPoints)
{
    const dvec3 incident = falling(0.7);
    EXPECT_LT(glm::length(optics64::reflectRay(incident, up) - dvec3(incident.x, -incident.y, 0.0)), 1e-15);
    EXPECT_LT(glm::length(optics64::reflectRay(incident, -up) - optics64::reflectRay(incident, up)), 1e-15);
}

/// The textbook form: tangents and sines of the two angles (Fresnel 1823), an independent way to the same
/// number.
double fresnelByAngles(double incident, double eta)
{
    const double refracted = std::asin(std::sin(incident) * eta);
    const double s = std::sin(incident - refracted) / std::sin(incident + refracted);
    const double p = std::tan(incident - refracted) / std::tan(incident + refracted);
    return 0.5 * (s * s + p * p);
}

TEST(Fresnel, AgreesWithTheSineAndTangentForm)
{
    for (double angle = 0.5; angle < 89.95; angle += 0.1)
        EXPECT_NEAR(optics64::fresnelExact(std::cos(angle * degree), 1.0 / n), fresnelByAngles(angle * degree, 1.0 / n),
                    1e-12)
            << angle;
    for (double angle = 0.5; angle < 48.7; angle += 0.1)
        EXPECT_NEAR(optics64::fresnelExact(std::cos(angle * degree), n), fresnelByAngles(angle * degree, n), 1e-12)
            << angle;
}

TEST(Fresnel, AtNormalIncidenceAndAtBrewstersAngle)
{
    const double f0 = std::pow((n - 1.0) / (n + 1.0), 2.0);
    EXPECT_NEAR(f0, 0.02006, 1e-5);
    EXPECT_NEAR(optics64::fresnelExact(1.0, 1.0 / n), f0, 1e-15);
    EXPECT_NEAR(optics64::fresnelExact(1.0, n), f0, 1e-15);
    // At Brewster's angle the parallel part vanishes and the other is ((n² - 1) / (n² + 1))².
    const double brewster = std::atan(n);
    const double perpendicular = std::pow((n * n - 1.0) / (n * n + 1.0), 2.0);
    EXPECT_NEAR(optics64::fresnelExact(std::cos(brewster), 1.0 / n), 0.5 * perpendicular, 1e-14);
}

TEST(Fresnel, ApproachesOneAtGrazingIncidence)
{
    EXPECT_NEAR(optics64::fresnelExact(std::cos(89.9 * degree), 1.0 / n), fresnelByAngles(89.9 * degree, 1.0 / n),
                1e-10);
    EXPECT_GT(optics64::fresnelExact(std::cos(89.9 * degree), 1.0 / n), 0.98);
    EXPECT_NEAR(optics64::fresnelExact(0.0, 1.0 / n), 1.0, 1e-15);
    // A cosine outside 0..1, as an interpolated normal gives it, counts as its nearest end.
    EXPECT_EQ(optics64::fresnelExact(-0.1, 1.0 / n), optics64::fresnelExact(0.0, 1.0 / n));
    EXPECT_EQ(optics64::fresnelExact(1.001, 1.0 / n), optics64::fresnelExact(1.0, 1.0 / n));
}

TEST(Fresnel, IsTheSameFromBothSides)
{
    for (double angle = 0.0; angle < 89.95; angle += 0.5) {
        const double below = std::asin(std::sin(angle * degree) / n);
        EXPECT_NEAR(optics64::fresnelExact(std::cos(angle * degree), 1.0 / n),
                    optics64::fresnelExact(std::cos(below), n), 1e-11)
            << angle;
    }
}

/// F + T = 1 with T from Fresnel's transmitted amplitudes, which the code under test does not use.
TEST(Fresnel, WhatIsNotReflectedIsTransmitted)
{
    for (double angle = 0.5; angle < 89.95; angle += 0.5) {
        const double a = angle * degree;
        const double b = std::asin(std::sin(a) / n);
        const double ts = 2.0 * std::cos(a) / (std::cos(a) + n * std::cos(b));
        const double tp = 2.0 * std::cos(a) / (n * std::cos(a) + std::cos(b));
        const double transmitted = 0.5 * (ts * ts + tp * tp) * n * std::cos(b) / std::cos(a);
        EXPECT_NEAR(optics64::fresnelExact(std::cos(a), 1.0 / n) + transmitted, 1.0, 1e-12) << angle;
    }
}

/// The accuracy that the design page quotes for Schlick's approximation: 0.06 too low at worst, near 84°; and
/// the relative error at the steeper angles at which water is mostly looked at.
TEST(Schlick, IsOffByWhatTheDesignSays)
{
    double worst = 0.0, worstAngle = 0.0, lowest = 0.0, lowestAngle = 0.0;
    for (double angle = 0.0; angle < 90.0; angle += 0.01) {
        const double exact = optics64::fresnelExact(std::cos(angle * degree), 1.0 / n);
        const double error = optics64::fresnelSchlick(std::cos(angle * degree), n, 5.0) - exact;
        if (std::abs(error) > std::abs(worst)) worst = error, worstAngle = angle;
        if (error / exact < lowest) lowest = error / exact, lowestAngle = angle;
    }
    RecordProperty("worst", std::to_string(worst) + " at " + std::to_string(worstAngle));
    RecordProperty("lowest", std::to_string(lowest) + " at " + std::to_string(lowestAngle));
    EXPECT_NEAR(std::abs(worst), 0.060, 0.003) << worst;
    EXPECT_NEAR(worstAngle, 84.0, 1.0);
    EXPECT_NEAR(lowest, -0.23, 0.01);
    EXPECT_NEAR(lowestAngle, 51.0, 1.0);
}

TEST(Schlick, IsExactAtBothEndsWhateverTheExponent)
{
    for (double q : {0.5, 1.0, 5.0, 20.0}) {
        EXPECT_NEAR(optics64::fresnelSchlick(1.0, n, q), optics64::fresnelExact(1.0, 1.0 / n), 1e-15);
        EXPECT_EQ(optics64::fresnelSchlick(0.0, n, q), 1.0);
    }
}

TEST(BeerLambert, MultipliesAlongThePath)
{
    const dvec3 k(0.5, 0.07, 0.02);
    const dvec3 whole = optics64::beerLambert(k, 7.0);
    const dvec3 parts = optics64::beerLambert(k, 3.0) * optics64::beerLambert(k, 4.0);
    EXPECT_LT(glm::length(whole - parts), 1e-15);
    EXPECT_NEAR(whole.x, std::exp(-3.5), 1e-15);
    EXPECT_EQ(optics64::beerLambert(k, 0.0), dvec3(1.0));
    EXPECT_EQ(optics64::beerLambert(k, -1.0), dvec3(1.0));
    EXPECT_EQ(optics64::beerLambert(k, 1e6), dvec3(0.0));
}

TEST(LinearAttenuation, EndsAtItsLength)
{
    EXPECT_EQ(optics64::linearAttenuation(0.0, 7.5), 1.0);
    EXPECT_EQ(optics64::linearAttenuation(-1.0, 7.5), 1.0);
    EXPECT_NEAR(optics64::linearAttenuation(1.5, 7.5), 0.8, 1e-15);
    EXPECT_EQ(optics64::linearAttenuation(7.5, 7.5), 0.0);
    EXPECT_EQ(optics64::linearAttenuation(1e6, 7.5), 0.0);
    for (double path = 0.0; path < 10.0; path += 0.01)
        EXPECT_NEAR(static_cast<double>(optics::linearAttenuation(static_cast<float>(path), 7.5f)),
                    optics64::linearAttenuation(path, 7.5), 1e-6)
            << path;
}

TEST(RadianceThroughWater, GoesFromTheBedToTheDeep)
{
    const dvec3 bed(3.0, 2.0, 1.0), deep(0.1, 0.4, 0.3), k(0.5);
    EXPECT_LT(glm::length(optics64::radianceThroughWater(bed, deep, dvec3(1.0)) - bed), 1e-15);
    EXPECT_LT(glm::length(optics64::radianceThroughWater(bed, deep, dvec3(0.0)) - deep), 1e-15);
    // Two stretches of water are one of their summed length.
    const dvec3 twice = optics64::radianceThroughWater(
        optics64::radianceThroughWater(bed, deep, optics64::beerLambert(k, 1.0)), deep, optics64::beerLambert(k, 2.0));
    const dvec3 once = optics64::radianceThroughWater(bed, deep, optics64::beerLambert(k, 3.0));
    EXPECT_LT(glm::length(twice - once), 1e-15);
}

TEST(RadianceThroughSurface, IsDividedByTheSquareOfTheIndex)
{
    EXPECT_NEAR(optics64::radianceThroughSurface(1.0, n), 0.565, 5e-4);
    // A uniform field of radiance L below fills, above, T/n² of itself over the hemisphere: the flux through
    // a patch is the same counted on either side. Integrated over the angle above, with T of each angle.
    double above = 0.0, below = 0.0;
    const int steps = 20000;
    for (int i = 0; i < steps; ++i) {
        const double a = (i + 0.5) / steps * 90.0 * degree;
        const double da = 90.0 * degree / steps;
        const double t = 1.0 - optics64::fresnelExact(std::cos(a), 1.0 / n);
        above += optics64::radianceThroughSurface(t, n) * std::sin(a) * std::cos(a) * da;
        const double b = (i + 0.5) / steps * std::asin(1.0 / n);
        const double db = std::asin(1.0 / n) / steps;
        below += (1.0 - optics64::fresnelExact(std::cos(b), n)) * std::sin(b) * std::cos(b) * db;
    }
    EXPECT_NEAR(above, below, 1e-5 * below);
}

/// Whatever the eye's height, the bed's depth and the distance: Snell's law holds at the crossing.
template <typename Check> void overFlatWater(Check check)
{
    for (const double height : {0.05, 0.5, 2.0, 30.0})
        for (const double depth : {0.01, 0.3, 2.0, 20.0})
            for (const double across : {0.0, 0.01, 0.5, 3.0, 40.0, 300.0}) check(height, depth, across);
}

TEST(FlatWater, RaysCrossWhereSnellSays)
{
    overFlatWater([](double height, double depth, double across) {
        const double y = optics64::flatSidestep(height, depth, across, n);
        const double sinAir = (across - y) / std::hypot(across - y, height), sinWater = y / std::hypot(y, depth);
        EXPECT_NEAR(sinAir, n * sinWater, 1e-6) << height << " " << depth << " " << across;
        const float single = optics::flatSidestep(static_cast<float>(height), static_cast<float>(depth),
                                                  static_cast<float>(across), static_cast<float>(n));
        EXPECT_NEAR(single, y, 1e-5 * (0.1 + depth)) << height << " " << depth << " " << across;
    });
}

TEST(FlatWater, WhereThingsSeemToBeAndAreAreInverse)
{
    const dvec3 eye(3.0, 1.0, -2.0);
    overFlatWater([&](double height, double depth, double across) {
        const double level = eye.y - height;
        const dvec3 point = dvec3(eye.x + 0.6 * across, level - depth, eye.z + 0.8 * across);
        const dvec3 seen = optics64::flatApparent(eye, point, level, n);
        EXPECT_LT(glm::distance(optics64::flatTrue(eye, seen, level, n), point), 2e-5 * (1.0 + across + depth));
        // The light comes from the crossing, and as far as it has come.
        const double y = optics64::flatSidestep(height, depth, across, n);
        EXPECT_NEAR(glm::distance(eye, seen), std::hypot(across - y, height) + std::hypot(y, depth),
                    1e-6 * (1.0 + across));
    });
    const dvec3 dry(1.0, 0.5, 4.0);
    EXPECT_EQ(optics64::flatApparent(eye, dry, 0.0, n), dry);
}

} // namespace
} // namespace tarn
