// Looks for values that no target may hold.
#pragma once

#include "gl/target.h"
#include "render/frame.h"

#include <span>

namespace tarn {

/// Counts NaN, infinity and negative values in the colour channels of RGBA pixels.
BadPixels countBadPixels(std::string pass, std::span<const float> rgba);

/// Reads a target back (its samples resolved) and counts.
BadPixels checkTarget(std::string pass, const gl::Target& target);

} // namespace tarn
