#include "optics/refraction_camera.h"

#include "optics/optics.h"

#include <algorithm>
#include <cmath>

namespace tarn::optics {

namespace {

using glm::dvec3;

/// v turned about a unit axis (Rodrigues' formula).
dvec3 turned(const dvec3& v, const dvec3& axis, double angle)
{
    const double c = std::cos(angle);
    return v * c + glm::cross(axis, v) * std::sin(angle) + axis * (glm::dot(axis, v) * (1.0 - c));
}

} // namespace

// In double: O can lie far away, and the eye is moved by a difference of positions that do.
RefractionCamera refractionCamera(const vec3& eye, const vec3& forward, const vec3& up, float verticalFov, float level,
                                  float ior)
{
    const dvec3 eyeW(eye);
    const dvec3 forwardW = glm::normalize(dvec3(forward));
    const dvec3 right = glm::normalize(glm::cross(forwardW, dvec3(up)));
    const dvec3 upW = glm::cross(right, forwardW);
    const RefractionCamera unturned{eye, vec3(forwardW), vec3(upW), eye, 0.0f};

    const double height = double(eye.y) - double(level);
    const double halfFov = 0.5 * double(verticalFov);
    const dvec3 incident = forwardW * std::cos(halfFov) - upW * std::sin(halfFov); // I = -J
    constexpr double leastFall = 1.0e-4;
    if (height <= 0.0 || incident.y > -leastFall) return unturned;

    const dvec3 pivot = eyeW + incident * (height / -incident.y);                                    // eq. 1
    const dvec3 refracted = optics64::refractRay(incident, dvec3(0.0, 1.0, 0.0), 1.0 / double(ior)); // eq. 2
    const dvec3 axis = glm::cross(incident, refracted);
    const double sine = glm::length(axis);
    // Below this the axis is rounding error, and the turn smaller than a pixel by orders of magnitude. Also
    // where an index below 1 reflects totally and the refracted ray is zero.
    if (sine < 1.0e-9) return unturned;

    const dvec3 unitAxis = axis / sine;
    const double angle = std::atan2(sine, glm::dot(incident, refracted));
    return {vec3(pivot + turned(eyeW - pivot, unitAxis, angle)), vec3(turned(forwardW, unitAxis, angle)),
            vec3(turned(upW, unitAxis, angle)), vec3(pivot), static_cast<float>(angle)};
}

float fovExtension(float height, float near, float far)
{
    constexpr float nearHeight = 1.0f;
    constexpr float farHeight = 10.0f;
    const float clamped = std::clamp(std::abs(height), nearHeight, farHeight);
    const float x = std::log(clamped / nearHeight) / std::log(farHeight / nearHeight);
    return near + (far - near) * x * x * (3.0f - 2.0f * x);
}

} // namespace tarn::optics
