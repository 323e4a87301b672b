// How far apart are the values of two pictures? RMSE, PSNR, the largest difference and where it is.
#pragma once

#include "scene/image.h"

namespace tarn {

/// Over the red, green and blue of all pixels. Floats are compared as they are, 8-bit values as stored, 0
/// to 1.
struct PictureError {
    double mean = 0.0; ///< of the absolute differences
    double rmse = 0.0;
    /// dB below 1: full scale, or the display's white for exposed radiance. Infinite for equal pictures. The
    /// peak is fixed, not the largest value of the two, with which one firefly in the test would improve the
    /// figure.
    double psnr = 0.0;
    double largest = 0.0;   ///< difference
    ivec2 largestAt{0};     ///< its pixel, from the top left
    int largestChannel = 0; ///< 0 red, 1 green, 2 blue
};

/// Throws Error when the sizes differ, when a picture has fewer than 3 channels, when one holds floats and
/// the other bytes, or when a value is NaN or infinite (naming file, pixel and channel).
PictureError pictureError(const Image& reference, const Image& test);

/// Throws Error naming both when their sizes differ, or the one that has fewer than 3 channels.
void requireComparable(const Image& reference, const Image& test);

/// Throws Error naming file, pixel and channel of the first value of red, green or blue that is NaN or
/// infinite.
void requireFinite(const Image& image);

} // namespace tarn
