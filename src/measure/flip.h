// How different do two pictures look to a person who flips between them?
//
// LDR-FLIP of Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström and Fairchild, "FLIP: A Difference
// Evaluator for Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020. Written from the
// paper's formulas.
//
//     const Image map = flipMap(reference, test); // one float a pixel: 0 looks the same, 1 as different as
//     can be const double error = meanOf(map);
#pragma once

#include "scene/image.h"

#include <cstdint>
#include <numbers>
#include <span>

namespace tarn {

/// The paper's viewer: 0.7 m from a display 0.7 m and 3840 pixels wide. A degree is then 67.02 pixels.
inline constexpr double defaultPixelsPerDegree = 0.7 * (3840.0 / 0.7) * (std::numbers::pi / 180.0);

/// Where the model holds, and its filters fit a picture: a degree of one pixel to one of a thousand.
inline constexpr double leastPixelsPerDegree = 1.0, mostPixelsPerDegree = 1000.0;

/// FLIP of each pixel, 0 to 1, as a picture of one float channel. Pictures hold 8-bit sRGB of 3 or 4
/// channels, alpha is ignored. Throws Error when they hold anything else, when their sizes differ, or when
/// pixelsPerDegree is outside leastPixelsPerDegree … mostPixelsPerDegree.
Image flipMap(const Image& reference, const Image& test, double pixelsPerDegree = defaultPixelsPerDegree);

/// The mean of flipMap. Throws as it does.
double meanFlip(const Image& reference, const Image& test, double pixelsPerDegree = defaultPixelsPerDegree);

/// The mean of a picture of one float channel. Throws Error when it is none.
double meanOf(const Image& map);

/// The mean over the pixels where the mask, one value a pixel from the top left, is not 0; NaN where it is 0
/// everywhere. Throws Error when the mask is not as large as the picture.
double meanOver(const Image& map, std::span<const std::uint8_t> mask);

} // namespace tarn
