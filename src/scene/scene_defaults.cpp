#include "scene/scene_defaults.h"

#include <algorithm>
#include <cmath>

namespace tarn {

namespace {

Camera lookFrom(const char* name, const Bounds& bounds, const vec3& direction, const vec3& up)
{
    Camera camera;
    camera.name = name;
    const float radius = std::max(0.5f * glm::length(bounds.extent()), 1e-3f);
    // The box' sphere just fits the vertical field of view.
    const float distance = radius / std::sin(0.5f * camera.verticalFov);
    camera.target = bounds.centre();
    camera.eye = camera.target + distance * glm::normalize(direction);
    camera.up = up;
    camera.nearPlane = 0.005f * radius;
    camera.farPlane = 20.0f * radius;
    return camera;
}

} // namespace

std::vector<Camera> camerasAround(const Bounds& bounds)
{
    const vec3 upward(0.0f, 1.0f, 0.0f);
    return {lookFrom("overview", bounds, {0.5f, 0.45f, 1.0f}, upward),
            lookFrom("side", bounds, {0.0f, 0.12f, 1.0f}, upward),
            lookFrom("top", bounds, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, -1.0f})};
}

WaterBody waterAcross(const Bounds& bounds, float level)
{
    WaterBody water;
    water.present = true;
    water.level = level;
    water.centre = {bounds.centre().x, bounds.centre().z};
    water.extent = glm::max(vec2(bounds.extent().x, bounds.extent().z), vec2(1e-2f));
    const float size = std::max(water.extent.x, water.extent.y);
    // Short against the lake but never longer than waves a boat makes; gentle, 1 m of height to 150 m of
    // length.
    const float longest = std::min(size / 12.0f, 6.0f);
    for (int i = 0; i < 4; ++i) {
        Wave wave;
        wave.wavelength = longest / (1.0f + 0.7f * static_cast<float>(i));
        wave.amplitude = wave.wavelength / 150.0f;
        wave.direction = 0.6f + 0.5f * static_cast<float>(i % 2 == 0 ? i : -i);
        wave.phase = 1.3f * static_cast<float>(i);
        water.waves.push_back(wave);
    }
    return water;
}

std::optional<float> levelWithin(const Bounds& bounds)
{
    const float height = bounds.extent().y;
    if (bounds.empty() || height <= 0.0f) return std::nullopt;
    return bounds.lower.y + 0.25f * height;
}

} // namespace tarn
