#include "scene/camera.h"

#include <cmath>

namespace tarn {

mat4 viewFromWorld(const Camera& camera)
{
    vec3 up = camera.up;
    const vec3 forward = camera.target - camera.eye;
    // Looking straight along `up` leaves the roll open; any sideways axis will do then. Scene files cannot
    // ask for it, but a camera that is moved by hand can pass through it.
    if (glm::length(glm::cross(forward, up)) <= 1e-6f * glm::length(forward) * glm::length(up))
        up = std::abs(forward.z) < 0.9f * glm::length(forward) ? vec3(0.0f, 0.0f, -1.0f) : vec3(1.0f, 0.0f, 0.0f);
    return glm::lookAtRH(camera.eye, camera.target, up);
}

mat4 clipFromView(const Camera& camera, float aspect, float extension)
{
    const float top = camera.nearPlane * std::tan(0.5f * camera.verticalFov) * extension;
    const float right = top * aspect, middle = camera.nearPlane * camera.lensShift;
    return glm::frustumRH_NO(middle - right, middle + right, -top, top, camera.nearPlane, camera.farPlane);
}

ViewTangents::ViewTangents(const mat4& clipFromView)
    : half(1.0f / clipFromView[0][0], 1.0f / clipFromView[1][1]),
      middle(clipFromView[2][0] / clipFromView[0][0], clipFromView[2][1] / clipFromView[1][1])
{}

Camera movedAside(const Camera& camera, float offset, float convergence)
{
    const mat4 view = viewFromWorld(camera);
    const vec3 right(view[0][0], view[1][0], view[2][0]);
    Camera moved = camera;
    moved.eye += offset * right;
    moved.target += offset * right;
    moved.lensShift -= offset / convergence;
    return moved;
}

// Gribb & Hartmann 2001: the planes are sums and differences of the matrix' rows.
Frustum::Frustum(const mat4& clipFromA)
{
    const mat4 rows = glm::transpose(clipFromA);
    for (int axis = 0; axis < 3; ++axis) {
        planes[2 * axis] = rows[3] + rows[axis];
        planes[2 * axis + 1] = rows[3] - rows[axis];
    }
    for (vec4& plane : planes) {
        const float length = glm::length(vec3(plane));
        if (length > 0.0f) plane /= length; // an infinite far plane has no normal, and cuts nothing
    }
}

bool Frustum::intersects(const Bounds& box) const
{
    if (box.empty()) return false;
    const vec3 centre = box.centre(), half = 0.5f * box.extent();
    for (const vec4& plane : planes) {
        const vec3 normal(plane);
        if (glm::dot(normal, centre) + plane.w + glm::dot(glm::abs(normal), half) < 0.0f) return false;
    }
    return true;
}

} // namespace tarn
