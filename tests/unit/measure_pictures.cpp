// The judge of the picture tests is itself judged: what must pass passes, what must fail fails.
#include "base/error.h"
#include "measure/comparison_page.h"
#include "measure/image_compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace tarn {
namespace {

/// Fine texture in every direction, so that any change of place shows.
Image textured(int width, int height, unsigned seed = 1)
{
    Image image{"textured", width, height, 3, {}, {}};
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> value(20, 235);
    image.bytes.resize(image.size());
    for (auto& byte : image.bytes) byte = static_cast<std::uint8_t>(value(random));
    return image;
}

Image uniform(int width, int height, std::uint8_t value)
{
    Image image{"uniform", width, height, 3, {}, {}};
    image.bytes.assign(image.size(), value);
    return image;
}

/// Adds `amount` to the green of the first `count` pixels.
Image spoilt(Image image, int count, int amount)
{
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        auto& green = image.bytes[3 * i + 1];
        green = static_cast<std::uint8_t>(green + amount);
    }
    return image;
}

Image shiftedByOne(const Image& image)
{
    Image result = image;
    std::rotate(result.bytes.begin(), result.bytes.begin() + 3, result.bytes.end());
    return result;
}

TEST(PictureComparison, IdenticalPicturesAreTheSame)
{
    const PictureComparison result = comparePictures(textured(320, 240), textured(320, 240));
    EXPECT_TRUE(result.same());
    EXPECT_EQ(result.largest, 0);
    EXPECT_EQ(result.summary(), "identical");
}

TEST(PictureComparison, NoiseWithinTheChannelTolerancePasses)
{
    const Image golden = textured(320, 240);
    Image noisy = golden;
    std::mt19937 random(2);
    std::uniform_int_distribution<int> noise(-5, 5);
    for (auto& byte : noisy.bytes) byte = static_cast<std::uint8_t>(byte + noise(random));
    const PictureComparison result = comparePictures(golden, noisy);
    EXPECT_TRUE(result.same()) << result.summary();
    EXPECT_EQ(result.largest, 5);
    EXPECT_EQ(result.overChannel, 0u);
}

TEST(PictureComparison, OneMoreThanTheChannelToleranceEverywhereFails)
{
    // As much up as down: the mean stays.
    const auto rippled = [](int amplitude) {
        Image image = uniform(320, 240, 100);
        for (std::size_t i = 0; i < image.bytes.size(); ++i)
            image.bytes[i] = static_cast<std::uint8_t>(100 + (i / 3 % 2 == 0 ? amplitude : -amplitude));
        return image;
    };
    EXPECT_TRUE(comparePictures(uniform(320, 240, 100), rippled(5)).same());
    EXPECT_FALSE(comparePictures(uniform(320, 240, 100), rippled(6)).same());
}

// Within the tolerance of every pixel, and yet another light.
TEST(PictureComparison, ALittleDarkerEverywhereFails)
{
    const Image golden = textured(320, 240);
    const int pixels = 320 * 240;
    EXPECT_FALSE(comparePictures(golden, spoilt(golden, pixels, -1)).same());
    EXPECT_FALSE(comparePictures(golden, spoilt(golden, pixels / 3, -1)).same());
    const PictureComparison fifth = comparePictures(golden, spoilt(golden, pixels / 5, -1));
    EXPECT_TRUE(fifth.same()) << fifth.summary();
    EXPECT_NEAR(fifth.mean, -0.2, 1e-9);
    EXPECT_NE(fifth.summary().find("-0.200/255"), std::string::npos) << fifth.summary();
}

TEST(PictureComparison, ShiftByOnePixelFails)
{
    const Image golden = textured(320, 240);
    EXPECT_FALSE(comparePictures(golden, shiftedByOne(golden)).same());
}

TEST(PictureComparison, OneTenthOfAPercentOfThePixelsMayDiffer)
{
    const Image golden = uniform(320, 240, 100);
    EXPECT_TRUE(comparePictures(golden, spoilt(golden, 76, 30)).same());
    EXPECT_FALSE(comparePictures(golden, spoilt(golden, 77, 30)).same());
}

TEST(PictureComparison, AHandfulMayPassTheHardLimitAndNoMore)
{
    const Image golden = uniform(320, 240, 100);
    EXPECT_TRUE(comparePictures(golden, spoilt(golden, 8, 40)).same());
    EXPECT_TRUE(comparePictures(golden, spoilt(golden, 7, 41)).same());
    EXPECT_FALSE(comparePictures(golden, spoilt(golden, 8, 41)).same());
}

