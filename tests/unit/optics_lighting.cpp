// Sky and sun in and on the water, and the normalisation of the highlights.

#include "optics/optics.h"
#include "optics/waves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace tarn {
namespace {

using glm::dvec3;
using glm::dvec4;

constexpr double n = 1.33;
constexpr double pi64 = std::numbers::pi;
constexpr double degree = pi64 / 180.0;
const dvec3 up(0.0, 1.0, 0.0);

dvec3 fromAngles(double zenith, double azimuth)
{
    return {std::sin(zenith) * std::cos(azimuth), std::cos(zenith), std::sin(zenith) * std::sin(azimuth)};
}

/// Midpoint rule over the sphere's part with zenith angles up to `last`.
double integral(const std::function<double(dvec3)>& f, double last, int rings = 400, int sectors = 200)
{
    double sum = 0.0;
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < sectors; ++j) {
            const double zenith = (i + 0.5) / rings * last;
            sum += f(fromAngles(zenith, (j + 0.5) / sectors * 2.0 * pi64)) * std::sin(zenith);
        }
    return sum * (last / rings) * (2.0 * pi64 / sectors);
}

TEST(SkyIrradiance, BasisIsOrthogonal)
{
    for (int i = 0; i < 9; ++i)
        for (int j = 0; j < i; ++j) {
            auto product = [&](dvec3 d) { return optics64::shBasis(i, d) * optics64::shBasis(j, d); };
            EXPECT_NEAR(integral(product, pi64), 0.0, 1e-3) << i << ' ' << j;
        }
}

TEST(SkyIrradiance, IsTheSumOverTheBasis)
{
    dvec4 c[9];
    for (int i = 0; i < 9; ++i) c[i] = dvec4(1.0 + 0.1 * i, 2.0 - 0.1 * i, 0.3 * i, 99.0);
    c[0] = dvec4(20.0, 20.0, 20.0, 99.0);
    for (double zenith : {0.0, 0.4, 1.5, 2.9})
        for (double azimuth : {0.0, 1.0, 4.0}) {
            const dvec3 normal = fromAngles(zenith, azimuth);
            dvec3 sum(0.0);
            for (int i = 0; i < 9; ++i) sum += dvec3(c[i]) * optics64::shBasis(i, normal);
            EXPECT_LT(glm::length(optics64::shIrradiance(c, normal) - sum), 1e-12);
        }
    for (auto& x : c) x = dvec4(0.0);
    c[1] = dvec4(1.0);
    EXPECT_EQ(optics64::shIrradiance(c, -up), dvec3(0.0)) << "never negative";
}

/// The two constants of light from a uniform sky, from their definitions.
TEST(SkyBelow, ConstantsAreTheIntegralsTheyNameThemselves)
{
    auto passed = [](dvec3 d) { return (1.0 - optics64::fresnelExact(d.y, 1.0 / n)) * d.y; };
    EXPECT_NEAR(integral(passed, 0.5 * pi64) / pi64, optics64::diffuseTransmittance, 1e-3);
    const double critical = std::asin(1.0 / n);
    auto weight = [](dvec3 d) { return d.y; };
    auto one = [](dvec3) { return 1.0; };
    EXPECT_NEAR(integral(one, critical) / integral(weight, critical), optics64::skyPathFactor, 0.01);
}

TEST(SkyBelow, FallsOffWithDepthAndTilt)
{
    const dvec3 k(0.5, 0.1, 0.05);
    const dvec3 below = optics64::skyIrradianceBelow(dvec3(10.0));
    EXPECT_LT(glm::length(below - dvec3(9.34)), 1e-12);
    EXPECT_LT(glm::length(optics64::skyIrradianceAtDepth(below, k, 0.0, up) - below), 1e-12);
    EXPECT_LT(glm::length(optics64::skyIrradianceAtDepth(below, k, 3.0, -up)), 1e-12);
    EXPECT_NEAR(optics64::skyIrradianceAtDepth(below, k, 2.0, dvec3(1, 0, 0)).x, 0.5 * 9.34 * std::exp(-1.2), 1e-12);
}

TEST(SunBelow, DirectionObeysSnell)
{
    for (double zenith = 0.0; zenith < 90.0; zenith += 1.0) {
        const dvec3 sun = fromAngles(zenith * degree, 0.7);
        const dvec3 below = optics64::refractedSunDirection(sun, n);
        EXPECT_LT(glm::length(below + optics64::refractRay(-sun, up, 1.0 / n)), 1e-12) << zenith;
    }
    // A sun that has set stands on the horizon of its azimuth.
    const dvec3 set = optics64::refractedSunDirection(fromAngles(100.0 * degree, 0.7), n);
    EXPECT_NEAR(std::acos(set.y) / degree, 48.75, 0.01);
    EXPECT_NEAR(std::atan2(set.z, set.x), 0.7, 1e-12);
    EXPECT_EQ(optics::refractedSunDirection(vec3(0.0f, 1.0f, 0.0f), 1.33f), vec3(0.0f, 1.0f, 0.0f));
}

