// Errors as colours: black where there is none, through purple and orange to a pale yellow.
#pragma once

#include "base/math.h"
#include "scene/image.h"

namespace tarn {

/// sRGB colour, 0 to 1, of x in 0 to 1 (beyond them that of the nearer end). Its CIELAB lightness is 98 x
/// but for rounding and a gamut's edge, so that equal steps of error look equal, in print without colours
/// too. NaN is grey: nothing was measured.
vec3 heatColour(double x);

/// An 8-bit picture of 3 channels in which `lower` is black and `upper` the brightest. Throws Error when the
/// picture is not one float channel, or `lower` is not below `upper`.
Image heatPicture(const Image& oneChannel, double lower, double upper);

} // namespace tarn