TEST(PictureComparison, InASmallPictureOneBadPixelFails)
{
    const Image golden = uniform(16, 16, 100);
    EXPECT_TRUE(comparePictures(golden, spoilt(golden, 1, 5)).same());
    EXPECT_FALSE(comparePictures(golden, spoilt(golden, 1, 6)).same());
}

TEST(PictureComparison, NamesTheWorstPixel)
{
    const Image golden = uniform(32, 16, 100);
    Image bad = golden;
    bad.bytes[3 * (5 * 32 + 7) + 2] = 250;
    const PictureComparison result = comparePictures(golden, bad);
    EXPECT_EQ(result.largest, 150);
    EXPECT_EQ(result.largestAt, ivec2(7, 5));
    EXPECT_NE(result.summary().find("150/255, at pixel 7,5"), std::string::npos) << result.summary();
}

TEST(PictureComparison, OtherSizesAndChannelsAreAMismatch)
{
    EXPECT_EQ(comparePictures(uniform(32, 16, 0), uniform(16, 32, 0)).mismatch,
              "expected a picture of 32x16 pixels, got 16x32");
    EXPECT_FALSE(comparePictures(uniform(32, 16, 0), uniform(16, 32, 0)).same());
    Image grey{"grey", 32, 16, 1, {}, {}};
    grey.bytes.resize(grey.size());
    EXPECT_EQ(comparePictures(uniform(32, 16, 0), grey).mismatch, "expected 3 channels, got 1");
}

TEST(PictureComparison, RefusesFloats)
{
    Image linear{"linear.exr", 1, 1, 3, {}, {0.5f, 0.5f, 0.5f}};
    EXPECT_THROW(comparePictures(uniform(1, 1, 0), linear), Error);
}

TEST(DifferencePicture, IsSixteenTimesTheDifferenceInBothDirections)
{
    Image golden = uniform(2, 1, 100), actual = golden;
    actual.bytes = {103, 100, 97, 100, 200, 100};
    EXPECT_EQ(differencePicture(golden, actual).bytes, (std::vector<std::uint8_t>{48, 0, 48, 0, 255, 0}));
    EXPECT_THROW(differencePicture(golden, uniform(1, 1, 0)), Error);
}

TEST(Base64, AsInRfc4648)
{
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64(std::string("\xff\xfe\x00", 3)), "//4A");
}

TEST(ComparisonPage, HoldsThePicturesAndNeedsNothingElse)
{
    const ComparisonEntry entry{"case-a",           "what it shows",       "3 pixels <differ>",
                                embeddedPng("foo"), embeddedPng("foobar"), std::nullopt};
    const std::string page = comparisonPage("1 & only", {entry});
    for (const char* wanted : {"base64,Zm9v\"", "base64,Zm9vYmFy\"", "no difference picture", "3 pixels &lt;differ&gt;",
                               "1 &amp; only", "class=\"flip\""})
        EXPECT_NE(page.find(wanted), std::string::npos) << wanted;
    for (const char* unwanted : {"http", "<script", "src=\"/", "<differ>"})
        EXPECT_EQ(page.find(unwanted), std::string::npos) << unwanted;
}

TEST(ComparisonPage, AMissingGoldenIsToldAndLeavesNothingToFlip)
{
    const std::string page =
        comparisonPage("t", {{"case-a", "", "no golden", std::nullopt, embeddedPng("foo"), std::nullopt}});
    EXPECT_NE(page.find("no expected picture"), std::string::npos);
    EXPECT_EQ(page.find("<figure class=\"flip\">"), std::string::npos);
}

TEST(ComparisonPage, PicturesMayBeFilesAndPassedCasesHaveNone)
{
    const std::string page =
        comparisonPage("t", {{"case-a", "", "differs", "pictures/1-expected.png", "pictures/1-actual.png", {}}},
                       {{"case-<b>", "identical"}});
    EXPECT_NE(page.find("src=\"pictures/1-expected.png\""), std::string::npos);
    EXPECT_NE(page.find("<li><strong>case-&lt;b&gt;</strong>: identical</li>"), std::string::npos);
}

} // namespace
} // namespace tarn
