// What Lipp's water shader does at the surface, in whole frames whose picture a formula gives.
#include "gl_test.h"
#include "test_renderer.h"
#include "test_scenes.h"

#include "optics/optics.h"
#include "render/renderer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

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
    CheckedRenderer renderer(scene, options);
    for (const float length : {7.5f, 4.0f, 2.0f}) {
        options.water.attenuationLength = length;
        renderer.setOptions(options, scene.water);
        const vec4 centre = pixel(renderer.linear(upright(1.6f), pictureSize), middle.x, middle.y);
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
    CheckedRenderer renderer(scene, options);
    const Image exponential = renderer.linear(upright(-1.5f), pictureSize);
    ASSERT_EQ(renderer.stats.plan.side, WaterSide::below);
    options.water.attenuation = WaterOptions::Attenuation::linear;
    renderer.setOptions(options, scene.water);
    EXPECT_EQ(renderer.linear(upright(-1.5f), pictureSize).floats, exponential.floats);
}

// A black sky and a black bed: all that is seen of still water is the highlight.
TEST(PhongHighlight, IsTheFormulasOverTheWholePicture)
{
    Scene scene = flatLake(3.0f);
    scene.sky.radiance = vec3(0.0f);
    scene.materials[0].diffuse = vec3(0.0f);
    scene.sun = Sun{normalize(vec3(0.03f, 1.0f, -0.02f)), vec3(10.0f, 5.0f, 1.0f), false};
    Options options = oneSample();
    options.caustics.enabled = options.sunlight.shadows = options.glow.enabled = false;
    options.water.specular = WaterOptions::Specular::phong;
    options.water.phongExponent = 64.0f;
    options.water.phongStrength = 3.0f;
    CheckedRenderer renderer(scene, options);
    const Camera camera = upright(1.6f);
    const Image image = renderer.linear(camera, pictureSize);
    const Image places = renderer.linear(camera, pictureSize, 0.0, DebugView::positionU);
    double brightest = 0.0;
    for (int y = 0; y < pictureSize.y; ++y)
        for (int x = 0; x < pictureSize.x; ++x) {
            const glm::dvec3 U(vec3(pixel(places, x, y)));
            const glm::dvec3 toEye = glm::normalize(glm::dvec3(camera.eye) - U), sun(scene.sun->direction);
            // Lipp: (R_L·E)^n · colour · strength · F, with R_L the light mirrored about the normal.
            const glm::dvec3 mirrored(-sun.x, sun.y, -sun.z);
            const double f = optics64::fresnelExact(toEye.y, 1.0 / 1.33);
            const double lobe = std::pow(glm::dot(mirrored, toEye), 64.0);
            for (int c = 0; c < 3; ++c) {
                const double colour = static_cast<double>(scene.sun->irradiance[c]) / std::numbers::pi;
                const double expected = f * 3.0 * colour * lobe;
                EXPECT_NEAR(pixel(image, x, y)[c], expected, 0.003 * expected + 1e-6) << x << ", " << y;
                brightest = std::max(brightest, expected);
            }
        }
    EXPECT_GT(brightest, 0.19); // the mirrored sun is in the picture: F is 0.02
}

// Straight down all light of the bed passes, but for the beam's spreading; no sky, no sun.
TEST(NoReflection, ShowsTheRefractedBedAlone)
{
    Scene scene = flatLake(3.0f);
    scene.sun = Sun{vec3(0.0f, 1.0f, 0.0f), vec3(1.0f), false}; // mirrored into the picture's middle
    Options options = oneSample();
    options.caustics.enabled = options.sunlight.shadows = false;
    options.water.reflects = false;
    CheckedRenderer renderer(scene, options);
    const vec4 centre = pixel(renderer.linear(upright(1.6f), pictureSize), middle.x, middle.y);
    EXPECT_FALSE(renderer.stats.plan[PassId::reflection].wanted);
    EXPECT_FALSE(renderer.stats.plan[PassId::glow].wanted);
    const double transmitted = 1.0 - optics64::fresnelExact(1.0, 1.0 / 1.33);
    const double expected = (bedRadiance + 0.5 / std::numbers::pi * transmitted) / (1.33 * 1.33);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(centre[c], expected, 0.005 * expected);
    EXPECT_EQ(pixel(renderer.linear(upright(1.6f), pictureSize, 0.0, DebugView::fresnel), middle.x, middle.y).x, 0.0f);
    // No pixel claims to have mirrored anything.
    EXPECT_EQ(pixel(renderer.linear(upright(1.6f), pictureSize, 0.0, DebugView::reflectionHit), middle.x, middle.y).w,
              0.0f);
}

// From below: the sky by n² inside Snell's window, the water's colour outside it.
TEST(NoReflection, FromBelowTheWindowIsWhole)
{
    Scene scene = flatLake(3.0f);
    scene.water.colour = vec3(0.2f);
    Options options = oneSample();
    options.water.reflects = false;
    CheckedRenderer renderer(scene, options);
    Camera camera = upright(-1.5f);
    camera.verticalFov = glm::radians(120.0f);
    const Image image = renderer.linear(camera, pictureSize);
    ASSERT_EQ(renderer.stats.plan.side, WaterSide::below);
    for (int x = 0; x < pictureSize.x; ++x) {
        const double tangent = (2.0 * (x + 0.5) / pictureSize.x - 1.0) * std::tan(glm::radians(60.0)) * 4.0 / 3.0;
        const double angle = glm::degrees(std::atan(std::abs(tangent)));
        if (std::abs(angle - 48.75) < 2.0) continue; // the rim
        const double expected = angle < 48.75 ? 1.33 * 1.33 : 0.2 * 0.934;
        EXPECT_NEAR(pixel(image, x, middle.y).x, expected, 0.005 * expected) << angle << " degrees";
    }
}

TEST(PhongHighlight, ASunBelowTheHorizonHasNone)
{
    Scene scene = flatLake(3.0f);
    scene.sun = Sun{normalize(vec3(0.0f, -1.0f, -0.3f)), vec3(10.0f), false};
    Options options = oneSample();
    options.water.specular = WaterOptions::Specular::phong;
    options.water.phongStrength = 0.0f;
    CheckedRenderer renderer(scene, options);
    const Image none = renderer.linear(upright(1.6f), pictureSize);
    options.water.phongStrength = 100.0f;
    renderer.setOptions(options, scene.water);
    EXPECT_EQ(renderer.linear(upright(1.6f), pictureSize).floats, none.floats);
}

} // namespace tarn::test
