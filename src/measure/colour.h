// The colour spaces that an eye's model needs: sRGB's primaries, tristimulus values relative to white,
// CIELAB.
#pragma once

#include "base/math.h"

namespace tarn {

/// Tristimulus values relative to white, (X/Xn, Y/Yn, Z/Zn), of linear sRGB: white is (1,1,1) in both. From
/// the chromaticities of IEC 61966-2-1.
const mat3& relativeFromRgb();

/// The inverse of relativeFromRgb.
const mat3& rgbFromRelative();

/// CIELAB (ISO/CIE 11664-4) of tristimulus values relative to white: L* 0 to 100, a*, b*.
vec3 labFromRelative(const vec3& relative);

/// The inverse of labFromRelative.
vec3 relativeFromLab(const vec3& lab);

} // namespace tarn
