// A flight of the eye through a scene's cameras, for measurements and tests that need a moving view.
#pragma once

#include "scene/camera.h"

#include <vector>

namespace tarn {

/// Goes from the first camera past each to the last, an equal part of the flight from one to the next, slowly near
/// each. Between two, place and target move along straight lines, and the widths of their pictures blend.
/// @param cameras at least one   @param part of the flight, 0 to 1
Camera flightCamera(const std::vector<Camera>& cameras, double part);

} // namespace tarn
