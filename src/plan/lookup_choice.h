// How a frame finds what the water shows where the method is auto: through a map of heights or in a target's depth.
#pragma once

#include "plan/depth_complexity.h"
#include "plan/options.h"

#include <string>

namespace tarn {

struct LookupChoice {
    bool map = false;   ///< rays are marched through a map of heights
    bool target = true; ///< and looked for in a target; one of the two at least
    std::string why;    ///< of auto, in words; empty where the method was named
};

/// auto marches rays through the bed's heights, and asks the target too where the map cannot hold the bed or shows it
/// more coarsely than the picture does where the water is nearest.
/// @param size of the picture, pixels   @param complexity null: not known, and no map is relied on
/// @param given the bed's map where it is not drawn; else null
LookupChoice chooseRefraction(const Options& options, const WaterBody& water, const Camera& camera, ivec2 size,
                              const DepthComplexity* complexity, const HeightMapPicture* given = nullptr);

/// auto marches mirrored rays where no two things stand one over the other; both together cost several times either.
LookupChoice chooseReflection(const Options& options, const DepthComplexity* complexity);

/// Whether a choice will ask for the complexity.
bool wantsDepthComplexity(const Options& options);

} // namespace tarn
