// Builds every program that frames of a scene may ask for, so that none is built during a flight: frames of all sorts,
// drawn tiny, also make a driver finish what it leaves for the first draw.
#pragma once

#include "render/renderer.h"

#include <vector>

namespace tarn {

/// For the options and the water that the renderer has; debug views are left for when they are asked for.
/// @param water the renderer's
void warmUp(Renderer& renderer, const WaterBody& water, Progress* progress = nullptr);

/// One of the frames that this takes, for whoever wants to do something else between them.
struct WarmUpFrame {
    Options options;
    float height = 0.0f; ///< of the eye over the water's middle, m
};
std::vector<WarmUpFrame> warmUpFrames(const Options& options, const WaterBody& water);
/// The renderer is left with the frame's options.
void drawWarmUp(Renderer& renderer, const WarmUpFrame& frame, const WaterBody& water);

} // namespace tarn
