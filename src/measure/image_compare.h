// Is this the same picture? For goldens: "did it change?", not "is it right?".
//
//     const PictureComparison result = comparePictures(golden, rendered, {});
//     if (!result.same()) log::error("{}", result.summary());
#pragma once

#include "scene/image.h"

#include <cstddef>
#include <string>

namespace tarn {

/// What may differ between two renderings of one case by different builds of a software rasteriser.
struct PictureTolerance {
    /// Largest difference of a channel, of 255, that rounding makes.
    int channel = 5;
    /// Share of the pixels that may differ by more: a sample on a silhouette falls to the other side.
    double fraction = 0.001;
    /// A difference that only such a silhouette makes where one multisample of four has flipped between light
    /// and dark (a quarter of 160).
    int hardLimit = 40;
    /// Share of the pixels that may pass even that: 7 of 320x240. Silhouettes in views without multisampling
    /// flip whole pixels, one here and there; a patch as small as 3x3 pixels that is wrong is not forgiven.
    double hardLimitFraction = 0.0001;
    /// Signed mean difference of a channel over the picture, of 255: rounding goes both ways, a light that is wrong by
    /// a few per cent does not, and under the tone curve it stays within `channel`.
    double mean = 0.25;
};

struct PictureComparison {
    std::string mismatch; ///< why the pictures cannot be compared ("expected 320x240, got 16x16"), or ""
    PictureTolerance tolerance;
    std::size_t pixels = 0;
    std::size_t overChannel = 0;   ///< pixels with a channel that differs by more than tolerance.channel
    std::size_t overHardLimit = 0; ///< by more than tolerance.hardLimit
    int largest = 0;               ///< difference of any channel, of 255
    ivec2 largestAt{0};            ///< its pixel, from the top left
    double mean = 0.0; ///< actual less expected, of 255, of the channel whose mean difference is the largest

    bool same() const;
    /// One line for a person: what differs, how much, and where.
    std::string summary() const;
};

/// Compares 8-bit pictures. Sizes or channels that differ are a mismatch. Throws Error when one holds floats.
PictureComparison comparePictures(const Image& expected, const Image& actual, const PictureTolerance& tolerance = {});

/// |expected - actual| · gain, clamped to 255, so that small differences are seen. Throws Error when the
/// pictures cannot be compared.
Image differencePicture(const Image& expected, const Image& actual, int gain = 16);

} // namespace tarn