/// The flux through a square metre of surface is the same above and below, less what is reflected.
TEST(SunBelow, ConservesTheFluxThroughTheSurface)
{
    for (double zenith = 0.0; zenith < 90.0; zenith += 1.0) {
        const double cosAir = std::cos(zenith * degree);
        const dvec3 below = optics64::sunIrradianceBelow(dvec3(100.0), cosAir, n);
        const double cosWater = std::sqrt(1.0 - std::pow(std::sin(zenith * degree) / n, 2.0));
        EXPECT_NEAR(below.x * cosWater, 100.0 * cosAir * (1.0 - optics64::fresnelExact(cosAir, 1.0 / n)), 1e-10);
    }
    EXPECT_EQ(optics64::sunIrradianceBelow(dvec3(100.0), -0.1, n), dvec3(0.0));
    EXPECT_EQ(optics64::sunIrradianceBelow(dvec3(100.0), 0.0, 1.0), dvec3(0.0));
    EXPECT_NEAR(optics64::sunIrradianceBelow(dvec3(100.0), 1.0, n).x, 97.994, 1e-3);
}

TEST(DeepWater, IsADiffuseReflector)
{
    const dvec3 radiance = optics64::deepWaterRadiance(dvec3(0.0, 0.2, 0.1), dvec3(70.0), dvec3(30.0));
    EXPECT_LT(glm::length(radiance - dvec3(0.0, 20.0 / pi64, 10.0 / pi64)), 1e-12);
}

/// Straight on, the lobe reflects exactly Ks; elsewhere never more.
TEST(BlinnPhong, ReflectsKs)
{
    for (double shininess : {0.0, 1.0, 8.0, 32.0, 200.0}) {
        for (double zenith : {0.0, 30.0, 60.0, 80.0}) {
            const dvec3 eye = fromAngles(zenith * degree, 0.0);
            auto reflected = [&](dvec3 light) {
                return optics64::blinnPhong(glm::normalize(eye + light).y, shininess) * light.y;
            };
            const double fraction = integral(reflected, 0.5 * pi64);
            if (zenith == 0.0) {
                EXPECT_NEAR(fraction, 1.0, 0.002) << shininess;
            }
            EXPECT_LE(fraction, 1.002) << shininess << ' ' << zenith;
            // At grazing angles half of the lobe points below the surface; that light is lost.
            if (zenith <= 60.0) {
                EXPECT_GT(fraction, 0.2) << shininess << ' ' << zenith;
            }
        }
    }
    EXPECT_EQ(optics64::blinnPhong(-0.5, 200.0), 0.0);
    EXPECT_NEAR(optics::blinnPhong(0.0f, 0.0f), 1.0f / std::numbers::pi_v<float>, 1e-6f);
}

/// Mean of the glint's reflectance over sun directions, for one eye: the fraction of a uniform sky's light that
/// rough water would mirror, F = 1. Integrated over facets, where the lobe is wide: dω = 4 cos(facet, eye)
/// dω_facet.
double glintReflectance(double zenith, double variance)
{
    const dvec3 eye = fromAngles(zenith, 0.0);
    auto reflected = [&](dvec3 facet) {
        const double cosine = glm::dot(facet, eye);
        if (cosine <= 0.0) return 0.0;
        const dvec3 sun = 2.0 * cosine * facet - eye;
        return optics64::sunGlint(dvec3(1.0), 1.0, up, eye, sun, variance).x * 4.0 * cosine;
    };
    return integral(reflected, std::min(0.5 * pi64, 12.0 * std::sqrt(variance)), 800, 400);
}

/// Energy is conserved: what misses is light that strikes the surface twice.
TEST(SunGlint, IntegratesToTheMirrorsReflectance)
{
    for (double variance : {1e-4, 4e-4, 1e-3}) {
        for (double zenith : {0.0, 30.0, 60.0, 75.0})
            EXPECT_NEAR(glintReflectance(zenith * degree, variance), 1.0, 0.02) << zenith << ' ' << variance;
    }
    for (double variance : {1e-2, 4e-2}) {
        EXPECT_NEAR(glintReflectance(0.0, variance), 1.0, 0.04) << variance;
        for (double zenith : {30.0, 60.0, 80.0, 89.0}) {
            EXPECT_LT(glintReflectance(zenith * degree, variance), 1.01) << zenith << ' ' << variance;
            EXPECT_GT(glintReflectance(zenith * degree, variance), 0.6) << zenith << ' ' << variance;
        }
    }
}

