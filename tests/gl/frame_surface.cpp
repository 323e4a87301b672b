// What Lipp's water shader does at the surface, in whole frames whose picture a formula gives.
#include "gl_test.h"
#include "studio.h"
#include "test_scenes.h"

#include "optics/optics.h"
#include "render/renderer.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tarn::test {

namespace {

constexpr ivec2 pictureSize(64, 48);
constexpr ivec2 middle(pictureSize.x / 2, pictureSize.y / 2);

/// Straight down from a height over the level, or straight up from under it.
Camera upright(float height)
{
    Camera camera;
    camera.eye = vec3(0.0f, height, 0.0f);
    camera.target = vec3(0.0f);
    camera.up = vec3(0.0f, 0.0f, -1.0f);
    camera.verticalFov = glm::radians(20.0f);
    return camera;
}

Options oneSample()
{
    Options options;
    options.frame.msaa = 1;
    return options;
}

/// Radiance of a bed of albedo 1/2 under water that takes nothing away and a sky of radiance 1.
constexpr double bedRadiance = 0.5 * 0.934;

} // namespace

// The bed's light less in proportion to the path, whatever the absorption is; the water's own colour in its place.
TEST(LinearAttenuation, MixesBedAndDeepWaterByThePath)
{
    const float depth = 3.0f;
    Scene scene = flatLake(depth);
    scene.water.colour = vec3(0.0f, 0.2f, 0.1f);
    Options options = oneSample();
    options.water.attenuation = WaterOptions::Attenuation::linear;
    Studio studio(scene, options);
    for (const float length : {7.5f, 4.0f, 2.0f}) {
        options.water.attenuationLength = length;
        studio.setOptions(options, scene.water);
        const vec4 centre = pixel(studio.linear(upright(1.6f), pictureSize), middle.x, middle.y);
        const double kept = std::max(1.0 - static_cast<double>(depth / length), 0.0);
        const double f = optics64::fresnelExact(1.0, 1.0 / 1.33);
        for (int c = 0; c < 3; ++c) {
            const double deep = static_cast<double>(scene.water.colour[c]) * 0.934;
            const double expected = f + (1.0 - f) / (1.33 * 1.33) * (kept * bedRadiance + (1.0 - kept) * deep);
            EXPECT_NEAR(centre[c], expected, 0.005 * expected) << "length " << length << ", channel " << c;
        }
    }
}

TEST(LinearAttenuation, LeavesTheViewFromBelowAlone)
{
    Scene scene = flatLake(3.0f);
    scene.water.colour = vec3(0.0f, 0.2f, 0.1f);
    scene.water.absorption = vec3(0.5f, 0.2f, 0.1f);
    Options options = oneSample();
    Studio studio(scene, options);
    const Image exponential = studio.linear(upright(-1.5f), pictureSize);
    ASSERT_EQ(studio.stats.plan.side, WaterSide::below);
    options.water.attenuation = WaterOptions::Attenuation::linear;
    studio.setOptions(options, scene.water);
    EXPECT_EQ(studio.linear(upright(-1.5f), pictureSize).floats, exponential.floats);
}

} // namespace tarn::test
