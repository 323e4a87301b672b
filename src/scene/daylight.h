// The formulas of Preetham, Shirley & Smits 1999, "A Practical Analytic Model for Daylight". Private to
// src/scene.
#pragma once

#include "base/math.h"

#include <array>

namespace tarn::daylight {

/// The five coefficients of Perez' distribution for luminance Y and chromaticities x, y (appendix A.2).
std::array<std::array<float, 5>, 3> perezCoefficients(float turbidity);

/// Zenith luminance (kcd/m²) and chromaticities x, y (appendix A.2).
/// @param sunZenithAngle radians, at most π/2
vec3 zenith(float turbidity, float sunZenithAngle);

/// Perez et al. 1993, eq. 3 of Preetham: (1 + A e^(B/cosθ)) (1 + C e^(Dγ) + E cos²γ).
/// @param cosTheta of the direction to the zenith, > 0   @param gamma angle to the sun, radians
float perez(const std::array<float, 5>& c, float cosTheta, float gamma);

/// CIE xyY (Y in kcd/m²) as linear sRGB of the same luminance, without its negative parts.
vec3 rgbFromxyY(float x, float y, float Y);

/// Irradiance (klx) on a surface facing the sun, through the atmosphere (appendix A.1).
/// @param sinElevation of the sun; the disc sets between ±0.27°
vec3 sunIrradiance(float turbidity, float sinElevation);

/// 1 while the whole disc is above the horizon, 0 when none of it is.
float discAboveHorizon(float sinElevation);

/// How much of the daylight model's sunset sky is left, 1 for a sun on or above the horizon.
float twilight(float sinElevation);

} // namespace tarn::daylight
