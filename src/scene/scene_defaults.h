// What a scene gets that its file does not say: cameras and water from its bounds. Private to src/scene.
#pragma once

#include "scene/scene.h"

namespace tarn {

/// "overview", "side" and "top", each with all of the box in view.
std::vector<Camera> camerasAround(const Bounds& bounds);

/// A body of water that covers the box, with a few waves that fit its size.
WaterBody waterAcross(const Bounds& bounds, float level);

/// The level that a scene without one gets, a quarter up its height; nothing for a flat scene.
std::optional<float> levelWithin(const Bounds& bounds);

} // namespace tarn
