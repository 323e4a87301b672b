// The flight that measurements and tests follow.
#include "scene/flight.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tarn {

namespace {

std::vector<Camera> threeCameras()
{
    std::vector<Camera> cameras(3);
    cameras[0].eye = vec3(0, 2, 10);
    cameras[1].eye = vec3(20, 1, 5);
    cameras[1].target = vec3(120, 1, 5);
    cameras[1].verticalFov = 0.5f;
    cameras[2].eye = vec3(5, -1, 5);
    cameras[2].target = vec3(-5, -1, 5); // the opposite way
    return cameras;
}

vec3 ahead(const Camera& camera) { return glm::normalize(camera.target - camera.eye); }

} // namespace

TEST(Flight, PassesEveryCamera)
{
    const std::vector<Camera> cameras = threeCameras();
    for (std::size_t i = 0; i < 3; ++i) {
        const Camera at = flightCamera(cameras, 0.5 * static_cast<double>(i));
        EXPECT_LT(glm::distance(at.eye, cameras[i].eye), 1.0e-4f) << i;
        EXPECT_LT(glm::distance(ahead(at), ahead(cameras[i])), 1.0e-4f) << i;
        EXPECT_NEAR(at.verticalFov, cameras[i].verticalFov, 1.0e-5f) << i;
    }
    EXPECT_EQ(flightCamera(cameras, -1.0).eye, cameras[0].eye);
    EXPECT_EQ(flightCamera(cameras, 2.0).eye, cameras[2].eye);
    EXPECT_EQ(flightCamera({cameras[1]}, 0.7).eye, cameras[1].eye);
}

TEST(Flight, MovesSteadilyAndAlwaysLooksSomewhere)
{
    const std::vector<Camera> cameras = threeCameras();
    Camera last = flightCamera(cameras, 0.0);
    float longest = 0.0f;
    for (int i = 1; i <= 1000; ++i) {
        const Camera now = flightCamera(cameras, 0.001 * i);
        longest = std::max(longest, glm::distance(now.eye, last.eye));
        EXPECT_GT(glm::length(now.target - now.eye), 1.0e-4f);
        last = now;
    }
    EXPECT_LT(longest, 1.5f * 2.0f * 0.001f * 21.0f); // 21 m in half of it, at most half as fast again as the mean
}

} // namespace tarn
