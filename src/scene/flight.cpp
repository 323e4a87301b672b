#include "scene/flight.h"

#include <algorithm>
#include <cmath>

namespace tarn {

namespace {

/// The point that a camera looks at a metre off: targets far and near move alike.
vec3 lookedAt(const Camera& camera) { return camera.eye + glm::normalize(camera.target - camera.eye); }

} // namespace

Camera flightCamera(const std::vector<Camera>& cameras, double part)
{
    const double leg = std::clamp(part, 0.0, 1.0) * static_cast<double>(cameras.size() - 1);
    const auto first = std::min(static_cast<std::size_t>(leg), cameras.size() - 1);
    const Camera& from = cameras[first];
    const Camera& to = cameras[std::min(first + 1, cameras.size() - 1)];
    const auto x = static_cast<float>(leg - static_cast<double>(first));
    const float t = x * x * (3.0f - 2.0f * x);
    Camera camera = from;
    camera.name = "flight";
    camera.eye = glm::mix(from.eye, to.eye, t);
    const vec3 ahead = glm::mix(lookedAt(from) - from.eye, lookedAt(to) - to.eye, t);
    // Half way between opposite views there is no direction: the old one goes on.
    constexpr float least = 1.0e-3f;
    camera.target = camera.eye + (glm::length(ahead) > least ? ahead : lookedAt(from) - from.eye);
    camera.verticalFov = glm::mix(from.verticalFov, to.verticalFov, t);
    return camera;
}

} // namespace tarn
