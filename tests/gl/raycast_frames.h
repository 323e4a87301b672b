// What the tests of rays marched through maps of heights share: a picture's size, a camera, the method's options.
#pragma once

#include "plan/options.h"
#include "scene/scene.h"

namespace tarn::test {

inline constexpr ivec2 pictureSize(160, 120);
inline constexpr double n = 1.33;

inline Camera over(const vec3& eye, const vec3& target)
{
    Camera camera;
    camera.name = "test";
    camera.eye = eye;
    camera.target = target;
    camera.verticalFov = glm::radians(45.0f);
    camera.farPlane = 300.0f;
    return camera;
}

/// Of the bed.
inline Options raycastOptions(HeightsOptions::March march = HeightsOptions::March::pyramid, int mapSize = 256)
{
    Options options;
    options.refraction.method = RefractionOptions::Method::raycast;
    options.heights.march = march;
    options.heights.mapSize = mapSize;
    options.glow.enabled = false;
    return options;
}

} // namespace tarn::test
