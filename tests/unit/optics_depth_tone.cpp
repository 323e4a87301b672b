// Depth-buffer inversion and the tone curves.

#include "optics/optics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tarn {
namespace {

TEST(Depth, AgreesWithTheProjectionMatrix)
{
    const double near = 0.1, far = 1000.0;
    const glm::dmat4 clipFromView = glm::perspective(0.9, 1.3, near, far);
    for (double z : {-0.1, -0.5, -3.0, -70.0, -999.0, -1000.0}) {
        const glm::dvec4 clip = clipFromView * glm::dvec4(0.3, -0.2, z, 1.0);
        const double depth = 0.5 * clip.z / clip.w + 0.5;
        EXPECT_NEAR(optics64::depthFromViewZ(z, near, far), depth, 1e-12) << z;
        EXPECT_NEAR(optics64::viewZFromDepth(depth, near, far), z, 1e-9 * z * z) << z;
    }
    EXPECT_DOUBLE_EQ(optics64::viewZFromDepth(0.0, near, far), -near);
    EXPECT_DOUBLE_EQ(optics64::viewZFromDepth(1.0, near, far), -far);
}

/// In float the far plane itself stays exact, which the textbook form f - d (f - n) misses by up to 10 %.
TEST(Depth, FloatKeepsTheEndsAtExtremeRatios)
{
    for (float far : {10.0f, 1000.0f, 1.0e5f}) {
        EXPECT_FLOAT_EQ(optics::viewZFromDepth(1.0f, 0.01f, far), -far);
        EXPECT_FLOAT_EQ(optics::viewZFromDepth(0.0f, 0.01f, far), -0.01f);
        EXPECT_EQ(optics::depthFromViewZ(-0.01f, 0.01f, far), 0.0f);
        EXPECT_FLOAT_EQ(optics::depthFromViewZ(-far, 0.01f, far), 1.0f);
    }
}

/// A 24-bit buffer gives z back to half a unit of its resolution, z² (f - n) / (f n) · 2^-24, and not much
/// better.
TEST(Depth, QuantisationTo24BitsCostsWhatTheDerivativeSays)
{
    const double near = 0.1, far = 1000.0, unit = 1.0 / ((1 << 24) - 1);
    double worstFraction = 0.0;
    for (double z = -0.2; z > -900.0; z *= 1.013) {
        const double stored = std::round(optics64::depthFromViewZ(z, near, far) / unit) * unit;
        const double error = std::abs(optics64::viewZFromDepth(stored, near, far) - z);
        const double resolution = optics64::viewZPerDepth(z, near, far) * unit;
        EXPECT_LE(error, 0.51 * resolution + 1e-12) << z;
        worstFraction = std::max(worstFraction, error / resolution);
    }
    EXPECT_GT(worstFraction, 0.4);
    // What that means for the lake: a tenth of a millimetre at 10 m.
    EXPECT_NEAR(optics64::viewZPerDepth(-10.0, near, far) * unit, 6.0e-5, 1.0e-6);
}

using ToneCurve = vec3 (*)(vec3);

TEST(ToneCurve, EachIsMonotonicBoundedAndSafeAtTheExtremes)
{
    const float infinity = std::numeric_limits<float>::infinity();
    const float largest = std::numeric_limits<float>::max();
    for (ToneCurve curve :
         {ToneCurve(optics::toneLinear), ToneCurve(optics::toneReinhard), ToneCurve(optics::toneAces)}) {
        EXPECT_EQ(curve(vec3(0.0f)), vec3(0.0f));
        EXPECT_EQ(curve(vec3(-1.0f)), vec3(0.0f));
        float last = 0.0f;
        for (float x = 1.0e-4f; x < 1.0e5f; x *= 1.1f) {
            const float y = curve(vec3(x)).y;
            EXPECT_GE(y, last - 1e-6f) << x;
            EXPECT_LE(y, 1.0f) << x;
            last = y;
        }
        for (float x : {1.0e30f, largest, infinity}) EXPECT_GT(curve(vec3(x)).x, 0.999f) << x;
    }
}

TEST(ToneCurve, KnownValues)
{
    EXPECT_EQ(optics64::toneLinear(glm::dvec3(0.3, 1.7, -2.0)), glm::dvec3(0.3, 1.0, 0.0));
    EXPECT_DOUBLE_EQ(optics64::toneReinhard(glm::dvec3(1.0)).x, 0.5);
    EXPECT_DOUBLE_EQ(optics64::toneReinhard(glm::dvec3(4.0)).x, 0.8);
    // Narkowicz' fit at 1: 2.54 / 3.16.
    EXPECT_NEAR(optics64::toneAces(glm::dvec3(1.0)).x, 2.54 / 3.16, 1e-15);
}

TEST(Anaglyph, EachFilterPassesItsEyesPicture)
{
    using glm::dvec3;
    using optics64::anaglyphRedCyan;
    for (const double grey : {0.0, 0.2, 1.0})
        EXPECT_LT(glm::distance(anaglyphRedCyan(dvec3(grey), dvec3(grey)), dvec3(grey)), 1e-4) << "equal grey stays";
    // Through the red filter the left eye's light alone is seen, through the cyan one the right eye's.
    const dvec3 onlyLeft = anaglyphRedCyan(dvec3(1.0), dvec3(0.0)), onlyRight = anaglyphRedCyan(dvec3(0.0), dvec3(1.0));
    EXPECT_GT(onlyLeft.x, 0.99);
    EXPECT_EQ(glm::dvec2(onlyLeft.y, onlyLeft.z), glm::dvec2(0.0)) << "less than black is cut off";
    EXPECT_EQ(onlyRight.x, 0.0);
    EXPECT_GT(std::min(onlyRight.y, onlyRight.z), 0.99);
    // A red that the cyan filter cannot pass is dim, not black, to the right eye: least squares spreads what is lost.
    EXPECT_NEAR(anaglyphRedCyan(dvec3(0.0), dvec3(1.0, 0.0, 0.0)).y, 0.378476, 1e-9);
}

TEST(Srgb, RoundTripsAndMatchesTheStandard)
{
    for (int i = 0; i <= 1000; ++i) {
        const double v = i / 1000.0;
        // The standard's two pieces meet to within 3e-8 only (its constants are rounded).
        EXPECT_NEAR(optics64::linearFromSrgb(optics64::srgbFromLinear(v)), v, 1e-7) << v;
    }
    EXPECT_NEAR(optics64::srgbFromLinear(0.0031308), 12.92 * 0.0031308, 1e-15);
    EXPECT_NEAR(optics64::srgbFromLinear(0.2140411), 0.5, 1e-6);
    EXPECT_NEAR(optics64::linearFromSrgb(0.5), 0.2140411, 1e-7);
    EXPECT_EQ(optics64::srgbFromLinear(2.0), optics64::srgbFromLinear(1.0));
    EXPECT_NEAR(optics64::srgbFromLinear(1.0), 1.0, 1e-15);
    // Every 8-bit value survives decoding and encoding in float.
    for (int i = 0; i < 256; ++i) {
        const vec3 linear = optics::linearColour(vec3(static_cast<float>(i) / 255.0f));
        EXPECT_EQ(static_cast<int>(std::lround(optics::srgbColour(linear).y * 255.0f)), i);
    }
}

} // namespace
} // namespace tarn
