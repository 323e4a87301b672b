// Mip levels of cut-out pictures keep their coverage and their colours.
#include "render/alpha_mips.h"

#include "base/error.h"
#include "temp_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <iterator>
#include <utility>

namespace tarn {
namespace {

Image cutOutPicture(int width, int height, const std::function<double(double, double)>& alphaAt)
{
    Image image{"leaf", width, height, 4, std::vector<std::uint8_t>(static_cast<std::size_t>(width * height * 4)), {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto i = static_cast<std::size_t>((y * width + x) * 4);
            const double alpha = alphaAt((x + 0.5) / width, (y + 0.5) / height);
            const bool isThere = alpha >= 0.5;
            // Green leaf; the ground it is cut from is magenta.
            image.bytes[i] = image.bytes[i + 2] = isThere ? 20 : 255;
            image.bytes[i + 1] = isThere ? 180 : 0;
            image.bytes[i + 3] = static_cast<std::uint8_t>(std::lround(255.0 * alpha));
        }
    }
    return image;
}

double thinStripes(double u, double) { return std::fmod(16.0 * u, 1.0) < 0.1875 ? 1.0 : 0.0; }

double blobs(double u, double v)
{
    const double wave = std::sin(37.0 * u + 5.0 * std::sin(11.0 * v)) * std::cos(29.0 * v + 3.0 * std::sin(17.0 * u));
    return std::clamp(0.5 + 2.0 * (wave - 0.3), 0.0, 1.0);
}

TEST(AlphaMips, ComeFromTheCacheAsTheyAreMade)
{
    const test::TempFolder folder;
    const DiskCache cache(folder.path(), 1 << 20);
    const auto bytesOf = [](const std::vector<Image>& levels) {
        std::vector<std::vector<std::uint8_t>> all;
        for (const Image& level : levels) all.push_back(level.bytes);
        return all;
    };
    const auto filesIn = [](const std::filesystem::path& path) {
        return std::distance(std::filesystem::directory_iterator(path), std::filesystem::directory_iterator());
    };
    Image image = cutOutPicture(48, 20, blobs);
    const CutOut cutOut{3, 0.5f, true};
    const auto made = bytesOf(cutOutMips(image, cutOut, CutOutLevels::covering));
    for (const char* when : {"missed", "found"}) {
        const std::vector<Image> levels = cutOutMips(image, cutOut, CutOutLevels::covering, cache);
        EXPECT_EQ(bytesOf(levels), made) << when;
        EXPECT_EQ(levels.front().width, 24) << when;
        EXPECT_EQ(filesIn(folder.path()), 1) << when;
    }
    // Everything that the levels depend on is in the key.
    EXPECT_NE(bytesOf(cutOutMips(image, cutOut, CutOutLevels::coverage, cache)), made);
    EXPECT_NE(bytesOf(cutOutMips(image, {3, 0.9f, true}, CutOutLevels::covering, cache)), made);
    image.bytes[5] ^= 0x80;
    EXPECT_EQ(bytesOf(cutOutMips(image, cutOut, CutOutLevels::covering, cache)),
              bytesOf(cutOutMips(image, cutOut, CutOutLevels::covering)));
    EXPECT_EQ(filesIn(folder.path()), 4);
    // Bytes that are whole, but not the levels of this picture: the cache was made by another program.
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) std::filesystem::remove(entry);
    image.bytes[5] ^= 0x80;
    EXPECT_EQ(bytesOf(cutOutMips(image, cutOut, CutOutLevels::covering, cache)), made);
}

TEST(AlphaMips, EachLevelCoversAsMuchAsThePicture)
{
    for (const auto& [width, height] : {std::pair{256, 256}, {100, 60}}) {
        const Image image = cutOutPicture(width, height, blobs);
        const CutOut cutOut;
        const double wanted = coverageOf(image, cutOut);
        ASSERT_GT(wanted, 0.1);
        ASSERT_LT(wanted, 0.5);
        for (const Image& level : cutOutMips(image, cutOut, CutOutLevels::covering)) {
            const double texel = 1.0 / (level.width * level.height);
            // Texels of one value come and go together.
            EXPECT_NEAR(coverageOf(level, cutOut), wanted, 0.01 + texel) << level.width << "x" << level.height;
        }
    }
}

// The mean alone loses thin stripes: this is what the scaling is for.
TEST(AlphaMips, PlainMeansWouldLoseThinThings)
{
    const Image image = cutOutPicture(256, 256, thinStripes);
    CutOut never;
    never.cutoff = 0.0f; // everything is there: no scaling
    const Image plain = cutOutMips(image, never, CutOutLevels::covering)[3];
    EXPECT_EQ(coverageOf(plain, CutOut{}), 0.0);
    EXPECT_GT(coverageOf(cutOutMips(image, CutOut{}, CutOutLevels::covering)[3], CutOut{}), 0.1);
}

TEST(AlphaMips, WhatIsCutAwayDoesNotColourTheRest)
{
    for (const Image& level : cutOutMips(cutOutPicture(128, 128, thinStripes), CutOut{}, CutOutLevels::covering)) {
        for (std::size_t i = 0; i < level.bytes.size(); i += 4) {
            if (level.bytes[i + 3] < 128) continue;
            EXPECT_NEAR(level.bytes[i], 20, 2);
            EXPECT_NEAR(level.bytes[i + 1], 180, 2);
        }
    }
}

TEST(AlphaMips, LevelsHalveDownToOneTexel)
{
    const std::vector<Image> levels = cutOutMips(cutOutPicture(100, 60, blobs), CutOut{}, CutOutLevels::covering);
    ASSERT_EQ(levels.size(), 6u);
    EXPECT_EQ(levels[0].width, 50);
    EXPECT_EQ(levels[1].height, 15);
    EXPECT_EQ(levels[2].height, 7);
    EXPECT_EQ(levels.back().width, 1);
    EXPECT_EQ(levels.back().height, 1);
    EXPECT_TRUE(cutOutMips(cutOutPicture(1, 1, blobs), CutOut{}, CutOutLevels::covering).empty());
}

TEST(AlphaMips, OpaqueAndEmptyPicturesStayWhatTheyAre)
{
    for (const double alpha : {0.0, 1.0})
        for (const Image& level :
             cutOutMips(cutOutPicture(64, 32, [=](double, double) { return alpha; }), CutOut{}, CutOutLevels::covering))
            EXPECT_EQ(coverageOf(level, CutOut{}), alpha);
}

TEST(AlphaMips, APictureWithoutAlphaIsRefused)
{
    Image image{"rock.jpg", 2, 2, 3, std::vector<std::uint8_t>(12), {}};
    EXPECT_THROW(cutOutMips(image, CutOut{}, CutOutLevels::covering), Error);
}

TEST(AlphaMips, SharesKeepTheirMeanAndStartAtTheCutoff)
{
    for (const auto& picture : {thinStripes, blobs}) {
        for (const double cutoff : {0.2, 0.5, 0.8}) {
            const Image image = cutOutPicture(256, 128, picture);
            CutOut cutOut;
            cutOut.cutoff = static_cast<float>(cutoff);
            const double wanted = coverageOf(image, cutOut);
            ASSERT_GT(wanted, 0.05);
            for (const Image& level : cutOutMips(image, cutOut, CutOutLevels::coverage)) {
                double sum = 0.0;
                for (std::size_t i = 3; i < level.bytes.size(); i += 4) sum += level.bytes[i] / 255.0;
                // Half a byte of rounding in each texel.
                EXPECT_NEAR(sum / (level.width * level.height), wanted, 0.5 / 255.0) << cutoff << ' ' << level.width;
            }
        }
    }
}

} // namespace
} // namespace tarn