TEST(SunGlint, IsTheSameWithEyeAndSunExchangedButForTheCosines)
{
    const dvec3 a = fromAngles(0.7, 0.1), b = fromAngles(0.9, 3.0);
    const double there = optics64::sunGlint(dvec3(1.0), 1.0, up, a, b, 0.01).x / b.y;
    const double back = optics64::sunGlint(dvec3(1.0), 1.0, up, b, a, 0.01).x / a.y;
    EXPECT_NEAR(there, back, 1e-12 * there);
    EXPECT_GT(there, 0.0);
}

TEST(SunGlint, IsFiniteEverywhere)
{
    const vec3 upF(0.0f, 1.0f, 0.0f);
    for (float variance : {0.0f, 1e-6f, 1e-3f, 0.1f, 1.0f})
        for (double eyeZenith : {0.0, 45.0, 89.0, 89.9, 90.0, 91.0, 135.0, 180.0})
            for (double sunZenith : {0.0, 45.0, 89.0, 89.9, 90.0, 91.0, 135.0, 180.0})
                for (double azimuth : {0.0, 1.0, 180.0 * degree}) {
                    const vec3 eye(fromAngles(eyeZenith * degree, 0.0)), sun(fromAngles(sunZenith * degree, azimuth));
                    const float l = optics::sunGlint(vec3(100.0f), 1.0f, upF, eye, sun, variance).x;
                    ASSERT_TRUE(std::isfinite(l)) << variance << ' ' << eyeZenith << ' ' << sunZenith;
                    ASSERT_GE(l, 0.0f);
                    // The brightest it may be is the sun itself.
                    ASSERT_LE(l, 100.0f / optics::sunSolidAngle * 1.0001f);
                    if (sunZenith > 90.5) {
                        ASSERT_EQ(l, 0.0f);
                    }
                }
}

/// Calm water mirrors a sun as bright as it is: 100 klx from a disc of 6.8e-5 sr is 1.47e6 kcd/m².
TEST(SunGlint, CalmWaterShowsTheSunAsBrightAsItIs)
{
    const dvec3 eye = fromAngles(0.5, 0.0), sun = fromAngles(0.5, pi64);
    const double peak = optics64::sunGlint(dvec3(100.0), 1.0, up, eye, sun, 0.0).x;
    EXPECT_NEAR(optics64::sunSolidAngle, pi64 * std::pow(0.2666 * degree, 2.0), 1e-7);
    EXPECT_NEAR(peak, 100.0 / optics64::sunSolidAngle, 1.0);
}

/// Lipp's listing in its own terms: R = 2 (N·L) N - L, then (R·E)^n times colour, strength and Fresnel's fraction.
TEST(PhongGlint, IsLippsListing)
{
    const dvec3 sun = fromAngles(0.6, 0.3), eye = fromAngles(0.65, 0.35 + pi64);
    const dvec3 normal = glm::normalize(dvec3(0.05, 1.0, -0.03));
    const dvec3 R = 2.0 * glm::dot(normal, sun) * normal - sun;
    const double lobe = std::pow(std::max(glm::dot(R, eye), 0.0), 256.0);
    ASSERT_GT(lobe, 0.01);
    const dvec3 light(100.0, 90.0, 80.0), white = light / pi64; // of a white diffuse surface that faces the sun
    const dvec3 radiance = optics64::phongGlint(light, 0.4, normal, eye, sun, 256.0, 2.0);
    EXPECT_LT(glm::length(radiance - 0.4 * 2.0 * lobe * white), 1e-9);
    // Where the eye stands in the mirrored light the exponent makes no difference: the lobe keeps no energy.
    for (const double exponent : {1.0, 256.0, 5000.0})
        EXPECT_NEAR(optics64::phongGlint(light, 1.0, normal, R, sun, exponent, 2.0).x, 2.0 * white.x, 1e-9);
}

TEST(PhongGlint, IsFiniteAndNothingBehindTheSurface)
{
    const vec3 upF(0.0f, 1.0f, 0.0f);
    for (double eyeZenith : {0.0, 89.0, 90.0, 135.0, 180.0})
        for (double sunZenith : {0.0, 45.0, 89.9, 90.5, 180.0})
            for (float exponent : {1.0f, 256.0f, 10000.0f}) {
                const vec3 eye(fromAngles(eyeZenith * degree, 0.0)), sun(fromAngles(sunZenith * degree, 2.0));
                const float l = optics::phongGlint(vec3(100.0f), 1.0f, upF, eye, sun, exponent, 2.0f).x;
                ASSERT_TRUE(std::isfinite(l));
                ASSERT_GE(l, 0.0f);
                if (sunZenith > 90.0) {
                    ASSERT_EQ(l, 0.0f);
                }
            }
}

} // namespace
} // namespace tarn
