// The filters of whole pictures: upscaling, the mean over an area, FXAA.
#include "optics/filters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

namespace tarn {
namespace {

using glm::dvec2;
using glm::dvec3;
using optics64::UpscaleTexels;

/// The texels of a picture that is known everywhere; c00 is at the origin.
UpscaleTexels texelsOf(const std::function<dvec3(double x, double y)>& colour)
{
    UpscaleTexels t;
    t.c00 = colour(0, 0), t.c10 = colour(1, 0), t.c01 = colour(0, 1), t.c11 = colour(1, 1);
    t.below0 = colour(0, -1), t.below1 = colour(1, -1), t.above0 = colour(0, 2), t.above1 = colour(1, 2);
    t.left0 = colour(-1, 0), t.left1 = colour(-1, 1), t.right0 = colour(2, 0), t.right1 = colour(2, 1);
    return t;
}

constexpr std::array<std::array<int, 2>, 12> places{
    {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {0, -1}, {1, -1}, {-1, 0}, {-1, 1}, {2, 0}, {2, 1}, {0, 2}, {1, 2}}};

void overFractions(const std::function<void(dvec2)>& visit)
{
    for (int y = 0; y <= 10; ++y)
        for (int x = 0; x <= 10; ++x) visit(0.1 * dvec2(x, y));
}

TEST(Upscale, AConstantStaysWhatItIs)
{
    const dvec3 grey(0.2, 0.5, 0.9);
    const UpscaleTexels t = texelsOf([&](double, double) { return grey; });
    overFractions([&](dvec2 at) {
        EXPECT_LT(glm::distance(optics64::edgeUpscaled(t, at), grey), 1e-15);
        EXPECT_LT(glm::distance(optics64::bilinearUpscaled(t, at), grey), 1e-15);
    });
}

TEST(Upscale, ALinearRampStaysOneInEveryDirection)
{
    for (int degrees = 0; degrees < 360; degrees += 7) {
        const double angle = degrees * std::numbers::pi / 180.0;
        for (const double step : {1e-4, 0.02, 0.2}) {
            const dvec2 slope = step * dvec2(std::cos(angle), std::sin(angle));
            const auto ramp = [&](double x, double y) {
                return dvec3(0.5, 0.4, 0.6) + (slope.x * x + slope.y * y) * dvec3(1.0, 0.5, -1.0);
            };
            const UpscaleTexels t = texelsOf(ramp);
            overFractions([&](dvec2 at) {
                EXPECT_LT(glm::distance(optics64::edgeUpscaled(t, at), ramp(at.x, at.y)), 1e-12)
                    << degrees << ' ' << step;
                EXPECT_LT(glm::distance(optics64::bilinearUpscaled(t, at), ramp(at.x, at.y)), 1e-12);
            });
        }
    }
}

TEST(Upscale, WeightsHaveASumToDivideByWhateverTheEdge)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < 100000; ++i) {
        const auto window =
            optics64::edgeWindow(dvec3(2.0 * unit(random) - 1.0, 2.0 * unit(random) - 1.0, 2.0 * unit(random)));
        EXPECT_NEAR(glm::length(window.across), 1.0, 1e-12);
        const dvec2 at(unit(random), unit(random));
        double sum = 0.0;
        for (const auto& place : places) sum += optics64::edgeWeight(window, dvec2(place[0], place[1]) - at);
        ASSERT_GT(sum, 0.8);
        ASSERT_LT(sum, 4.0);
    }
    const glm::dvec4 bilinear = optics64::bilinearWeights(dvec2(0.3, 0.8));
    EXPECT_NEAR(bilinear.x + bilinear.y + bilinear.z + bilinear.w, 1.0, 1e-15);
}

