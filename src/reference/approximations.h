// The approximations of the real-time frame, one by one, made inside the reference: for the error budget.
#pragma once

#include "base/math.h"

#include <vector>

namespace tarn::reference {

/// Everything off is the truth. Each is what the viewer does, at the viewer's parameters but with rays in place of
/// textures, so that only the named thing is approximate.
struct Approximations {
    float schlickExponent = 0.0f;    ///< > 0: Fresnel by Schlick
    double reflectionDistance = -1.0; ///< >= 0: the mirrored eye looks at U + cR (Mihálik 2008, eq. 6)
    double reflectionClip = -1.0;    ///< >= 0: what is mirrored begins this far under the level
    double refractionClip = -1.0;    ///< >= 0: what is refracted ends this far over the level
    glm::dvec3 eye{0.0};                 ///< of the camera; needed by the reflection lookup

    bool hasReflectionLookup() const { return reflectionDistance >= 0.0; }
};

} // namespace tarn::reference
