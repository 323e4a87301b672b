// Two eyes: where they stand, what they see at the same place, and how large their pictures are.
#include "plan/frame_plan.h"
#include "plan/stereo.h"
#include "test_scenes.h"

#include <gtest/gtest.h>

namespace tarn {
namespace {

constexpr float aspect = 4.0f / 3.0f;

Camera headCamera()
{
    Camera camera;
    camera.eye = {3.0f, 2.0f, 5.0f};
    camera.target = {1.0f, 0.5f, -2.0f};
    camera.verticalFov = 0.9f;
    return camera;
}

/// A place of the head's view space, in the world.
vec3 positionInView(const Camera& camera, const vec3& positionV)
{
    return vec3(glm::inverse(viewFromWorld(camera)) * vec4(positionV, 1.0f));
}

vec3 seenAt(const Camera& camera, const vec3& place)
{
    const vec4 clip = clipFromView(camera, aspect) * viewFromWorld(camera) * vec4(place, 1.0f);
    return vec3(clip) / clip.w;
}

TEST(Stereo, EyesStandBesideTheCameraAndLookTheSameWay)
{
    const Camera head = headCamera();
    StereoOptions stereo;
    stereo.separation = 0.4f;
    const Camera left = eyeCamera(head, stereo, Eye::left), right = eyeCamera(head, stereo, Eye::right);
    EXPECT_LT(glm::distance(left.eye, positionInView(head, {-0.2f, 0.0f, 0.0f})), 1e-5f);
    EXPECT_LT(glm::distance(right.eye, positionInView(head, {0.2f, 0.0f, 0.0f})), 1e-5f);
    for (const Camera& eye : {left, right})
        EXPECT_LT(glm::distance(glm::normalize(eye.target - eye.eye), glm::normalize(head.target - head.eye)), 1e-6f);
    EXPECT_FLOAT_EQ(left.lensShift, 0.2f / stereo.convergence);
    EXPECT_FLOAT_EQ(right.lensShift, -0.2f / stereo.convergence);
}

TEST(Stereo, OnThePlaneOfConvergenceBothEyesSeeTheSame)
{
    const Camera head = headCamera();
    StereoOptions stereo;
    stereo.separation = 0.4f;
    stereo.convergence = 3.0f;
    for (const vec2 at : {vec2(0.0f), vec2(1.2f, -0.7f), vec2(-2.0f, 1.0f)}) {
        const vec3 place = positionInView(head, {at, -3.0f});
        const vec3 middle = seenAt(head, place);
        for (const Eye eye : bothEyes)
            EXPECT_LT(glm::distance(vec2(seenAt(eyeCamera(head, stereo, eye), place)), vec2(middle)), 1e-5f);
    }
}

// Disparity of a thing at depth z, as a tangent: s (1/c - 1/z), over 0 behind the plane; none of it vertical.
TEST(Stereo, DisparityGoesWithTheInverseDepth)
{
    const Camera head = headCamera();
    StereoOptions stereo;
    stereo.separation = 0.2f;
    stereo.convergence = 4.0f;
    const float edge = aspect * std::tan(0.5f * head.verticalFov);
    for (const float depth : {1.0f, 2.0f, 4.0f, 40.0f, 400.0f}) {
        const vec3 place = positionInView(head, {0.1f * depth, -0.2f * depth, -depth});
        const vec3 left = seenAt(eyeCamera(head, stereo, Eye::left), place);
        const vec3 right = seenAt(eyeCamera(head, stereo, Eye::right), place);
        EXPECT_NEAR((right.x - left.x) * edge, 0.2f * (1.0f / 4.0f - 1.0f / depth), 1e-5f) << depth;
        EXPECT_NEAR(right.y, left.y, 1e-5f) << depth;
        EXPECT_NEAR(right.z, left.z, 1e-5f) << depth;
    }
}

TEST(Stereo, EyesThatAreNotApartAreTheCamera)
{
    const Camera head = headCamera();
    StereoOptions stereo;
    stereo.separation = 0.0f;
    for (const Eye eye : bothEyes) {
        const Camera camera = eyeCamera(head, stereo, eye);
        EXPECT_EQ(camera.eye, head.eye);
        EXPECT_EQ(clipFromView(camera, aspect) * viewFromWorld(camera),
                  clipFromView(head, aspect) * viewFromWorld(head));
    }
}

TEST(Stereo, SizesOfPicturesAndWindows)
{
    using Output = StereoOptions::Output;
    EXPECT_EQ(presentedSize({320, 180}, Output::off), ivec2(320, 180));
    EXPECT_EQ(presentedSize({320, 180}, Output::sideBySide), ivec2(640, 180));
    EXPECT_EQ(presentedSize({320, 180}, Output::pair), ivec2(640, 180));
    EXPECT_EQ(presentedSize({320, 180}, Output::anaglyph), ivec2(320, 180));
    EXPECT_EQ(eyeSizeFor({640, 480}, Output::sideBySide), ivec2(320, 480));
    EXPECT_EQ(eyeSizeFor({640, 480}, Output::anaglyph), ivec2(640, 480));
    EXPECT_EQ(eyeSizeFor({1, 1}, Output::sideBySide), ivec2(1, 1));
}

TEST(Stereo, ThePlanSaysThatBothEyesArePresented)
{
    const Scene scene = test::flatLake(2.0f);
    Options options;
    options.stereo.output = StereoOptions::Output::sideBySide;
    const FramePlan plan = planFrame(scene, scene.water, headCamera(), options, {320, 180}, 0.0);
    EXPECT_EQ(plan[PassId::present].size, ivec2(640, 180));
    EXPECT_EQ(plan[PassId::scene].size, ivec2(320, 180));
    EXPECT_NE(plan[PassId::present].reason.find("each eye"), std::string::npos);
}

// The near plane of a sheared frustum lies beside the axis: only there does the water cut it.
TEST(Stereo, TheNearPlaneOfAShearedFrustumIsWhereItIs)
{
    Scene scene = test::flatLake(2.0f, 1.0f); // 1 m wide
    Camera camera;
    camera.eye = {-1.0f, 0.0f, 0.0f}; // half a metre beside it, at the level
    camera.target = {-1.0f, 0.0f, -1.0f};
    camera.nearPlane = 0.25f;
    const auto side = [&] {
        return waterSide(scene.water, optics64::uniformGrid({0.0, 0.0, 0.5, 0.5}, 9), camera, 1.0f, 0.0);
    };
    EXPECT_EQ(side(), WaterSide::above);
    camera.lensShift = 4.0f; // its middle is a metre to the right
    EXPECT_EQ(side(), WaterSide::crossing);
    camera.lensShift = -4.0f;
    EXPECT_EQ(side(), WaterSide::above);
}

} // namespace
} // namespace tarn
