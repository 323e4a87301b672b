// What the shaders know of sun, sky, lamps and water in a frame: the uniform blocks' contents.
#pragma once

#include "optics/blocks.h"
#include "plan/options.h"
#include "scene/sky.h"

namespace tarn {

blocks::FrameBlock frameBlock(const Scene& scene, const WaterBody& water, const SkyModel& sky, const Options& options);

/// A frame's light without what moves: neither the moment nor the surface's grid changes what lies under the water or
/// stands over it.
blocks::FrameBlock lastingLight(const blocks::FrameBlock& light);

/// Whether what was drawn in one lasting light looks the same in the other.
bool sameLight(const blocks::FrameBlock& a, const blocks::FrameBlock& b);

/// The waves ready to evaluate, with their phases advanced to `time` so that the shader's t stays near zero:
/// a float that counts seconds would lose the phase of short waves within hours.
blocks::WavesBlock wavesBlock(const WaterBody& water, double time);

} // namespace tarn
