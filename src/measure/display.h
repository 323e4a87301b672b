// A linear picture as the display would show it: the present pass' arithmetic, for pictures that are read
// from files.
#pragma once

#include "plan/options.h"
#include "scene/image.h"

namespace tarn {

/// The first three channels of a float picture times the exposure, as floats.
Image exposedPicture(const Image& linear, float exposure);

/// An exposed picture through the tone curve, as 8-bit sRGB of 3 channels. There is no glow in it. Throws
/// Error when the picture does not hold floats of 3 or 4 channels.
Image displayPicture(const Image& exposed, FrameOptions::ToneCurve curve);

} // namespace tarn
