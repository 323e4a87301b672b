// What the real-time water has wrong, held against the ray-traced reference of the same view.
#pragma once

#include "measure/error_figures.h"
#include "measure/water_quantities.h"
#include "reference/picture.h"

#include <array>
#include <functional>
#include <optional>

namespace tarn {

enum class ErrorKind { refraction, reflection, fresnel, path, caustics };

struct ErrorKindInfo {
    const char* name; ///< as on the command line
    const char* unit;
    double scale; ///< what a map shows in full colour unless it is told otherwise
    const char* doc;
};
inline constexpr std::array<ErrorKindInfo, 5> errorKinds{{
    {"refraction", "m", 0.5, "from the true hit to W or to the point whose picture is taken, whichever is farther"},
    {"reflection", "deg", 5.0, "between the direction to what is mirrored and the true one"},
    {"fresnel", "", 0.1, "of the reflectance"},
    {"path", "m", 0.5, "of the length in water"},
    {"caustics", "", 1.0, "of the sun's light on the bed, relative to that above the water"},
}};
inline const ErrorKindInfo& infoOf(ErrorKind kind) { return errorKinds[static_cast<std::size_t>(kind)]; }

/// The error of one pixel, in the kind's unit, or nothing where one of the two does not know: no water in both, no
/// refracted ray that meets the scene, bed outside the caustics texture.
///
/// Refraction takes the place W or the point A whose colour is shown for it, whichever is farther from the true hit: a
/// right place with the picture of another is as wrong as the reverse. It is known, and large, without a valid sample.
/// Reflection is seen from the reference's U. Caustics are those of the texture where the light of the true hit
/// crosses the level, mean of the channels; the shadow of one submerged thing on another is not in the texture.
std::optional<double> errorAt(ErrorKind kind, const WaterQuantities& used, const reference::Picture& truth,
                              std::size_t pixel);

/// All of the water's figures but the caustics'; those of the pictures (flip, rmse, psnr) stay NaN. Throws Error when
/// the sizes differ.
///
/// The percentiles of the refraction are of the pixels with a valid sample; a pixel without one counts as wrong in
/// both shares, and as invalid.
ErrorFigures errorFigures(const WaterQuantities& used, const reference::Picture& truth);

/// Pixels by which of the two shows water there.
struct WaterAgreement {
    std::size_t both = 0, onlyUsed = 0, onlyTruth = 0, neither = 0;
};
WaterAgreement waterAgreement(const WaterQuantities& used, const reference::Picture& truth);

/// The true irradiance that enters at a place (x and z) of the water's level along the refracted sun and lands on the
/// bed, in the units of CausticsMap::light; nothing where it is not known.
using TrueIrradiance = std::function<std::optional<vec3>(const vec2& plane)>;

/// Fills in the caustics' figures: over the texels that the frame takes for the whole of the light (not the border in
/// which they give way, nor what lies beside the water), each against the mean of samples² places in it. A texel with a
/// place that is not known is left out.
void addCausticsFigures(ErrorFigures& figures, const CausticsMap& used, const TrueIrradiance& truth, int samples = 4);

/// The caustics texture at a place of the level, between its texels; nothing where the frame does not rely on it.
std::optional<vec3> causticsAt(const CausticsMap& map, const vec2& plane);

} // namespace tarn
