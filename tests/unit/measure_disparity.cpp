// Disparity of pairs whose points formulas give: still water over a level bed, and what it mirrors of a level ceiling.
#include "base/error.h"
#include "measure/disparity.h"
#include "optics/optics.h"
#include "plan/stereo.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tarn {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr ivec2 size(160, 120);

Camera lookDown(float height, float degrees)
{
    Camera camera;
    camera.eye = vec3(0.0f, height, 0.0f);
    camera.target = vec3(0.0f);
    camera.up = vec3(0.0f, 0.0f, -1.0f);
    camera.verticalFov = glm::radians(degrees);
    return camera;
}

Camera lookAlong()
{
    Camera camera;
    camera.eye = vec3(0.5f, 2.0f, 0.3f);
    camera.target = vec3(0.0f, 0.0f, -2.5f);
    return camera;
}

/// Pixels that a tangent of 1 spans.
double pixelsPerTangent(const Camera& camera)
{
    return 0.5 * size.y / std::tan(0.5 * static_cast<double>(camera.verticalFov));
}

WaterBody stillWater(float ior = 1.33f)
{
    WaterBody water;
    water.present = true;
    water.level = 0.0f;
    water.ior = ior;
    return water;
}

/// What one eye sees of a level bed (y < 0, refracted) or ceiling (y > 0, mirrored) at a height.
EyePoints pointsOf(const Camera& camera, double height, double ior)
{
    EyePoints eye{camera, size, {}, {}};
    const glm::dmat3 worldFromView = glm::transpose(glm::dmat3(glm::dmat4(viewFromWorld(camera))));
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const dvec2 tangents((x + 0.5 - 0.5 * size.x) / pixelsPerTangent(camera) +
                                     static_cast<double>(camera.lensShift),
                                 (0.5 * size.y - y - 0.5) / pixelsPerTangent(camera));
            const dvec3 ray = glm::normalize(worldFromView * dvec3(tangents, -1.0));
            const bool down = ray.y < -0.02;
            const dvec3 surface = dvec3(camera.eye) - ray * (static_cast<double>(camera.eye.y) / ray.y);
            const dvec3 on = height < 0.0 ? optics64::refractRay(ray, dvec3(0.0, 1.0, 0.0), 1.0 / ior)
                                          : optics64::reflectRay(ray, dvec3(0.0, 1.0, 0.0));
            eye.points.emplace_back(down ? vec3(surface + on * (height / on.y)) : vec3(0.0f));
            eye.isKnown.push_back(down);
        }
    }
    return eye;
}

StereoPair pairOf(const Camera& head, const StereoOptions& stereo, double height, double ior = 1.33)
{
    return {pointsOf(eyeCamera(head, stereo, Eye::left), height, ior),
            pointsOf(eyeCamera(head, stereo, Eye::right), height, ior)};
}

StereoOptions stereoOf(float separation, float convergence)
{
    StereoOptions stereo;
    stereo.separation = separation;
    stereo.convergence = convergence;
    return stereo;
}

/// Where an eye sees a point under flat water, pixels.
dvec2 seenAt(const Camera& camera, const vec3& point)
{
    const dvec3 apparent = optics64::flatApparent(dvec3(camera.eye), dvec3(point), 0.0, 1.33);
    const dvec3 v(glm::dmat4(viewFromWorld(camera)) * glm::dvec4(apparent, 1.0));
    return {0.5 * size.x - 0.5 + pixelsPerTangent(camera) * (v.x / -v.z - static_cast<double>(camera.lensShift)),
            0.5 * size.y - 0.5 - pixelsPerTangent(camera) * v.y / -v.z};
}

// The partner is found in the right picture's points. Where it is looked for first must not matter: water of another
// index, and with it another first guess, gives the same.
TEST(Disparity, PartnersStandWhereSnellPutsThem)
{
    const StereoPair pair = pairOf(lookAlong(), stereoOf(0.1f, 3.0f), -2.0);
    for (const float ior : {1.33f, 1.0f, 1.6f}) {
        const auto found = disparities(pair, stillWater(ior), ShownBy::refraction);
        std::size_t known = 0, compared = 0;
        for (std::size_t i = 0; i < found.size(); ++i) {
            known += pair.left.isKnown[i];
            const dvec2 expected =
                seenAt(pair.right.camera, pair.left.points[i]) - seenAt(pair.left.camera, pair.left.points[i]);
            if (!found[i]) continue;
            ++compared;
            ASSERT_NEAR(found[i]->x, expected.x, 0.02) << i;
            ASSERT_NEAR(found[i]->y, expected.y, 0.02) << i;
        }
        EXPECT_GT(compared, known * 9 / 10) << ior; // the rest is beside the right picture
        EXPECT_LT(compared, known) << ior;
    }
}

