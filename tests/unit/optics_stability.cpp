// float against double, from the same source, at the inputs where formulas come apart. The bounds are what a
// picture can stand, and each is within a factor of a few of what is measured: a formula made less stable
// fails here.

#include "optics/optics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace tarn {
namespace {

using glm::dvec3;

constexpr double degree = std::numbers::pi / 180.0;
const vec3 up(0.0f, 1.0f, 0.0f);

/// The same input for both: double takes the float's rounded value.
vec3 falling(double angle) { return vec3(dvec3(std::sin(angle), -std::cos(angle), 0.0)); }

TEST(FloatAgainstDouble, RefractedDirection)
{
    double worst = 0.0;
    for (double angle = 0.0; angle <= 89.9; angle += 0.1)
        for (double tilt : {0.0, 0.1, 0.3}) {
            const vec3 incident = falling(angle * degree);
            const vec3 normal = glm::normalize(vec3(static_cast<float>(tilt), 1.0f, 0.2f));
            if (glm::dot(incident, normal) >= 0.0f) continue;
            const vec3 f = optics::refractRay(incident, normal, 1.0f / 1.33f);
            const dvec3 d = optics64::refractRay(dvec3(incident), dvec3(normal), double(1.0f / 1.33f));
            worst = std::max(worst, glm::length(dvec3(f) - d));
        }
    EXPECT_LT(worst, 5e-7); // radians: a twentieth of a millimetre over 100 m
    EXPECT_GT(worst, 0.0);
}

/// Near the critical angle the square root makes rounding 2000 times larger: sqrt(1e-7). No formula helps,
/// since the input's own rounding does the same; the bound says that it is no worse.
TEST(FloatAgainstDouble, CriticalAngle)
{
    const double critical = std::asin(1.0 / 1.33);
    for (double off : {1e-2, 1e-3, 1e-4, 1e-5}) {
        const vec3 incident = falling(critical - off);
        const vec3 f = optics::refractRay(incident, up, 1.33f);
        const dvec3 d = optics64::refractRay(dvec3(incident), dvec3(up), double(1.33f));
        ASSERT_GT(glm::length(d), 0.5);
        EXPECT_LT(glm::length(dvec3(f) - d), 4e-7 / std::sqrt(off)) << off;
    }
}

TEST(FloatAgainstDouble, Fresnel)
{
    double worst = 0.0, worstSchlick = 0.0;
    for (double angle = 0.0; angle <= 89.9; angle += 0.05) {
        const float cosine = static_cast<float>(std::cos(angle * degree));
        for (float eta : {1.0f / 1.33f, 1.33f, 1.0f / 1.31f, 1.0f / 2.4f}) {
            // Across the critical angle the two may fall on different sides.
            if (std::abs(eta * std::sin(angle * degree) - 1.0) < 1e-3) continue;
            worst = std::max(worst, std::abs(optics::fresnelExact(cosine, eta) -
                                             optics64::fresnelExact(double(cosine), double(eta))));
        }
        worstSchlick = std::max(worstSchlick, std::abs(optics::fresnelSchlick(cosine, 1.33f, 5.0f) -
                                                       optics64::fresnelSchlick(double(cosine), double(1.33f), 5.0)));
    }
    EXPECT_LT(worst, 4e-6); // steepest just below total reflection
    EXPECT_LT(worstSchlick, 1e-6);
}

TEST(FloatAgainstDouble, FresnelFromTheAirSideIsGoodToAMillionth)
{
    double worst = 0.0;
    for (double angle = 0.0; angle <= 89.9; angle += 0.01) {
        const float cosine = static_cast<float>(std::cos(angle * degree));
        worst = std::max(worst, std::abs(optics::fresnelExact(cosine, 1.0f / 1.33f) -
                                         optics64::fresnelExact(double(cosine), double(1.0f / 1.33f))));
    }
    EXPECT_LT(worst, 1e-6);
}

/// Depth in float loses what its 24 bits lose, and the way there and back adds three roundings
/// of the same size: within four units of the derivative, 2^-24 each.
TEST(FloatAgainstDouble, DepthInversion)
{
    const float near = 0.1f, far = 1000.0f;
    for (float z = -0.1f; z > -1000.0f; z *= 1.01f) {
        const float depth = optics::depthFromViewZ(z, near, far);
        const double back = optics::viewZFromDepth(depth, near, far);
        const double unit = optics64::viewZPerDepth(double(z), 0.1, 1000.0) * std::ldexp(1.0, -24);
        EXPECT_NEAR(back, double(z), 4.0 * unit + 3e-7 * std::abs(double(z))) << z;
    }
}

/// A search over a flat bed in float, at a size of 1 mm to 100 km: the error stays a millionth of the
/// distances.
TEST(FloatAgainstDouble, IntersectionSearch)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (double scale : {1e-3, 1.0, 1e3, 1e5}) {
        double worst = 0.0;
        for (int i = 0; i < 500; ++i) {
            const double zenith = 85.0 * degree * unit(random), azimuth = 6.3 * unit(random);
            // The camera looks straight ahead at U; the bed is the plane dot(p, down) = h, in its space.
            const dvec3 down =
                dvec3(std::sin(zenith) * std::cos(azimuth), std::sin(zenith) * std::sin(azimuth), -std::cos(zenith));
            const dvec3 u(0.0, 0.0, -scale);
            const dvec3 r = optics64::refractRay(dvec3(0, 0, -1), -down, 1.0 / 1.33);
            const double h = glm::dot(u, down) + scale * (0.01 + unit(random));
            auto bedZ = [&](auto w) { return w.z * h / glm::dot(dvec3(w), down); };
            const dvec3 truth = u + r * ((h - glm::dot(u, down)) / glm::dot(r, down));

            const vec3 uF(u), rF(r);
            auto state = optics::intersectionBegin(uF, rF, optics::depthSample(uF, static_cast<float>(bedZ(u))));
            for (int step = 1; step < 8; ++step) {
                if (glm::dot(dvec3(state.W), down) <= 0.0) break; // over the bed's horizon
                state = optics::intersectionStep(state, static_cast<float>(bedZ(dvec3(state.W))));
            }
            // Against the size of the triangle of eye, U and A1, which at grazing angles reaches far.
            const double reach = std::max(glm::length(truth), std::abs(bedZ(u)));
            worst = std::max(worst, glm::length(dvec3(state.best) - truth) / reach);
        }
        EXPECT_LT(worst, 5e-6) << scale;
    }
}

