// A pinhole camera, and the matrices of the moved cameras that the passes need.
#pragma once

#include "base/math.h"

#include <string>

namespace tarn {

/// A view. Positions and directions in world space, metres; y is up.
struct Camera {
    std::string name;
    vec3 eye{0.0f, 2.0f, 10.0f};
    vec3 target{0.0f};
    vec3 up{0.0f, 1.0f, 0.0f};
    float verticalFov = 0.87f; ///< radians (degrees in files)
    float nearPlane = 0.1f;
    float farPlane = 1000.0f;
};

/// viewFromWorld of a camera (right-handed, looking along -z).
mat4 viewFromWorld(const Camera& camera);

/// clipFromView with both tangents scaled by `extension` (Mihálik 2008, section 5.2: the extended field of view).
/// @param aspect width / height of the picture
mat4 clipFromView(const Camera& camera, float aspect, float extension = 1.0f);

/// Six planes (xyz: inward normal, w: distance) of a clip volume, in the space that clipFromA maps from.
struct Frustum {
    vec4 planes[6];
    explicit Frustum(const mat4& clipFromA);
    /// False only when the box is certainly outside.
    bool intersects(const Bounds& box) const;
};

} // namespace tarn