// 1 in the middle, nothing at its end, below 0 between; with a lobe of 1/4 Lanczos' of two lobes.
TEST(Upscale, TheWindowIsLikeLanczos)
{
    const auto flat = optics64::edgeWindow(dvec3(0.0));
    EXPECT_DOUBLE_EQ(optics64::edgeWeight(flat, dvec2(0.0)), 1.0);
    EXPECT_NEAR(optics64::edgeWeight(flat, dvec2(std::sqrt(2.0), 0.0)), 0.0, 1e-12);
    EXPECT_NEAR(optics64::edgeWeight(flat, dvec2(0.0, 3.0)), 0.0, 1e-12);
    EXPECT_NEAR(optics64::edgeWeight(flat, dvec2(1.0, 0.0)), 0.0, 1e-12);
    EXPECT_LT(optics64::edgeWeight(flat, dvec2(1.2, 0.0)), 0.0);
    const auto lanczos = [](double x) {
        const double a = std::numbers::pi * x, b = 0.5 * a;
        return x == 0.0 ? 1.0 : std::sin(a) / a * std::sin(b) / b;
    };
    auto wide = flat;
    wide.lobe = 0.25;
    for (double x = 0.0; x <= 2.2; x += 0.05)
        EXPECT_NEAR(optics64::edgeWeight(wide, dvec2(x, 0.0)), x < 2.0 ? lanczos(x) : 0.0, 0.06) << x;
}

// On a strong edge neighbours along it count, and those across it do not.
TEST(Upscale, TheWindowIsLongAlongAnEdge)
{
    const auto upright = optics64::edgeWindow(dvec3(1.0, 0.0, 2.0)); // gradient along x
    EXPECT_GT(optics64::edgeWeight(upright, dvec2(0.0, 1.0)), 0.4);
    EXPECT_LT(optics64::edgeWeight(upright, dvec2(1.0, 0.0)), 0.05);
    const auto diagonal = optics64::edgeWindow(dvec3(1.0, 1.0, 2.0));
    EXPECT_GT(optics64::edgeWeight(diagonal, dvec2(1.0, -1.0)), optics64::edgeWeight(diagonal, dvec2(1.0, 1.0)));
}

TEST(Upscale, NothingRings)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    int sharper = 0;
    for (int i = 0; i < 20000; ++i) {
        const UpscaleTexels t =
            texelsOf([&](double, double) { return dvec3(unit(random), unit(random), std::round(unit(random))); });
        const dvec3 darkest = glm::min(glm::min(t.c00, t.c10), glm::min(t.c01, t.c11));
        const dvec3 lightest = glm::max(glm::max(t.c00, t.c10), glm::max(t.c01, t.c11));
        const dvec2 at(unit(random), unit(random));
        const dvec3 is = optics64::edgeUpscaled(t, at);
        for (int c = 0; c < 3; ++c) {
            ASSERT_GE(is[c], darkest[c]);
            ASSERT_LE(is[c], lightest[c]);
        }
        if (glm::distance(is, optics64::bilinearUpscaled(t, at)) > 0.05) ++sharper;
    }
    EXPECT_GT(sharper, 10000); // else bilinear would pass
}

/// How far a filter's picture of a straight edge is from the edge itself, its mean over pixels of a quarter
/// of a texel.
double errorOfEdge(double degrees, bool followsEdges)
{
    const double angle = degrees * std::numbers::pi / 180.0;
    const dvec2 normal(std::cos(angle), std::sin(angle));
    // A texel is the mean over its area, as a picture with many samples has it.
    const auto mean = [&](dvec2 centre, double edge) {
        double sum = 0.0;
        constexpr int samples = 16;
        for (int y = 0; y < samples; ++y)
            for (int x = 0; x < samples; ++x) {
                const dvec2 in = (dvec2(x, y) + 0.5) / double(samples) - 0.5;
                sum += glm::dot(centre + edge * in - dvec2(0.4, 0.55), normal) > 0.0 ? 1.0 : 0.0;
            }
        return sum / (samples * samples);
    };
    const UpscaleTexels t = texelsOf([&](double x, double y) { return dvec3(mean(dvec2(x, y), 1.0)); });
    double sum = 0.0;
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) {
            const dvec2 at = (dvec2(x, y) + 0.5) / 4.0;
            const double is = (followsEdges ? optics64::edgeUpscaled(t, at) : optics64::bilinearUpscaled(t, at)).x;
            sum += std::abs(is - mean(at, 0.25));
        }
    return sum / 16.0;
}

TEST(Upscale, AStraightEdgeIsSharperThanBilinear)
{
    double edge = 0.0, bilinear = 0.0;
    for (double degrees = 0.0; degrees < 180.0; degrees += 5.0) {
        edge += errorOfEdge(degrees, true);
        bilinear += errorOfEdge(degrees, false);
    }
    EXPECT_LT(edge, 0.8 * bilinear);
}

