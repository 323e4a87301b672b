// What the water may look up of the reflection's target, against rays mirrored one by one.
#include "plan/water_bounds.h"

#include "optics/refraction_camera.h"
#include "plan/frame_plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tarn {

namespace {

constexpr ivec2 size(640, 480);
constexpr float aspect = 640.0f / 480.0f;

WaterBody calmPond()
{
    WaterBody water;
    water.present = true;
    water.extent = vec2(8.0f, 6.0f);
    water.waves = {{0.004f, 1.3f, 0.3f, 0.0f, 0.0f}, {0.001f, 0.4f, 1.2f, 0.0f, 0.0f}};
    return water;
}

Camera onTheHill()
{
    Camera camera;
    camera.eye = vec3(3.0f, 14.0f, 30.0f);
    camera.target = vec3(0.0f, 1.0f, 0.0f);
    return camera;
}

/// How many looks of random facets, as steep as `slope` and no steeper, lie beside the bounds; U at any height that one
/// step of Newton's method may leave it at.
int looksBeside(const TargetBounds& bounds, const WaterBody& water, const Camera& camera, const Options& options,
                float slope)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    const float height = camera.eye.y - water.level;
    const mat4 mirror = glm::scale(mat4(1.0f), vec3(1.0f, -1.0f, 1.0f)); // the level is 0
    const mat4 clip = clipFromView(camera, aspect,
                                   optics::fovExtension(height, options.reflection.fovExtensionNear,
                                                        options.reflection.fovExtensionFar)) *
                      viewFromWorld(camera) * mirror;
    const mat4 picture = clipFromView(camera, aspect) * viewFromWorld(camera);
    const Bounds slab = waterBounds(water);
    int beside = 0;
    for (int i = 0; i < 200000; ++i) {
        vec3 u = slab.lower + vec3(unit(random), unit(random), unit(random)) * slab.extent();
        const vec4 seen = picture * vec4(u, 1.0f);
        if (seen.w <= 0.0f || std::abs(seen.x) > seen.w || std::abs(seen.y) > seen.w) continue;
        const vec3 ray = glm::normalize(u - camera.eye);
        u -= ray * 4.0f * (2.0f * unit(random) - 1.0f) * totalAmplitude(water) / ray.y; // as one step may
        const float direction = 2.0f * pi * unit(random), steep = slope * std::sqrt(unit(random));
        const vec3 normal = glm::normalize(vec3(-steep * std::cos(direction), 1.0f, -steep * std::sin(direction)));
        vec3 r = glm::reflect(ray, normal);
        r.y = std::abs(r.y);
        const float s = std::exp(20.0f * unit(random) - 6.0f);
        const vec4 look = clip * vec4(u + s * r, 1.0f);
        const vec2 at = glm::clamp(vec2(look) / std::max(look.w, 1.0e-6f), -1.0f, 1.0f);
        beside += glm::any(glm::lessThan(at, bounds.lower)) || glm::any(glm::greaterThan(at, bounds.upper)) ? 1 : 0;
    }
    return beside;
}

} // namespace

TEST(WaterBounds, NoLookLiesBesideThem)
{
    const WaterBody water = calmPond();
    const Camera camera = onTheHill();
    for (const auto facets : {ReflectionOptions::Facets::one, ReflectionOptions::Facets::five})
        for (const bool filters : {false, true}) {
            Options options;
            options.reflection.facets = facets;
            options.water.filterWaves = filters;
            const TargetBounds bounds = mirrorBounds(water, camera, options, size);
            ASSERT_LT(bounds.fraction(), 0.6f);
            const float slope = largestSlope(
                water, options, leastFootprint(water, camera, visibleCorners(water, camera, aspect), size));
            EXPECT_GT(slope, 0.01f);
            EXPECT_EQ(looksBeside(bounds, water, camera, options, slope), 0);
            EXPECT_GT(looksBeside(bounds, water, camera, options, 4.0f * slope), 0) << "or the bounds would say little";
        }
}

TEST(WaterBounds, WavesThatPixelsFoldAwayAreFacetsOfTheirDeviation)
{
    WaterBody water = calmPond();
    Options options;
    options.reflection.facets = ReflectionOptions::Facets::one;
    const float all = 2.0f * pi * (0.004f / 1.3f + 0.001f / 0.4f);
    EXPECT_NEAR(largestSlope(water, options, 0.0f), all, 1.0e-5f);
    EXPECT_LT(largestSlope(water, options, 2.0f), 0.01f * all);
    options.reflection.facets = ReflectionOptions::Facets::five;
    water.waves.resize(1);
    const float deviation = 2.0f * pi * 0.004f / 1.3f * 0.5f;
    EXPECT_NEAR(largestSlope(water, options, 10.0f), 2.857f * deviation, 1.0e-4f);
    options.water.filterWaves = false; // no facets then
    EXPECT_NEAR(largestSlope(water, options, 10.0f), 2.0f * deviation, 1.0e-5f);
}

TEST(WaterBounds, TheFootprintIsNoMoreThanThatOfFlatWater)
{
    const WaterBody water = calmPond();
    const Camera camera = onTheHill();
    const float footprint = leastFootprint(water, camera, visibleCorners(water, camera, aspect), size);
    const float pixel = 2.0f * std::tan(0.5f * camera.verticalFov) / 480.0f;
    EXPECT_LT(footprint, 30.0f * pixel);
    EXPECT_GT(footprint, 5.0f * pixel);
}

TEST(WaterBounds, WithoutABoundAllIsLookedUp)
{
    const Camera camera = onTheHill();
    Options options;
    EXPECT_FALSE(mirrorBounds(calmPond(), camera, options, size).isWhole());
    WaterBody steep = calmPond();
    steep.waves[0].amplitude = 0.3f;
    EXPECT_TRUE(mirrorBounds(steep, camera, options, size).isWhole());
    Options vertexNormals;
    vertexNormals.water.normals = WaterOptions::Normals::vertex;
    EXPECT_TRUE(mirrorBounds(calmPond(), camera, vertexNormals, size).isWhole());
    vertexNormals.frame.msaa = 1;
    EXPECT_FALSE(mirrorBounds(calmPond(), camera, vertexNormals, size).isWhole());
    vertexNormals.frame = {};
    vertexNormals.frame.antialiasing = FrameOptions::Antialiasing::fxaa;
    EXPECT_FALSE(mirrorBounds(calmPond(), camera, vertexNormals, size).isWhole());
    Camera low = camera;
    low.eye.y = 0.1f;
    EXPECT_TRUE(mirrorBounds(calmPond(), low, options, size).isWhole());
    low.eye = vec3(0.0f, 1.0f, 30.0f); // a triangle may be seen edge-on, and its plane beside it be anywhere
    low.target = vec3(0.0f, 0.5f, 0.0f);
    EXPECT_TRUE(mirrorBounds(calmPond(), low, options, size).isWhole());
    options.frame.msaa = 1;
    EXPECT_FALSE(mirrorBounds(calmPond(), low, options, size).isWhole());
}

} // namespace tarn
