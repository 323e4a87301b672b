// What the shaders know of sun, sky, lamps and water in a frame: the uniform blocks' contents.
#pragma once

#include "optics/blocks.h"
#include "plan/options.h"
#include "scene/sky.h"

namespace tarn {

blocks::FrameBlock frameBlock(const Scene& scene, const WaterBody& water, const SkyModel& sky,
                              const Options& options);

/// The waves ready to evaluate, with their phases advanced to `time` so that the shader's t stays near zero:
/// a float that counts seconds would lose the phase of short waves within hours.
blocks::WavesBlock wavesBlock(const WaterBody& water, double time);

} // namespace tarn
