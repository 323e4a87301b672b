// What the cameras of a frame are said to see: never less than they do.
#include "test_scenes.h"

#include "render/gather_visibility.h"

#include <gtest/gtest.h>

namespace tarn::test {

namespace {

Camera cameraAt(const vec3& eye, const vec3& target)
{
    Camera camera;
    camera.eye = eye;
    camera.target = target;
    return camera;
}

VisibilityFacts visibilityOf(const Scene& scene, const Camera& camera)
{
    return gatherVisibility(listBoxes(scene), scene, scene.water, camera, {640, 480}, {}, {});
}

} // namespace

TEST(GatherVisibility, AFlatBedIsABed)
{
    const Scene scene = flatLake(3.0f, 30.0f); // its box has no height
    const VisibilityFacts visibility = visibilityOf(scene, cameraAt({0, 2, 7}, {0, 0, 0}));
    EXPECT_TRUE(visibility.seesBed);
    EXPECT_TRUE(visibility.refractionReceives);
    EXPECT_FALSE(visibility.mainReceives) << "the surface hides it";
    EXPECT_FALSE(visibility.mirrors);
    EXPECT_FALSE(visibility.reflectionReceives);
    EXPECT_FLOAT_EQ(visibility.leastDepth, 3.0f);
    EXPECT_NEAR(visibility.bedReflectance.x, 0.5f / pi, 1.0e-6f);
}

TEST(GatherVisibility, WhatStandsThroughTheSurfaceIsMirroredAndWet)
{
    Scene scene = flatLake(3.0f, 30.0f);
    addBox(scene, {-1, -2, -1}, {1, 1, 1}, 0);
    const VisibilityFacts visibility = visibilityOf(scene, cameraAt({0, 2, 7}, {0, 0, 0}));
    EXPECT_TRUE(visibility.mirrors);
    EXPECT_TRUE(visibility.reflectionReceives) << "down to the clip offset";
    EXPECT_TRUE(visibility.mainReceives) << "up to the level itself";
    EXPECT_FLOAT_EQ(visibility.leastDepth, -1.0f);
}

TEST(GatherVisibility, WhatStandsInTheAirOrBesideTheWaterIsDry)
{
    Scene scene = flatLake(3.0f, 30.0f);
    scene.elements.clear();
    addBox(scene, {-1, 0, -1}, {1, 1, 1}, 0);
    addBox(scene, {16, -2, -1}, {18, 1, 1}, 0);
    const VisibilityFacts visibility = visibilityOf(scene, cameraAt({0, 12, 37}, {8, 0, 0}));
    EXPECT_TRUE(visibility.mirrors);
    EXPECT_FALSE(visibility.mainReceives || visibility.refractionReceives || visibility.reflectionReceives);
}

// In the mirrored camera's frustum, but nowhere near what calm water in a corner of the picture can mirror.
TEST(GatherVisibility, WhatNoWaterOnTheScreenCanMirrorIsNotMirrored)
{
    Scene scene = flatLake(3.0f, 6.0f);
    scene.elements.clear();
    addBox(scene, {14, 1, -60}, {22, 6, -50}, 0);
    const Camera camera = cameraAt({3, 14, 30}, {0, 1, 0});
    EXPECT_FALSE(visibilityOf(scene, camera).mirrors);
    Options options;
    options.plan.rules[static_cast<std::size_t>(RuleId::targetBounds)] = false;
    EXPECT_TRUE(gatherVisibility(listBoxes(scene), scene, scene.water, camera, {640, 480}, options, {}).mirrors);
}

} // namespace tarn::test
