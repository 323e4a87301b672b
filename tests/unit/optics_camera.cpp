// The refraction camera (Mihálik 2008, equations 1 and 2).

#include "optics/optics.h"
#include "optics/refraction_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tarn {
namespace {

constexpr float degree = std::numbers::pi_v<float> / 180.0f;
constexpr float n = 1.33f;
const vec3 up(0.0f, 1.0f, 0.0f);

vec3 looking(float pitch, float yaw)
{
    return {std::cos(pitch) * std::sin(yaw), std::sin(pitch), -std::cos(pitch) * std::cos(yaw)};
}

/// The ray along the middle of the frustum's bottom plane.
vec3 bottomRay(vec3 forward, vec3 cameraUp, float fov)
{
    return forward * std::cos(0.5f * fov) - cameraUp * std::sin(0.5f * fov);
}

TEST(RefractionCamera, ItsBottomRayIsTheRefractedOneThroughO)
{
    const float fov = 50.0f * degree, level = 1.7f;
    for (float pitch : {-80.0f, -64.9f, -60.0f, -45.0f, -20.0f, 0.0f, 20.0f})
        for (float yaw : {0.0f, 1.0f, 4.0f}) {
            const vec3 eye(3.0f, level + 2.5f, -7.0f), forward = looking(pitch * degree, yaw);
            const vec3 cameraUp = glm::normalize(up - glm::dot(up, forward) * forward);
            const auto turned = optics::refractionCamera(eye, forward, up, fov, level, n);

            const vec3 incident = bottomRay(forward, cameraUp, fov);
            const vec3 o = eye + incident * ((eye.y - level) / -incident.y);
            EXPECT_LT(glm::length(turned.pivot - o), 1e-4f) << pitch;
            const vec3 refracted = optics::refractRay(incident, up, 1.0f / n);
            const vec3 bottom = bottomRay(turned.forward, turned.up, fov);
            EXPECT_LT(glm::length(bottom - refracted), 1e-5f) << pitch;
            // O lies on it, as far from the eye as before: a rigid turn.
            EXPECT_LT(glm::length(turned.eye + bottom * glm::length(o - eye) - o), 1e-4f) << pitch;
            EXPECT_NEAR(glm::dot(turned.forward, turned.up), 0.0f, 1e-6f);
            EXPECT_NEAR(std::cos(turned.angle), glm::dot(incident, refracted), 1e-6f);
            // The axis is horizontal: the camera does not roll, and stays in its vertical plane.
            const vec3 right = glm::cross(forward, cameraUp);
            EXPECT_LT(glm::length(glm::cross(turned.forward, turned.up) - right), 1e-5f);
        }
}

TEST(RefractionCamera, TurnsByTheAngleOfRefraction)
{
    // Bottom ray 60° from the vertical: refracted to asin(sin 60° / 1.33) = 40.63°.
    const auto turned =
        optics::refractionCamera({0.0f, 1.0f, 0.0f}, looking(-10.0f * degree, 0.0f), up, 40.0f * degree, 0.0f, n);
    EXPECT_NEAR(turned.angle / degree, 60.0f - 40.63f, 0.01f);
    EXPECT_GT(turned.eye.y, 1.0f);
}

TEST(RefractionCamera, StaysWhereThereIsNothingToTurnAbout)
{
    const float fov = 50.0f * degree;
    auto unturned = [&](vec3 eye, vec3 forward, vec3 cameraUp, float ior) {
        const auto camera = optics::refractionCamera(eye, forward, cameraUp, fov, 0.0f, ior);
        return camera.eye == eye && camera.angle == 0.0f && glm::length(camera.forward - forward) < 1e-6f;
    };
    const vec3 eye(1.0f, 2.0f, 3.0f);
    EXPECT_TRUE(unturned(eye, looking(26.0f * degree, 0.3f), up, n)) << "the bottom ray rises";
    EXPECT_TRUE(unturned(eye, looking(25.0f * degree, 0.3f), up, n)) << "the bottom ray is level";
    EXPECT_TRUE(unturned({1.0f, -2.0f, 3.0f}, looking(-0.5f, 0.3f), up, n)) << "under water";
    EXPECT_TRUE(unturned({1.0f, 0.0f, 3.0f}, looking(-0.5f, 0.3f), up, n)) << "at the level";
    EXPECT_TRUE(unturned(eye, looking(-0.5f, 0.3f), up, 1.0f)) << "no refraction";
    EXPECT_FALSE(unturned(eye, looking(-0.5f, 0.3f), up, n));
}

TEST(RefractionCamera, BottomRayStraightDownTurnsNothing)
{
    // -65° and half of 50°, to float's rounding of the angle.
    const vec3 eye(1.0f, 2.0f, 3.0f), forward = looking(-65.0f * degree, 0.0f);
    const auto camera = optics::refractionCamera(eye, forward, up, 50.0f * degree, 0.0f, n);
    EXPECT_LT(camera.angle, 1e-6f);
    EXPECT_LT(glm::length(camera.eye - eye) + glm::length(camera.forward - forward), 1e-6f);
}

TEST(RefractionCamera, LookingStraightDownTurnsTowardsTheBottomRay)
{
    // The bottom ray is 25° off the vertical; the up vector cannot be the world's.
    const vec3 down(0.0f, -1.0f, 0.0f);
    const auto turned =
        optics::refractionCamera({0.0f, 5.0f, 0.0f}, down, {0.0f, 0.0f, -1.0f}, 50.0f * degree, 0.0f, n);
    EXPECT_NEAR(turned.angle / degree, 25.0f - std::asin(std::sin(25.0f * degree) / n) / degree, 1e-3f);
}

TEST(RefractionCamera, IsContinuousAsTheCameraTilts)
{
    vec3 last(0.0f);
    for (int i = 0; i <= 1600; ++i) {
        const float pitch = (-85.0f + 0.05f * static_cast<float>(i)) * degree;
        const auto turned =
            optics::refractionCamera({0.0f, 2.0f, 0.0f}, looking(pitch, 0.0f), up, 50.0f * degree, 0.0f, n);
        if (i > 0) {
            EXPECT_LT(glm::length(turned.forward - last), 0.003f) << pitch / degree;
        }
        last = turned.forward;
    }
}

TEST(FovExtension, GoesFromNearToFar)
{
    EXPECT_FLOAT_EQ(optics::fovExtension(0.0f, 1.5f, 1.2f), 1.5f);
    EXPECT_FLOAT_EQ(optics::fovExtension(1.0f, 1.5f, 1.2f), 1.5f);
    EXPECT_FLOAT_EQ(optics::fovExtension(std::sqrt(10.0f), 1.5f, 1.2f), 1.35f);
    EXPECT_FLOAT_EQ(optics::fovExtension(10.0f, 1.5f, 1.2f), 1.2f);
    EXPECT_FLOAT_EQ(optics::fovExtension(1.0e6f, 1.5f, 1.2f), 1.2f);
    EXPECT_FLOAT_EQ(optics::fovExtension(-10.0f, 1.5f, 1.2f), 1.2f);
    for (float h = 0.5f; h < 12.0f; h += 0.1f)
        EXPECT_GE(optics::fovExtension(h, 1.5f, 1.2f), optics::fovExtension(h + 0.1f, 1.5f, 1.2f));
}

} // namespace
} // namespace tarn
