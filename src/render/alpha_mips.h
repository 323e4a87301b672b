// Mip levels of cut-out pictures (leaves, reeds), which keep as much of themselves as they get small.
#pragma once

#include "base/disk_cache.h"
#include "scene/image.h"

#include <vector>

namespace tarn {

/// Where a picture says what of a surface is there.
struct CutOut {
    int channel = 3;     ///< that holds alpha: 3 of a colour map, 0 of an alpha map
    float cutoff = 0.5f; ///< in 0..1; what is less is not there
    bool isSrgb = true;  ///< colours are encoded; alpha never is
};

/// What alpha means below the picture itself.
enum class CutOutLevels {
    /// For one test against the cutoff. Averaged alpha crosses it elsewhere than the shape it stands for: thin things
    /// vanish with the distance. So alpha is scaled, level by level, until as large a share of the texels is over the
    /// cutoff as in the picture (Castaño 2010, "Computing alpha mipmaps").
    covering,
    /// The share of each texel that is there, 0 to 1: for tests against many limits.
    coverage,
};

/// The levels below the picture itself, the largest first, the last of 1 x 1: each half as wide and high as the one
/// before, rounded down. Colours are means weighted by alpha, so that what is cut away does not bleed in.
///
/// Needs bytes; throws Error for a picture of floats or without the channel. Works on every core.
std::vector<Image> cutOutMips(const Image& image, const CutOut& cutOut, CutOutLevels levels);

/// The same; what the cache has for the same picture and cut-out is taken from there, and what it has not is added.
std::vector<Image> cutOutMips(const Image& image, const CutOut& cutOut, CutOutLevels levels, const DiskCache& cache);

/// Share of the texels that are there, 0 to 1.
double coverageOf(const Image& image, const CutOut& cutOut);

} // namespace tarn
