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
    /// How far the middle of the picture lies to the right of the axis, as a tangent: the frustum is oblique, its
    /// planes of equal depth stay perpendicular to the axis. Not in scene files.
    float lensShift = 0.0f;
    bool operator==(const Camera&) const = default;
};

/// viewFromWorld of a camera (right-handed, looking along -z).
mat4 viewFromWorld(const Camera& camera);

/// clipFromView with both tangents scaled by `extension` (Mihálik 2008, section 5.2: the extended field of view) about
/// the picture's middle. What lies at the tangents t = x / -z has x / w = (t - lensShift) / (extension * tan).
/// @param aspect width / height of the picture
mat4 clipFromView(const Camera& camera, float aspect, float extension = 1.0f);

/// Of a frustum's matrix: what lies at normalised device coordinates n is seen at the tangents
/// (n * half + middle), x to the right and y up.
struct ViewTangents {
    vec2 half, middle;
    explicit ViewTangents(const mat4& clipFromView);
};

/// The camera moved by `offset` metres to its right, its axis as before, and its frustum sheared so that what lies
/// `convergence` metres along the axis keeps its place in the picture.
Camera movedAside(const Camera& camera, float offset, float convergence);

/// Six planes (xyz: inward normal, w: distance) of a clip volume, in the space that clipFromA maps from.
struct Frustum {
    vec4 planes[6];
    explicit Frustum(const mat4& clipFromA);
    /// False only when the box is certainly outside.
    bool intersects(const Bounds& box) const;
};

} // namespace tarn
