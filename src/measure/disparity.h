// How far a drawn pair's disparity is from the reference's: whether both eyes agree on where a thing in the water is.
//
//     const EyePoints left = pointsShown(used, camera, ShownBy::refraction);  // and right; and the same of the
//     reference const DisparityErrors errors = disparityErrors({left, right}, {trueLeft, trueRight}, water);
#pragma once

#include "measure/water_quantities.h"
#include "reference/picture.h"
#include "scene/image.h"

#include <array>
#include <limits>
#include <optional>

namespace tarn {

/// By which way the water shows a point.
enum class ShownBy { refraction, reflection };
inline constexpr std::array shownByNames{"refraction", "reflection"};

/// The points of the scene that the water shows in one eye's picture. Rows run from top to bottom, like Image.
struct EyePoints {
    Camera camera;
    ivec2 size{0};
    std::vector<vec3> points;          ///< world, m, of the ray through the pixel's centre
    std::vector<std::uint8_t> isKnown; ///< 0 where the pixel shows no water, or nothing of the scene in it
};

/// Drawn: the point whose colour was taken (of the refraction only where it is a valid sample).
EyePoints pointsShown(const WaterQuantities& used, const Camera& camera, ShownBy way);
/// True: what the refracted or the reflected ray meets first.
EyePoints pointsShown(const reference::Picture& truth, const Camera& camera, ShownBy way);

struct StereoPair {
    EyePoints left, right;
};

/// For each pixel of the left picture how far beside it, in pixels to the right and down, the right picture shows the
/// same point; nothing where either does not show it.
///
/// Between the right picture's pixels stand the triangles of the points they show; a partner lies within one, and no
/// further off its plane than half its shortest edge. Waves may show a point more than once: the partner is the one
/// nearest to where a flat surface would show it, and it is looked for within a sixteenth of the picture's width.
///
/// x is positive for what seems to be behind the plane of convergence.
std::vector<std::optional<vec2>> disparities(const StereoPair& pair, const WaterBody& water, ShownBy way);

/// NaN where there is nothing to measure.
struct DisparityErrors {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    std::size_t pixels = 0;                           ///< of the left picture in which both pairs show a point
    std::size_t compared = 0;                         ///< of these, in which both know a partner
    double median = none, p95 = none, maximum = none; ///< of the horizontal error's size, pixels
    double bias = none;                               ///< its mean with its sign, pixels
    double verticalMedian = none, verticalP95 = none; ///< of the vertical error's size, pixels
    double trueMedian = none;                         ///< the reference's own horizontal disparity, pixels
    double alone = none, aloneInTruth = none; ///< share of `pixels` without a partner: drawn, and in the reference
    Image map; ///< one float channel: the horizontal error's size, pixels; NaN where it is not known
};

/// Throws Error when the sizes of the four pictures differ.
DisparityErrors disparityErrors(const StereoPair& drawn, const StereoPair& truth, const WaterBody& water, ShownBy way);

} // namespace tarn
