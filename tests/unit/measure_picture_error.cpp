// Differences of values against sums done by hand, and the pictures made for people: heat, and display.
#include "base/error.h"
#include "measure/colour.h"
#include "measure/display.h"
#include "measure/heat.h"
#include "measure/picture_error.h"

#include "temp_folder.h"

#include <cmath>
#include <limits>

namespace tarn {
namespace {

Image floats(std::vector<float> values, int channels = 3)
{
    Image image{"floats.exr", static_cast<int>(values.size()) / channels, 1, channels, {}, std::move(values)};
    return image;
}

TEST(PictureError, OfFloatsAsTheyAre)
{
    // Two pixels of three channels, differences 0, 1, -2, 0, 0, 3.
    const PictureError error = pictureError(floats({1, 1, 5, 7, 7, 7}), floats({1, 2, 3, 7, 7, 10}));
    EXPECT_NEAR(error.mean, 6.0 / 6.0, 1e-12);
    EXPECT_NEAR(error.rmse, std::sqrt(14.0 / 6.0), 1e-6);
    EXPECT_NEAR(error.psnr, -10.0 * std::log10(14.0 / 6.0), 1e-6);
    EXPECT_NEAR(error.largest, 3.0, 1e-12);
    EXPECT_EQ(error.largestAt, ivec2(1, 0));
    EXPECT_EQ(error.largestChannel, 2);
}

TEST(PictureError, OfBytesInFullScales)
{
    Image black{"black", 3, 2, 3, std::vector<std::uint8_t>(18, 0), {}}, other = black;
    other.bytes[3 * 4 + 1] = 51; // pixel 1,1, green
    const PictureError error = pictureError(black, other);
    EXPECT_NEAR(error.largest, 0.2, 1e-6);
    EXPECT_EQ(error.largestAt, ivec2(1, 1));
    EXPECT_EQ(error.largestChannel, 1);
    EXPECT_NEAR(error.rmse, 0.2 / std::sqrt(18.0), 1e-6);
}

TEST(PictureError, IsNoneOfEqualPictures)
{
    const PictureError error = pictureError(floats({1, 2, 3}), floats({1, 2, 3}));
    EXPECT_EQ(error.rmse, 0.0);
    EXPECT_EQ(error.largest, 0.0);
    EXPECT_EQ(error.psnr, std::numeric_limits<double>::infinity());
}

TEST(PictureError, LooksAtColourOnly)
{
    const PictureError error = pictureError(floats({1, 2, 3, 0.5f}, 4), floats({1, 2, 3}));
    EXPECT_EQ(error.largest, 0.0);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(pictureError(floats({1, 2, 3, nan}, 4), floats({1, 2, 3})).largest, 0.0);
}

// The peak of PSNR is 1, whatever the brightest value: a firefly makes it worse.
TEST(PictureError, AFireflyDoesNotImprovePsnr)
{
    const double calm = pictureError(floats({0.1f, 0.1f, 0.1f}), floats({0.2f, 0.1f, 0.1f})).psnr;
    EXPECT_LT(pictureError(floats({0.1f, 0.1f, 0.1f}), floats({0.2f, 0.1f, 900.0f})).psnr, calm - 60.0);
}

TEST(PictureError, NamesTheFileAndPixelOfNanAndInfinity)
{
    Image bad{"bad.exr", 2, 2, 3, {}, std::vector<float>(12, 1.0f)}, good = bad;
    bad.floats[3 * 2 + 1] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_CONTAINS(test::messageOf<Error>([&] { pictureError(good, bad); }), "bad.exr: the green of pixel 0,1 is NaN");
    bad.floats[3 * 1 + 2] = -std::numeric_limits<float>::infinity();
    EXPECT_CONTAINS(test::messageOf<Error>([&] { pictureError(bad, good); }),
                    "bad.exr: the blue of pixel 1,0 is infinite");
}

TEST(PictureError, TellsWhatItCannotCompare)
{
    const Image bytes{"bytes.png", 1, 1, 3, {1, 2, 3}, {}};
    EXPECT_CONTAINS(test::messageOf<Error>([&] {
                        pictureError(bytes, floats({1, 2, 3}));
                    }),
                    "bytes.png holds bytes and floats.exr floats");
    EXPECT_CONTAINS(test::messageOf<Error>([&] {
                        pictureError(floats({1, 2, 3}), floats({1}, 1));
                    }),
                    "has 1 channel; pictures of red, green and blue");
    EXPECT_CONTAINS(test::messageOf<Error>([&] {
                        pictureError(floats({1, 2, 3}), floats({1, 2, 3, 4, 5, 6}));
                    }),
                    "has 2x1 pixels, and floats.exr has 1x1");
}

TEST(HeatPicture, LightnessFollowsTheError)
{
    EXPECT_EQ(heatColour(0.0), vec3(0.0f));
    for (int i = 0; i <= 100; ++i) {
        const vec3 encoded = heatColour(i / 100.0);
        const vec3 linear(srgbDecode(encoded.x), srgbDecode(encoded.y), srgbDecode(encoded.z));
        EXPECT_NEAR(labFromRelative(relativeFromRgb() * linear).x, 0.98 * i, 1.5) << i;
    }
}

TEST(HeatPicture, BeyondItsEndsStandTheEnds)
{
    EXPECT_EQ(heatColour(-3.0), heatColour(0.0));
    EXPECT_EQ(heatColour(7.0), heatColour(1.0));
    const vec3 unmeasured = heatColour(std::nan(""));
    EXPECT_EQ(unmeasured, vec3(unmeasured.x)); // grey, which is nowhere on the way
}

TEST(HeatPicture, SpansTheGivenRange)
{
    const Image picture = heatPicture(floats({2.0f, 3.0f, 4.0f}, 1), 2.0, 4.0);
    ASSERT_EQ(picture.bytes.size(), 9u);
    EXPECT_EQ(picture.channels, 3);
    for (const auto& [pixel, x] : {std::pair(0, 0.0), std::pair(1, 0.5), std::pair(2, 1.0)})
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(picture.bytes[static_cast<std::size_t>(3 * pixel + i)], 255.0f * heatColour(x)[i], 0.51f);
    EXPECT_THROW(heatPicture(floats({1, 2, 3}), 0.0, 1.0), Error);
    EXPECT_THROW(heatPicture(floats({1}, 1), 1.0, 1.0), Error);
}

TEST(Colour, LabOfThePrimariesIsAsPublished)
{
    const auto lab = [](float r, float g, float b) { return labFromRelative(relativeFromRgb() * vec3(r, g, b)); };
    const auto near = [](const vec3& a, const vec3& b) { return glm::length(a - b) < 0.02f; };
    EXPECT_TRUE(near(lab(1, 1, 1), {100.0f, 0.0f, 0.0f}));
    EXPECT_TRUE(near(lab(0, 1, 0), {87.735f, -86.183f, 83.179f}));
    EXPECT_TRUE(near(lab(0, 0, 1), {32.297f, 79.188f, -107.860f}));
    for (const vec3& c : {vec3(0.001f, 0.002f, 0.003f), vec3(0.2f, 0.5f, 0.9f)})
        EXPECT_LT(glm::length(rgbFromRelative() * relativeFromLab(lab(c.x, c.y, c.z)) - c), 1e-5f);
}

TEST(DisplayPicture, ExposesMapsAndEncodes)
{
    const Image exposed = exposedPicture(floats({0.25f, 1.0f, 9.0f, 0.5f}, 4), 0.5f);
    EXPECT_EQ(exposed.channels, 3);
    EXPECT_EQ(exposed.floats, (std::vector<float>{0.125f, 0.5f, 4.5f}));
    using Curve = FrameOptions::ToneCurve;
    // sRGB of 0.125, 0.5 and 1; then of x/(1+x).
    EXPECT_EQ(displayPicture(exposed, Curve::linear).bytes, (std::vector<std::uint8_t>{99, 188, 255}));
    EXPECT_EQ(displayPicture(exposed, Curve::reinhard).bytes, (std::vector<std::uint8_t>{94, 156, 233}));
    EXPECT_NE(displayPicture(exposed, Curve::aces).bytes, displayPicture(exposed, Curve::reinhard).bytes);
    EXPECT_THROW(displayPicture(Image{"bytes", 1, 1, 3, {1, 2, 3}, {}}, Curve::aces), Error);
    EXPECT_THROW(exposedPicture(floats({1}, 1), 1.0f), Error);
}

} // namespace
} // namespace tarn
