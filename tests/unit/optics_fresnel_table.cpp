// The table of Fresnel's reflectance against the formula that it is made from.
#include "optics/fresnel_table.h"
#include "optics/optics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tarn {
namespace {

using optics::FresnelTable;
using optics::TableFilter;

struct TableError {
    double largest = 0.0, mean = 0.0;
};

/// Over cosines from 0 to 1, many to a texel and none at a place that a table would favour.
TableError errorOf(const FresnelTable& table, double n)
{
    const int count = std::max(40 * static_cast<int>(table.texels.size()), 100000) + 7;
    TableError error;
    for (int i = 0; i <= count; ++i) {
        const double cosine = static_cast<double>(i) / count;
        const double difference = std::abs(static_cast<double>(table.at(static_cast<float>(cosine)).y) -
                                           optics64::fresnelExact(cosine, 1.0 / n));
        error.largest = std::max(error.largest, difference);
        error.mean += difference / (count + 1);
    }
    return error;
}

/// Largest slope and curvature of the reflectance over the cosine, both at grazing incidence: its Taylor series there
/// is 1 - 2 (1 + n²) / √(n² - 1) c + 4 (1 + n⁴) / (n² - 1) c² - …
double steepest(double n) { return 2.0 * (1.0 + n * n) / std::sqrt(n * n - 1.0); }
double mostCurved(double n) { return 8.0 * (1.0 + n * n * n * n) / (n * n - 1.0); }

constexpr double rounding = 1.0e-6; // of single precision, where the formula is steep

TEST(FresnelTable, NearestTexelIsOffByHalfATexelOfTheSteepestSlope)
{
    for (const double n : {1.1, 1.33, 1.5, 2.4})
        for (int size = 16; size <= 4096; size *= 2) {
            const auto table = optics::makeFresnelTable(static_cast<float>(n), size, TableFilter::nearest);
            const double bound = 0.5 * steepest(n) / size;
            const double largest = errorOf(table, n).largest;
            EXPECT_LE(largest, bound + rounding) << n << ", " << size;
            if (size >= 128) {
                EXPECT_GE(largest, 0.85 * bound) << n << ", " << size;
            } // and no better than that
        }
}

TEST(FresnelTable, BlendedTexelsAreOffByTheCurvature)
{
    for (const double n : {1.1, 1.33, 1.5, 2.4})
        for (int size = 16; size <= 4096; size *= 2) {
            const auto table = optics::makeFresnelTable(static_cast<float>(n), size, TableFilter::linear);
            const double bound = 0.125 * mostCurved(n) / ((size - 1.0) * (size - 1.0));
            const double largest = errorOf(table, n).largest;
            EXPECT_LE(largest, bound + rounding) << n << ", " << size;
            if (size >= 128 && size <= 512) {
                EXPECT_GE(largest, 0.75 * bound) << n << ", " << size;
            }
        }
}

/// The figures of docs/methods/surface.md.
TEST(FresnelTable, ErrorsForWaterAreAsDocumented)
{
    struct Figure {
        int size;
        double nearestLargest, nearestMean, linearLargest, linearMean;
    };
    for (const Figure& f :
         {Figure{16, 0.178, 0.0153, 0.0188, 0.00233}, Figure{64, 0.0481, 0.00383, 0.00128, 1.33e-4},
          Figure{256, 0.0123, 9.58e-4, 8.14e-5, 8.09e-6}, Figure{1024, 0.00308, 2.39e-4, 5.1e-6, 5.0e-7},
          Figure{4096, 7.71e-4, 5.99e-5, 3.2e-7, 3.1e-8}}) {
        const TableError nearest = errorOf(optics::makeFresnelTable(1.33f, f.size, TableFilter::nearest), 1.33);
        const TableError linear = errorOf(optics::makeFresnelTable(1.33f, f.size, TableFilter::linear), 1.33);
        EXPECT_NEAR(nearest.largest, f.nearestLargest, 0.02 * f.nearestLargest) << f.size;
        EXPECT_NEAR(nearest.mean, f.nearestMean, 0.02 * f.nearestMean) << f.size;
        EXPECT_NEAR(linear.largest, f.linearLargest, 0.02 * f.linearLargest + rounding) << f.size;
        EXPECT_NEAR(linear.mean, f.linearMean, 0.02 * f.linearMean + rounding) << f.size;
    }
}

TEST(FresnelTable, WhatIsNotMirroredPasses)
{
    for (const TableFilter filter : {TableFilter::nearest, TableFilter::linear}) {
        const auto table = optics::makeFresnelTable(1.33f, 64, filter);
        for (float cosine = 0.0f; cosine <= 1.0f; cosine += 0.001f) {
            const vec2 shares = table.at(cosine);
            EXPECT_NEAR(shares.x + shares.y, 1.0f, 1e-6f) << cosine;
        }
        // Rounding and interpolated normals leave 0..1 a little.
        EXPECT_EQ(table.at(-0.01f), table.at(0.0f));
        EXPECT_EQ(table.at(1.01f), table.at(1.0f));
    }
}

TEST(FresnelTable, BlendedTexelsHoldTheEnds)
{
    const auto table = optics::makeFresnelTable(1.33f, 16, TableFilter::linear);
    EXPECT_EQ(table.at(0.0f).y, 1.0f);
    const double normal = 0.33 / 2.33;
    EXPECT_NEAR(table.at(1.0f).y, normal * normal, 1e-7);
}

TEST(FresnelTable, PlacesInFloatAreThoseInDouble)
{
    for (int i = 0; i <= 1000; ++i)
        for (const bool blends : {false, true}) {
            const double cosine = i / 1000.0;
            EXPECT_NEAR(static_cast<double>(optics::fresnelTableCoordinate(static_cast<float>(cosine), 1024, blends)),
                        optics64::fresnelTableCoordinate(cosine, 1024, blends), 1e-6);
        }
}

/// A texel's place is where its own cosine is looked up.
TEST(FresnelTable, TexelsAreFoundWhereTheyStand)
{
    for (const int size : {16, 255, 1024})
        for (const bool blends : {false, true})
            for (int i = 0; i < size; ++i)
                EXPECT_NEAR(
                    optics64::fresnelTableCoordinate(optics64::fresnelTableCosine(i, size, blends), size, blends),
                    (i + 0.5) / size, 1e-12);
}

} // namespace
} // namespace tarn