// Straight down, water makes a depth d look like d / n: the disparity is that of a thing so far away, and none where
// that is the distance of convergence.
TEST(Disparity, StraightDownIsThatOfTheApparentDepth)
{
    const double height = 2.0, depth = 3.0, apparent = height + depth / 1.33;
    const Camera head = lookDown(static_cast<float>(height), 8.0f);
    for (const double convergence : {1.5, apparent, 20.0}) {
        const StereoPair pair = pairOf(head, stereoOf(0.065f, static_cast<float>(convergence)), -depth);
        const double expected = pixelsPerTangent(head) * 0.065 * (1.0 / convergence - 1.0 / apparent);
        const auto found = disparities(pair, stillWater(), ShownBy::refraction);
        const auto& middle = found[static_cast<std::size_t>(size.y / 2 * size.x + size.x / 2)];
        ASSERT_TRUE(middle);
        EXPECT_NEAR(middle->x, expected, 0.02) << convergence;
        EXPECT_NEAR(middle->y, 0.0, 0.02) << convergence;
    }
}

TEST(Disparity, WhatIsMirroredIsAsFarBelowAsItStandsAbove)
{
    const Camera head = lookDown(2.0f, 8.0f);
    const StereoPair pair = pairOf(head, stereoOf(0.065f, 3.0f), 4.0);
    const auto found = disparities(pair, stillWater(), ShownBy::reflection);
    const auto& middle = found[static_cast<std::size_t>(size.y / 2 * size.x + size.x / 2)];
    ASSERT_TRUE(middle);
    EXPECT_NEAR(middle->x, pixelsPerTangent(head) * 0.065 * (1.0 / 3.0 - 1.0 / 6.0), 0.02);
}

// A pair that is drawn with too weak a refraction shows its bed too deep by a known disparity.
TEST(Disparity, AWrongIndexIsMeasured)
{
    const Camera head = lookDown(2.0f, 8.0f);
    const StereoOptions stereo = stereoOf(0.065f, 3.0f);
    const StereoPair truth = pairOf(head, stereo, -3.0, 1.33), drawn = pairOf(head, stereo, -3.0, 1.2);
    const double expected = pixelsPerTangent(head) * 0.065 * (1.0 / (2.0 + 3.0 / 1.33) - 1.0 / (2.0 + 3.0 / 1.2));
    const DisparityErrors errors = disparityErrors(drawn, truth, stillWater(), ShownBy::refraction);
    EXPECT_GT(expected, 0.5);
    EXPECT_NEAR(errors.median, expected, 0.02 * expected);
    EXPECT_NEAR(errors.bias, expected, 0.02 * expected);
    EXPECT_GT(errors.p95, errors.median);
    EXPECT_LT(errors.maximum, 1.2 * expected);
    EXPECT_LT(errors.verticalP95, 0.1 * expected);
    EXPECT_EQ(errors.pixels, static_cast<std::size_t>(size.x * size.y));
    std::size_t mapped = 0;
    for (const float value : errors.map.floats) mapped += !std::isnan(value);
    EXPECT_EQ(mapped, errors.compared);

    const DisparityErrors none = disparityErrors(truth, truth, stillWater(), ShownBy::refraction);
    EXPECT_EQ(none.maximum, 0.0);
    EXPECT_EQ(none.alone, none.aloneInTruth);
    EXPECT_NEAR(none.trueMedian, pixelsPerTangent(head) * 0.065 * (1.0 / 3.0 - 1.0 / (2.0 + 3.0 / 1.33)), 0.02);
}

TEST(Disparity, WithoutSeparationThereIsNone)
{
    const StereoPair pair = pairOf(lookAlong(), stereoOf(0.0f, 3.0f), -2.0);
    const auto found = disparities(pair, stillWater(), ShownBy::refraction);
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (!found[i]) continue;
        ASSERT_NEAR(glm::length(*found[i]), 0.0f, 0.03f) << i;
    }
}

TEST(Disparity, APointThatTheOtherEyeDoesNotSeeIsAlone)
{
    const StereoPair truth = pairOf(lookDown(2.0f, 40.0f), stereoOf(0.02f, 4.0f), -2.0);
    StereoPair drawn = truth;
    for (int y = 0; y < size.y; ++y) // a post hides the right half from the right eye
        for (int x = size.x / 2; x < size.x; ++x) drawn.right.isKnown[static_cast<std::size_t>(y * size.x + x)] = 0;
    DisparityErrors errors = disparityErrors(drawn, truth, stillWater(), ShownBy::refraction);
    EXPECT_NEAR(errors.alone, 0.5, 0.03);
    EXPECT_LT(errors.aloneInTruth, 0.05);
    EXPECT_EQ(errors.maximum, 0.0);

    for (vec3& point : drawn.right.points) point.y += 0.5f; // nor one that is somewhere else
    errors = disparityErrors(drawn, truth, stillWater(), ShownBy::refraction);
    EXPECT_EQ(errors.alone, 1.0);
    EXPECT_EQ(errors.compared, 0u);
    EXPECT_TRUE(std::isnan(errors.median));
}

TEST(Disparity, PicturesOfTwoSizesAreRefused)
{
    const StereoPair pair = pairOf(lookAlong(), stereoOf(0.065f, 3.0f), -2.0);
    StereoPair other = pair;
    other.right.size = {80, 60};
    EXPECT_THROW(disparityErrors(pair, other, stillWater(), ShownBy::refraction), Error);
}

} // namespace
} // namespace tarn
