// Builds every program that frames of a scene may ask for, so that none is built during a flight: frames of all sorts,
// drawn tiny, also make a driver finish what it leaves for the first draw.
#pragma once

#include "render/renderer.h"

namespace tarn {

/// For the options and the water that the renderer has; debug views are left for when they are asked for.
/// @param water the renderer's
void warmUp(Renderer& renderer, const WaterBody& water, Progress* progress = nullptr);

} // namespace tarn