TEST(Upscale, RadianceComesBackFromItsRange)
{
    for (const double value : {0.0, 1e-6, 0.3, 1.0, 40.0, 9000.0}) {
        const dvec3 colour(value, 0.5 * value, 0.1);
        const dvec3 compressed = optics64::compressedRadiance(colour);
        EXPECT_LT(std::max({compressed.x, compressed.y, compressed.z}), 1.0);
        EXPECT_LT(glm::distance(optics64::expandedRadiance(compressed), colour), 1e-9 * (1.0 + value));
    }
    EXPECT_TRUE(std::isfinite(optics64::expandedRadiance(dvec3(1.0)).x));
}

// Every texel counts once in all the pixels together.
TEST(AreaMean, OverlapsShareOutTheTexels)
{
    for (const double drawn : {33.0, 40.0, 47.0, 64.0}) {
        constexpr int size = 32;
        const double perPixel = drawn / size;
        std::vector<double> used(static_cast<std::size_t>(drawn), 0.0);
        for (int pixel = 0; pixel < size; ++pixel) {
            double sum = 0.0;
            for (std::size_t texel = 0; texel < used.size(); ++texel) {
                const double part =
                    optics64::overlap(pixel * perPixel, (pixel + 1) * perPixel, static_cast<double>(texel));
                used[texel] += part;
                sum += part;
            }
            EXPECT_NEAR(sum, perPixel, 1e-12);
        }
        for (const double part : used) EXPECT_NEAR(part, 1.0, 1e-12);
    }
}

TEST(Fxaa, WhatNoEyeSeesIsNoEdge)
{
    EXPECT_FALSE(optics64::fxaaIsEdge(0.5, 0.5));
    EXPECT_FALSE(optics64::fxaaIsEdge(0.0, 0.05)); // in the dark
    EXPECT_FALSE(optics64::fxaaIsEdge(0.9, 1.0));  // relative to the brighter
    EXPECT_TRUE(optics64::fxaaIsEdge(0.7, 1.0));
    EXPECT_TRUE(optics64::fxaaIsEdge(0.0, 0.1));
}

TEST(Fxaa, EdgesRunAcrossOrUp)
{
    const dvec3 dark(0.0), light(1.0), step(0.0, 1.0, 1.0);
    EXPECT_TRUE(optics64::fxaaRunsAcross(light, light, dark));
    EXPECT_TRUE(optics64::fxaaRunsAcross(light, dark, dark));
    EXPECT_FALSE(optics64::fxaaRunsAcross(step, step, step));
}

// At the end of a run the edge is half a texel off, in its middle it is where the pixels' border is.
TEST(Fxaa, TheShiftFallsAlongTheRun)
{
    EXPECT_DOUBLE_EQ(optics64::fxaaEdgeShift(0.0, 8.0, true), 0.5);
    EXPECT_DOUBLE_EQ(optics64::fxaaEdgeShift(2.0, 6.0, true), 0.25);
    EXPECT_DOUBLE_EQ(optics64::fxaaEdgeShift(4.0, 4.0, true), 0.0);
    EXPECT_DOUBLE_EQ(optics64::fxaaEdgeShift(6.0, 2.0, true), optics64::fxaaEdgeShift(2.0, 6.0, true));
    EXPECT_DOUBLE_EQ(optics64::fxaaEdgeShift(2.0, 6.0, false), 0.0); // the other side of the step
    EXPECT_TRUE(std::isfinite(optics64::fxaaEdgeShift(0.0, 0.0, true)));
}

TEST(Fxaa, ALonePixelIsTakenIntoItsNeighbours)
{
    EXPECT_DOUBLE_EQ(optics64::fxaaSubpixelShift(1.0, 0.0, 0.0, 1.0), optics64::fxaaSubpixelStrength);
    EXPECT_DOUBLE_EQ(optics64::fxaaSubpixelShift(0.5, 2.0, 2.0, 0.3), 0.0); // their mean already
    const double edge = optics64::fxaaSubpixelShift(1.0, 3.0, 2.0, 1.0); // a straight edge: a third of it is over there
    EXPECT_GT(edge, 0.0);
    EXPECT_LT(edge, 0.1);
    EXPECT_LT(optics64::fxaaSubpixelShift(0.4, 1.6, 1.6, 0.0), 1e-9);
}

} // namespace
} // namespace tarn
