// Shadows of the sun where geometry puts them, above the water and below it, and none where there are none.
#include "gl_test.h"
#include "test_renderer.h"
#include "test_scenes.h"

#include "optics/optics.h"
#include "render/renderer.h"
#include "render/sun_views.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tarn::test {

namespace {

constexpr ivec2 pictureSize(240, 240);
constexpr float halfPicture = 3.0f; // m that the downward camera sees to each side, at the floor

/// A camera that looks straight down on a floor from 20 m, x to the right, -z up.
Camera above(float floorHeight)
{
    Camera camera;
    camera.eye = vec3(0.0f, floorHeight + 20.0f, 0.0f);
    camera.target = vec3(0.0f, floorHeight, 0.0f);
    camera.up = vec3(0.0f, 0.0f, -1.0f);
    camera.verticalFov = 2.0f * std::atan(halfPicture / 20.0f);
    return camera;
}

Image rendered(const Scene& scene, const Camera& camera, Options options)
{
    options.frame.msaa = 1;
    return CheckedRenderer(scene, options).linear(camera, pictureSize);
}

/// Red of the pixel that sees the floor at (x, z).
float seenAt(const Image& image, float x, float z)
{
    const auto column = static_cast<std::size_t>((x / halfPicture * 0.5f + 0.5f) * static_cast<float>(pictureSize.x));
    const auto row = static_cast<std::size_t>((z / halfPicture * 0.5f + 0.5f) * static_cast<float>(pictureSize.y));
    return image.floats[(row * static_cast<std::size_t>(pictureSize.x) + column) * 4];
}

Scene sunlit(float elevationDegrees, float floorHeight)
{
    Scene scene = flatLake(-floorHeight, 40.0f);
    scene.sky.radiance = vec3(0.0f);
    const float e = glm::radians(elevationDegrees);
    scene.sun = Sun{vec3(std::cos(e), std::sin(e), 0.0f), vec3(2.0f), false};
    return scene;
}

} // namespace

// A plate one metre over a dry floor: its shadow lies a metre's cotangent aside, and the rest is lit evenly.
TEST(FrameSunlight, AShadowInTheAirLiesWhereTheSunPutsIt)
{
    for (const float elevation : {70.0f, 45.0f, 25.0f}) {
        Scene scene = sunlit(elevation, 0.0f);
        scene.water.present = false;
        scene.water.level = 0.6f; // where there is no water, its level divides nothing
        addBox(scene, {2.0f, 1.0f, -0.5f}, {3.5f, 1.01f, 0.5f}, 0);
        Options options;
        options.sunlight.mapSize = 2048;
        const Image image = rendered(scene, above(0.0f), options);
        const float shift = 1.0f / std::tan(glm::radians(elevation));
        const float lit = 0.5f / pi * 2.0f * std::sin(glm::radians(elevation));
        const float texel = 40.0f / 2048.0f;
        const float pixel = 2.0f * halfPicture / static_cast<float>(pictureSize.x);
        int wrong = 0;
        for (float z = -1.5f; z < 1.5f; z += 0.05f) {
            for (float x = -2.5f; x < 1.9f; x += 0.05f) { // the plate itself is to the right of that
                // The upper face's edge towards the sun and the lower one's away from it bound the shadow.
                const float fromX = std::min(x - (2.0f - 1.01f * shift), 3.5f - shift - x);
                const float inside = std::min(fromX, 0.5f - std::abs(z));
                if (std::abs(inside) < 2.0f * texel + pixel + 0.02f * shift) continue;
                const float expected = inside > 0.0f ? 0.0f : lit;
                if (std::abs(seenAt(image, x, z) - expected) > 0.01f * lit) ++wrong;
            }
        }
        EXPECT_EQ(wrong, 0) << "sun at " << elevation << " degrees";
    }
}

// Under water the sun's direction is the refracted one. The eye is in the water as well, so that nothing else bends.
TEST(FrameSunlight, AShadowUnderWaterLiesAlongTheRefractedSun)
{
    Scene scene = sunlit(45.0f, -30.0f);
    scene.water.extent = vec2(60.0f);
    const float plate = -29.0f;
    addBox(scene, {1.7f, plate, -0.5f}, {3.5f, plate + 0.01f, 0.5f}, 0);
    Options options;
    options.caustics.enabled = false;
    options.sunlight.mapSize = 4096;
    const Image image = rendered(scene, above(-30.0f), options);
    const vec3 below = optics::refractedSunDirection(scene.sun->direction, scene.water.ior);
    const float shift = below.x / below.y;
    ASSERT_LT(shift, 0.7f); // 1 in the air
    int wrong = 0;
    const float lit = seenAt(image, -2.0f, 2.0f);
    // E · cos · T on level ground; the facing irradiance times the cosine.
    const float facing = optics::sunIrradianceBelow(vec3(2.0f), scene.sun->direction.y, scene.water.ior).x;
    EXPECT_NEAR(lit, 0.5f / pi * facing * below.y, 0.01f * lit);
    for (float z = -1.5f; z < 1.5f; z += 0.05f) {
        for (float x = -2.5f; x < 1.5f; x += 0.05f) {
            const float inside = std::min(x - (1.7f - 1.01f * shift), 0.5f - std::abs(z));
            if (std::abs(inside) < 0.12f) continue;
            const float expected = inside > 0.0f ? 0.0f : lit;
            if (std::abs(seenAt(image, x, z) - expected) > 0.01f * lit) ++wrong;
        }
    }
    EXPECT_EQ(wrong, 0);
}

