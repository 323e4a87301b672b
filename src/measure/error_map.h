// Where a picture is wrong: one error for each pixel, as a map.
#pragma once

#include "measure/water_errors.h"
#include "scene/image.h"

namespace tarn {

/// One channel of floats, in the kind's unit; NaN where errorAt knows nothing. Throws Error when the sizes
/// differ.
Image errorMap(ErrorKind kind, const WaterQuantities& used, const reference::Picture& truth);

} // namespace tarn
