// FLIP against its formulas worked out by hand, against its authors' own program, and against what an eye
// would say.
#include "base/error.h"
#include "measure/flip.h"

#include "temp_folder.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tarn {
namespace {

/// A grey picture from a function of the pixel.
template <typename Value> Image grey(int width, int height, const Value& value)
{
    Image image{"grey", width, height, 3, {}, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.bytes.insert(image.bytes.end(), 3, static_cast<std::uint8_t>(value(x, y)));
    return image;
}

Image uniform(std::uint8_t red, std::uint8_t green, std::uint8_t blue, int channels = 3)
{
    Image image{"uniform", 40, 30, channels, {}, {}};
    const std::array<std::uint8_t, 4> colour{red, green, blue, 17};
    for (std::size_t i = 0; i < image.size(); ++i)
        image.bytes.push_back(colour[i % static_cast<std::size_t>(channels)]);
    return image;
}

/// Ramps of different slopes in the three channels, with jumps where they wrap: edges, lines and colours.
Image patterned(int shift, int blue)
{
    Image image{"patterned", 96, 64, 3, {}, {}};
    for (int y = 0; y < image.height; ++y)
        for (int x = shift; x < image.width + shift; ++x)
            for (const int value : {5 * x, 7 * y + x, x * y / 8 + blue})
                image.bytes.push_back(static_cast<std::uint8_t>(value % 256));
    return image;
}

/// Lightness of a grey, from CIELAB's definition.
double lightness(int byte)
{
    const double linear = std::pow((byte / 255.0 + 0.055) / 1.055, 2.4); // not for the darkest greys
    return 116.0 * std::cbrt(linear) - 16.0;
}

/// The largest compressed distance, from CIELAB's well-known values of sRGB's green and blue.
double largestDistance()
{
    struct Lab {
        double l, a, b;
    } const green{87.735, -86.183, 83.179}, blue{32.297, 79.188, -107.860};
    const double a = 0.01 * green.l * green.a - 0.01 * blue.l * blue.a;
    const double b = 0.01 * green.l * green.b - 0.01 * blue.l * blue.b;
    return std::pow(green.l - blue.l + std::sqrt(a * a + b * b), 0.7);
}

float largest(const Image& map) { return *std::max_element(map.floats.begin(), map.floats.end()); }

float at(const Image& map, int x, int y) { return map.floats[static_cast<std::size_t>(y * map.width + x)]; }

TEST(Flip, TheDefaultViewerSits70CentimetresFromA4KDisplay) { EXPECT_NEAR(defaultPixelsPerDegree, 67.0206, 5e-5); }

TEST(Flip, IdenticalPicturesGiveZeroEverywhere)
{
    const Image map = flipMap(patterned(0, 0), patterned(0, 0));
    EXPECT_EQ(map.channels, 1);
    EXPECT_EQ(map.width, 96);
    EXPECT_EQ(map.height, 64);
    EXPECT_EQ(largest(map), 0.0f);
    EXPECT_EQ(meanOf(map), 0.0);
}

TEST(Flip, DoesNotAskWhichOfTheTwoIsTheReference)
{
    EXPECT_NEAR(meanFlip(patterned(0, 0), patterned(2, 30)), meanFlip(patterned(2, 30), patterned(0, 0)), 1e-9);
}

// Uniform pictures are not changed by filters of sum 1 and have no features: colour alone.
TEST(Flip, OfUniformGreysIsTheRemappedDifferenceOfLightness)
{
    const double knee = 0.4 * largestDistance();
    const double below = 0.95 / knee * std::pow(lightness(188) - lightness(128), 0.7);
    EXPECT_NEAR(meanFlip(uniform(128, 128, 128), uniform(188, 188, 188)), below, 1e-4);
    EXPECT_NEAR(below, 0.5117, 5e-4);
}

TEST(Flip, OfBlackAndWhiteIsNearlyTheLargest)
{
    const double distance = std::pow(100.0, 0.7), most = largestDistance();
    const double expected = 0.95 + 0.05 * (distance - 0.4 * most) / (most - 0.4 * most);
    EXPECT_NEAR(meanFlip(uniform(0, 0, 0), uniform(255, 255, 255)), expected, 1e-4);
    EXPECT_GT(expected, 0.967);
    EXPECT_LT(expected, 0.968);
}

TEST(Flip, OfGreenAndBlueIsTheLargestThereIs)
{
    EXPECT_NEAR(meanFlip(uniform(0, 255, 0), uniform(0, 0, 255)), 1.0, 1e-5);
}

// The authors' program (github.com/NVlabs/flip, version 1.6, C++) printed these means for these pictures. It
// has the matrix of sRGB with other digits behind the fourth.
TEST(Flip, AgreesWithItsAuthorsProgram)
{
    EXPECT_NEAR(meanFlip(patterned(0, 0), patterned(2, 0)), 0.228547, 2e-5);
    EXPECT_NEAR(meanFlip(patterned(0, 0), patterned(2, 0), 20.0), 0.224670, 2e-5);
    EXPECT_NEAR(meanFlip(patterned(0, 0), patterned(0, 40)), 0.370053, 2e-5);
    EXPECT_NEAR(meanFlip(patterned(0, 0), patterned(0, 40), 20.0), 0.387691, 2e-5);
}

TEST(Flip, StaysWithinZeroAndOne)
{
    const auto stripes = [](int x, int) { return x / 6 % 2 * 255; };
    const auto inverted = [](int x, int) { return 255 - x / 6 % 2 * 255; };
    for (const double pixelsPerDegree : {1.0, 10.0, 67.0, 1000.0}) {
        const Image map = flipMap(grey(60, 50, stripes), grey(60, 50, inverted), pixelsPerDegree);
        EXPECT_TRUE(std::all_of(map.floats.begin(), map.floats.end(), [](float value) {
            return value >= 0.0f && value <= 1.0f;
        })) << pixelsPerDegree;
    }
}

TEST(Flip, WhatTheEyeCannotResolveCountsLess)
{
    const Image flat = grey(64, 64, [](int, int) { return 128; });
    const Image checks = grey(64, 64, [](int x, int y) { return (x + y) % 2 ? 100 : 156; });
    const Image halves = grey(64, 64, [](int x, int) { return x < 32 ? 100 : 156; });
    EXPECT_LT(meanFlip(flat, checks), 0.4 * meanFlip(flat, halves));
}

TEST(Flip, AFinePatternIsSeenLessFromFartherAway)
{
    const Image flat = grey(96, 96, [](int, int) { return 128; });
    const Image checks = grey(96, 96, [](int x, int y) { return (x / 4 + y / 4) % 2 ? 100 : 156; });
    const double near = meanFlip(flat, checks, 20.0), usual = meanFlip(flat, checks),
                 far = meanFlip(flat, checks, 200.0);
    EXPECT_GT(near, usual);
    EXPECT_GT(usual, far);
}

// The difference grows to the same 20/255 on the right, over a wide ramp or at once.
TEST(Flip, ANewEdgeCostsMoreThanARampToTheSameDifference)
{
    const auto flat = grey(200, 40, [](int, int) { return 100; });
    const auto ramp = grey(200, 40, [](int x, int) { return 100 + std::clamp(x - 20, 0, 160) / 8; });
    const auto edge = grey(200, 40, [](int x, int) { return x < 100 ? 100 : 120; });
    const Image ofRamp = flipMap(flat, ramp), ofEdge = flipMap(flat, edge);
    EXPECT_NEAR(at(ofRamp, 195, 20), at(ofEdge, 195, 20), 1e-6);
    EXPECT_GT(largest(ofEdge), 1.2f * at(ofEdge, 195, 20));
    EXPECT_LT(largest(ofRamp), 1.1f * at(ofRamp, 195, 20));
}

TEST(Flip, AShiftedEdgeCostsMoreThanItsDifferenceWithoutAnEdge)
{
    const auto edgeAt = [](int place) { return grey(120, 40, [=](int x, int) { return x < place ? 80 : 120; }); };
    const float uniformError = largest(flipMap(uniform(80, 80, 80), uniform(120, 120, 120)));
    EXPECT_GT(largest(flipMap(edgeAt(56), edgeAt(64))), uniformError);
}

TEST(Flip, BordersAreContinuedNotDarkened)
{
    const Image map = flipMap(uniform(128, 128, 128), uniform(188, 188, 188));
    EXPECT_NEAR(at(map, 0, 0), at(map, 20, 15), 1e-6);
    EXPECT_NEAR(at(map, 39, 29), at(map, 20, 15), 1e-6);
}

// A strip boundary would show as a jump where the picture has none.
TEST(Flip, IsTheSameWhereverAPictureIsCutIntoStrips)
{
    const auto tall = [](int amount) { return grey(12, 301, [=](int x, int) { return 100 + amount * (x % 5); }); };
    const Image map = flipMap(tall(0), tall(20));
    for (int y = 1; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) ASSERT_EQ(at(map, x, y), at(map, x, 0)) << x << ',' << y;
}

TEST(Flip, IgnoresAlpha)
{
    EXPECT_EQ(meanFlip(uniform(10, 20, 30, 4), uniform(40, 20, 30)),
              meanFlip(uniform(10, 20, 30), uniform(40, 20, 30)));
}

TEST(Flip, OnePixelIsAPictureToo)
{
    Image black{"black", 1, 1, 3, {0, 0, 0}, {}}, white{"white", 1, 1, 3, {255, 255, 255}, {}};
    EXPECT_NEAR(meanFlip(black, white), 0.9674, 1e-3);
}

TEST(Flip, MeansOverMasks)
{
    const Image map{"map", 2, 2, 1, {}, {0.1f, 0.2f, 0.4f, 0.5f}};
    EXPECT_NEAR(meanOf(map), 0.3, 1e-7);
    EXPECT_NEAR(meanOver(map, std::vector<std::uint8_t>{0, 1, 255, 0}), 0.3, 1e-7);
    EXPECT_NEAR(meanOver(map, std::vector<std::uint8_t>{0, 0, 0, 1}), 0.5, 1e-7);
    EXPECT_TRUE(std::isnan(meanOver(map, std::vector<std::uint8_t>(4, 0))));
    EXPECT_THROW(meanOver(map, std::vector<std::uint8_t>(3, 1)), Error);
    EXPECT_THROW(meanOf(uniform(0, 0, 0)), Error);
}

TEST(Flip, TellsWhatItCannotCompare)
{
    const auto complaint = [](const Image& a, const Image& b, double pixelsPerDegree = defaultPixelsPerDegree) {
        return test::messageOf<Error>([&] { flipMap(a, b, pixelsPerDegree); });
    };
    Image small = grey(8, 8, [](int, int) { return 0; });
    small.name = "small.png";
    EXPECT_CONTAINS(complaint(uniform(0, 0, 0), small), "small.png: has 8x8 pixels, and uniform has 40x30");
    EXPECT_CONTAINS(complaint(uniform(0, 0, 0, 1), uniform(0, 0, 0)), "has 1 channel;");
    const Image floats{"floats", 40, 30, 3, {}, std::vector<float>(3600, 0.5f)};
    EXPECT_CONTAINS(complaint(uniform(0, 0, 0), floats), "floats: FLIP compares 8-bit");
    for (const double wrong : {0.0, -1.0, 0.5, 1001.0, std::nan("")})
        EXPECT_CONTAINS(complaint(small, small, wrong), "pixels per degree");
}

} // namespace
} // namespace tarn