TEST(FloatAgainstDouble, SunGlint)
{
    // Relative to the lobe's peak: in its flank the exponent amplifies rounding, where it no longer shows.
    for (float variance : {0.0f, 1e-5f, 1e-3f, 0.05f}) {
        double worst = 0.0, peak = 0.0;
        for (double zenith : {0.0, 30.0, 60.0, 80.0, 89.0})
            for (double off = -0.1; off <= 0.1; off += 0.0007) {
                const vec3 eye(dvec3(std::sin(zenith * degree), std::cos(zenith * degree), 0.0));
                const vec3 sun(dvec3(-std::sin(zenith * degree + off), std::cos(zenith * degree + off), 0.0));
                const double f = optics::sunGlint(vec3(1.0f), 1.0f, up, eye, sun, variance).x;
                const double d =
                    optics64::sunGlint(dvec3(1.0), 1.0, dvec3(up), dvec3(eye), dvec3(sun), double(variance)).x;
                worst = std::max(worst, std::abs(f - d));
                peak = std::max(peak, d);
            }
        EXPECT_LT(worst / peak, variance < 1e-6f ? 2e-3 : 1e-3) << variance;
        EXPECT_GT(peak, 0.0);
    }
}

TEST(FloatAgainstDouble, ToneCurvesAndSrgb)
{
    for (float x = 1e-6f; x < 1e5f; x *= 1.05f) {
        EXPECT_NEAR(optics::toneAces(vec3(x)).x, optics64::toneAces(dvec3(double(x))).x, 3e-7) << x;
        EXPECT_NEAR(optics::toneReinhard(vec3(x)).x, optics64::toneReinhard(dvec3(double(x))).x, 2e-7) << x;
        EXPECT_NEAR(optics::srgbFromLinear(x), optics64::srgbFromLinear(double(x)), 3e-7) << x;
    }
}

} // namespace
} // namespace tarn
