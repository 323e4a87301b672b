// The terrain of assets/bench is what its page and the yardstick say it is.
#include "base/files.h"
#include "scene/scene_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tarn {
namespace {

const Scene& terrain()
{
    static const Scene scene = loadScene(projectRoot() / "assets" / "bench" / "terrain.toml");
    return scene;
}

TEST(BenchTerrain, HasTheTrianglesOfTheComparisons)
{
    ASSERT_EQ(terrain().meshes.size(), 1u);
    EXPECT_EQ(terrain().meshes[0].indices.size(), 3u * 100352u);
    EXPECT_EQ(terrain().meshes[0].vertices.size(), 225u * 225u) << "smooth and seamless: no vertex is split";
    EXPECT_EQ(terrain().images.size(), 1u);
    EXPECT_EQ(terrain().materials.size(), 1u);
}

TEST(BenchTerrain, FollowsItsFormulaUpToTheNoise)
{
    double mean = 0.0;
    for (const Vertex& vertex : terrain().meshes[0].vertices) {
        const vec3 p = vertex.position;
        ASSERT_LE(std::max(std::abs(p.x), std::abs(p.z)), 50.0f);
        const float rSquared = (p.x * p.x + p.z * p.z) / (50.0f * 50.0f);
        const float noise = (p.y / 12.0f - 0.6f * (3.0f * rSquared - 1.0f)) / 0.25f;
        ASSERT_LE(std::abs(noise), 1.001f) << p.x << " " << p.z;
        mean += noise / 50625.0;
    }
    EXPECT_LT(std::abs(mean), 0.2) << "the noise has a mean of its own";
}

TEST(BenchTerrain, HillsStandRoundALake)
{
    EXPECT_TRUE(terrain().water.present);
    EXPECT_EQ(terrain().water.level, 0.0f);
    for (const Vertex& vertex : terrain().meshes[0].vertices) {
        const float radius = std::hypot(vertex.position.x, vertex.position.z);
        if (radius < 20.0f) {
            EXPECT_LT(vertex.position.y, 0.0f) << radius;
        }
        if (radius > 35.0f) {
            EXPECT_GT(vertex.position.y, 0.0f) << radius;
        }
    }
}

TEST(BenchTerrain, IsSeenWholeFromAbove)
{
    const Camera* above = terrain().findCamera("above");
    ASSERT_NE(above, nullptr);
    const mat4 clipFromWorld = clipFromView(*above, 4.0f / 3.0f) * viewFromWorld(*above);
    for (const Vertex& vertex : terrain().meshes[0].vertices) {
        const vec4 clip = clipFromWorld * vec4(vertex.position, 1.0f);
        ASSERT_LT(std::max({std::abs(clip.x), std::abs(clip.y), std::abs(clip.z)}), clip.w);
    }
}

TEST(BenchTerrain, TheShoreIsWhereAPersonStands)
{
    const Camera* shore = terrain().findCamera("shore");
    ASSERT_NE(shore, nullptr);
    EXPECT_GT(shore->eye.y, 1.0f);
    EXPECT_LT(shore->eye.y, 3.0f);
}

} // namespace
} // namespace tarn
