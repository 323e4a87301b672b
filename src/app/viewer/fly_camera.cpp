#include "app/viewer/fly_camera.h"

#include <algorithm>
#include <cmath>

namespace tarn {

namespace {

constexpr float fastFactor = 5.0f;
constexpr float slowest = 0.05f, fastest = 500.0f; // m/s
/// Far enough for any scene, near enough that a float still resolves a centimetre.
constexpr float worldEdge = 1e5f;
/// Straight up and down have no right; stop short of them.
constexpr float steepest = 89.0f * pi / 180.0f;
/// A machine that stood still for longer must not throw the eye across the lake.
constexpr double longestStep = 0.25;

bool finite(const vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

vec3 forwardOf(const Camera& camera) { return glm::normalize(camera.target - camera.eye); }

} // namespace

void FlyCamera::jumpTo(const Camera& camera)
{
    if (finite(camera.eye) && finite(camera.target) && camera.eye != camera.target) camera_ = camera;
}

void FlyCamera::look(vec2 pixels, float windowHeight)
{
    if (!(windowHeight > 0.0f) || !std::isfinite(pixels.x) || !std::isfinite(pixels.y)) return;
    const float radiansPerPixel = camera_.verticalFov / windowHeight;
    const vec3 forward = forwardOf(camera_);
    // Looking straight up or down, the heading is that of the picture's upper edge.
    const bool steep = std::abs(forward.y) > 0.9999f;
    const vec3 heading = steep ? (forward.y > 0.0f ? -camera_.up : camera_.up) : forward;
    const float yaw = std::atan2(heading.x, -heading.z) + pixels.x * radiansPerPixel;
    const float pitch = std::asin(std::clamp(forward.y, -1.0f, 1.0f)) - pixels.y * radiansPerPixel;
    faceTowards(yaw, std::clamp(pitch, -steepest, steepest));
}

void FlyCamera::faceTowards(float yaw, float pitch)
{
    const float distance = glm::distance(camera_.eye, camera_.target);
    const vec3 forward(std::cos(pitch) * std::sin(yaw), std::sin(pitch), -std::cos(pitch) * std::cos(yaw));
    camera_.target = camera_.eye + std::clamp(distance, 1.0f, 1e3f) * forward;
    camera_.up = vec3(0.0f, 1.0f, 0.0f);
}

void FlyCamera::move(const vec3& direction, bool fast, double seconds)
{
    if (!finite(direction) || !(seconds > 0.0) || direction == vec3(0.0f)) return;
    const vec3 forward = forwardOf(camera_);
    const vec3 right = glm::normalize(glm::cross(forward, camera_.up));
    vec3 way = direction.x * right + direction.y * vec3(0.0f, 1.0f, 0.0f) + direction.z * forward;
    if (!finite(way)) return;
    const float length = glm::length(way);
    if (length > 1.0f) way /= length;

    const float metres = speed_ * (fast ? fastFactor : 1.0f) * static_cast<float>(std::min(seconds, longestStep));
    const vec3 eye = glm::clamp(camera_.eye + metres * way, vec3(-worldEdge), vec3(worldEdge));
    camera_.target += eye - camera_.eye;
    camera_.eye = eye;
}

void FlyCamera::changeSpeed(double notches)
{
    if (!std::isfinite(notches)) return;
    const double factor = std::pow(1.2, std::clamp(notches, -50.0, 50.0));
    speed_ = std::clamp(speed_ * static_cast<float>(factor), slowest, fastest);
}

} // namespace tarn
