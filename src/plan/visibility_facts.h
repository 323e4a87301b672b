// What a frame's cameras may see of the scene, and by what light: facts that a plan goes by. Every answer errs towards
// seeing. render/gather_visibility.h finds them.
#pragma once

#include "base/math.h"

namespace tarn {

struct VisibilityFacts {
    bool mirrors = true;       ///< the mirrored camera may see something beside the sky
    bool seesBed = true;       ///< the refraction's camera may see something
    float leastDepth = 0.0f;   ///< m under the level of all that it may see; negative: over it
    vec3 bedReflectance{0.0f}; ///< of that: the largest BRDF, 1/sr, for light from anywhere
    vec3 bedEmission{0.0f};    ///< and the largest radiance of its own
    /// Something under water may be seen by the main, the refraction's or the mirrored camera.
    bool mainReceives = true, refractionReceives = true, reflectionReceives = true;

    vec3 sunBelow{0.0f};     ///< irradiance facing the refracted sun just under the surface
    vec3 skyBelow{0.0f};     ///< of the sky there
    vec3 deepRadiance{0.0f}; ///< of infinitely deep water

    bool waterWasHidden = false; ///< in the last frame the scene hid the water
};

} // namespace tarn
