// Depth complexity: what a map seen from above or below cannot hold.
#include "plan/depth_complexity.h"
#include "test_scenes.h"

#include <gtest/gtest.h>

namespace tarn::test {
namespace {

TEST(DepthComplexity, OfABedIsNone)
{
    const Scene scene = flatLake(2.0f, 8.0f);
    const DepthComplexity complexity = depthComplexity(scene, scene.water);
    EXPECT_EQ(complexity.bed, 0.0);
    EXPECT_EQ(complexity.aboveWater, 0.0);
}

// A quarter of the bed under a ledge that hangs free, and the same sunk into the ground.
TEST(DepthComplexity, CountsWhatLiesUnderALedgeButNotWhatIsSunk)
{
    Scene ledge = flatLake(2.0f, 8.0f);
    addBox(ledge, {-2, -1.2f, -2}, {2, -1.0f, 2}, addMaterial(ledge, vec3(0.5f)));
    EXPECT_NEAR(depthComplexity(ledge, ledge.water).bed, 0.25, 0.01);
    Scene rock = flatLake(2.0f, 8.0f);
    addBox(rock, {-2, -3.0f, -2}, {2, -1.0f, 2}, addMaterial(rock, vec3(0.5f)));
    EXPECT_EQ(depthComplexity(rock, rock.water).bed, 0.0);
}

// What stands out of the water hides nothing of the bed that water would show; a deck does not touch it.
TEST(DepthComplexity, ADeckIsOfTheAir)
{
    Scene scene = flatLake(2.0f, 8.0f);
    addBox(scene, {-2, 0.5f, -2}, {2, 0.6f, 2}, addMaterial(scene, vec3(0.5f)));
    DepthComplexity complexity = depthComplexity(scene, scene.water);
    EXPECT_EQ(complexity.bed, 0.0);
    EXPECT_EQ(complexity.aboveWater, 0.0) << "one piece";
    addBox(scene, {-1, 1.5f, -2}, {1, 1.6f, 2}, addMaterial(scene, vec3(0.5f)));
    complexity = depthComplexity(scene, scene.water);
    EXPECT_NEAR(complexity.aboveWater, 0.5, 0.02) << "a roof over half of it";
}

TEST(DepthComplexity, ASheetIsALayer)
{
    Scene scene = flatLake(2.0f, 8.0f);
    const int leaf = addMaterial(scene, vec3(0.5f));
    scene.materials[static_cast<std::size_t>(leaf)].twoSided = true;
    addFloor(scene, -1.0f, 4.0f, leaf);
    EXPECT_NEAR(depthComplexity(scene, scene.water).bed, 0.25, 0.01);
}

// A crown of upright cards over a quarter of an island: seen from above next to nothing, yet the map cannot hold it.
TEST(DepthComplexity, UprightFoliageIsALayerOverTheGround)
{
    Scene scene = flatLake(2.0f, 8.0f);
    addBox(scene, {-4, -2, -4}, {4, 1, 4}, addMaterial(scene, vec3(0.5f)));
    const int leaf = addMaterial(scene, vec3(0.5f));
    scene.materials[static_cast<std::size_t>(leaf)].alphaTested = true;
    for (int i = 0; i < 40; ++i) {
        const float x = -2.0f + 0.1f * static_cast<float>(i);
        addBox(scene, {x, 1.5f, -2}, {x + 0.1f, 2.5f, 2}, leaf);
    }
    EXPECT_NEAR(depthComplexity(scene, scene.water).aboveWater, 0.25, 0.02);
}

} // namespace
} // namespace tarn::test
