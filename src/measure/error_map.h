// Where a picture is wrong: one error for each pixel, and its colours.
#pragma once

#include "measure/water_errors.h"
#include "scene/image.h"

namespace tarn
{

/// One channel of floats, in the kind's unit; NaN where errorAt knows nothing. Throws Error when the sizes
/// differ.
Image errorMap(ErrorKind kind, const WaterQuantities& used, const reference::Picture& truth);

/// 8-bit sRGB: black where there is no error, through to white at `scale` and over; grey where nothing is known.
Image heatPicture(const Image& map, double scale);

} // namespace tarn
