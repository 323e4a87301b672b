#include "measure/image_compare.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace tarn {

namespace {

void requireBytes(const Image& image)
{
    if (image.isFloat() || image.bytes.size() != image.size())
        throw Error("{}: only 8-bit pictures are compared with goldens", image.name);
}

std::string mismatchOf(const Image& expected, const Image& actual)
{
    if (expected.width != actual.width || expected.height != actual.height)
        return fmt::format("expected a picture of {}x{} pixels, got {}x{}", expected.width, expected.height,
                           actual.width, actual.height);
    if (expected.channels != actual.channels)
        return fmt::format("expected {} channels, got {}", expected.channels, actual.channels);
    return {};
}

/// Pixels that a share allows, rounded down: none in a small picture.
std::size_t allowed(double fraction, std::size_t pixels)
{
    return static_cast<std::size_t>(fraction * static_cast<double>(pixels));
}

} // namespace

bool PictureComparison::same() const
{
    return mismatch.empty() && overChannel <= allowed(tolerance.fraction, pixels) &&
           overHardLimit <= allowed(tolerance.hardLimitFraction, pixels) && std::abs(mean) <= tolerance.mean;
}

std::string PictureComparison::summary() const
{
    if (!mismatch.empty()) return mismatch;
    if (largest == 0) return "identical";
    return fmt::format(
        "{} of {} pixels differ by more than {}/255 ({} may), {} by more than {}/255 ({} may); "
        "the largest difference is {}/255, at pixel {},{}; the mean one of a channel {:+.3f}/255 ({} may be)",
        overChannel, pixels, tolerance.channel, allowed(tolerance.fraction, pixels), overHardLimit, tolerance.hardLimit,
        allowed(tolerance.hardLimitFraction, pixels), largest, largestAt.x, largestAt.y, mean, tolerance.mean);
}

PictureComparison comparePictures(const Image& expected, const Image& actual, const PictureTolerance& tolerance)
{
    requireBytes(expected);
    requireBytes(actual);
    PictureComparison result;
    result.tolerance = tolerance;
    result.mismatch = mismatchOf(expected, actual);
    if (!result.mismatch.empty()) return result;

    const auto channels = static_cast<std::size_t>(expected.channels);
    const auto width = static_cast<std::size_t>(expected.width);
    result.pixels = width * static_cast<std::size_t>(expected.height);
    std::vector<long long> sums(channels);
    for (std::size_t pixel = 0; pixel < result.pixels; ++pixel) {
        for (std::size_t c = 0; c < channels; ++c)
            sums[c] += int{actual.bytes[pixel * channels + c]} - int{expected.bytes[pixel * channels + c]};
        int difference = 0;
        for (std::size_t i = pixel * channels; i < (pixel + 1) * channels; ++i)
            difference = std::max(difference, std::abs(int{expected.bytes[i]} - int{actual.bytes[i]}));
        result.overChannel += difference > tolerance.channel;
        result.overHardLimit += difference > tolerance.hardLimit;
        if (difference > result.largest) {
            result.largest = difference;
            result.largestAt = {static_cast<int>(pixel % width), static_cast<int>(pixel / width)};
        }
    }
    for (const long long sum : sums) {
        const double mean = static_cast<double>(sum) / static_cast<double>(std::max<std::size_t>(result.pixels, 1));
        if (std::abs(mean) > std::abs(result.mean)) result.mean = mean;
    }
    return result;
}

Image differencePicture(const Image& expected, const Image& actual, int gain)
{
    requireBytes(expected);
    requireBytes(actual);
    if (const std::string mismatch = mismatchOf(expected, actual); !mismatch.empty())
        throw Error("{}: {}", actual.name, mismatch);
    Image result = expected;
    result.name = "difference of " + actual.name;
    for (std::size_t i = 0; i < result.bytes.size(); ++i) {
        const int difference = std::abs(int{expected.bytes[i]} - int{actual.bytes[i]});
        result.bytes[i] = static_cast<std::uint8_t>(std::min(255, gain * difference));
    }
    return result;
}

} // namespace tarn