// A shore far beyond the water has shadows as well, from the map between and from the last.
TEST(FrameSunlight, FurtherMapsShadeWhatIsBeyondTheShore)
{
    for (const float pondAt : {3.0f, 15.0f}) {
        Scene scene = sunlit(45.0f, 0.5f);
        scene.water.centre = vec2(pondAt);
        scene.water.extent = vec2(1.0f);
        addBox(scene, {2.0f, 1.5f, -0.5f}, {3.5f, 1.51f, 0.5f}, 0);
        const Bounds bounds = worldBounds(scene);
        Options options;
        const SunVolume volume = sunVolume(scene.water, bounds, scene.sun->direction, options.sunlight);
        ASSERT_EQ(volume.cascades.size(), 3u);
        for (std::size_t i = 1; i < 3; ++i) {
            const LevelRect &inner = volume.cascades[i - 1], &outer = volume.cascades[i];
            EXPECT_TRUE(glm::all(glm::lessThanEqual(glm::abs(inner.centre - outer.centre) + inner.halfExtent,
                                                    outer.halfExtent + 1.0e-3f)));
        }
        const float lit = 0.5f / pi * 2.0f * std::sin(glm::radians(45.0f));
        const Image shadowed = rendered(scene, above(0.5f), options);
        int wrong = 0;
        for (float z = -1.5f; z < 1.5f; z += 0.05f) {
            for (float x = -1.0f; x < 1.9f; x += 0.05f) {
                const float inside = std::min(x - 0.99f, 0.5f - std::abs(z));
                if (std::abs(inside) < 0.1f) continue;
                if (std::abs(seenAt(shadowed, x, z) - (inside > 0.0f ? 0.0f : lit)) > 0.01f * lit) ++wrong;
            }
        }
        EXPECT_EQ(wrong, 0) << "pond at " << pondAt;
        options.sunlight.cascades = 1;
        EXPECT_EQ(sunVolume(scene.water, bounds, scene.sun->direction, options.sunlight).cascades.size(), 1u);
        EXPECT_NEAR(seenAt(rendered(scene, above(0.5f), options), 1.5f, 0.0f), lit, 0.01f * lit);
    }
}

// Slopes towards and away from the sun cast nothing on themselves.
TEST(FrameSunlight, NoAcneOnSlopes)
{
    for (const float elevation : {60.0f, 30.0f, 12.0f}) {
        Scene scene = sunlit(elevation, 0.0f);
        scene.water.present = false;
        for (Element& element : scene.elements) element.rotation.z = glm::radians(-8.0f);
        Options with, without;
        with.sunlight.mapSize = 512; // texels of 8 cm
        without.sunlight.shadows = false;
        const Image shadowed = rendered(scene, above(0.0f), with);
        const Image plain = rendered(scene, above(0.0f), without);
        for (std::size_t i = 0; i < plain.floats.size(); i += 4)
            ASSERT_NEAR(shadowed.floats[i], plain.floats[i], 1.0e-3f * plain.floats[i] + 1.0e-6f) << elevation;
    }
}

// The maps do not depend on the eye, and are drawn only when what they hold has changed.
TEST(FrameSunlight, MapsAreDrawnOnce)
{
    Scene scene = sunlit(45.0f, -2.0f);
    Options options;
    CheckedRenderer renderer(scene, options);
    Camera camera = above(0.0f);
    const auto trianglesOfMaps = [&] {
        renderer.linear(camera, {64, 64});
        EXPECT_EQ(renderer.stats.passes.front().name, "sunlight");
        return renderer.stats.passes.front().triangles;
    };
    EXPECT_GT(trianglesOfMaps(), 0u);
    camera.eye.x += 1.0f;
    EXPECT_EQ(trianglesOfMaps(), 0u);
    WaterBody higher = scene.water;
    higher.level = 0.5f;
    renderer.setOptions(options, higher);
    EXPECT_GT(trianglesOfMaps(), 0u);
}

} // namespace tarn::test
