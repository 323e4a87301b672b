// Ripples of a normal map on the drawn surface: against formulas, and against the reference.
#include "gl/shader_library.h"
#include "test_renderer.h"
#include "test_scenes.h"

#include "measure/water_errors.h"
#include "measure/water_quantities.h"
#include "optics/optics.h"
#include "reference/reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tarn::test {

namespace {

constexpr ivec2 pictureSize(160, 120);
constexpr double time = 1.7;

Camera overTheWater()
{
    Camera camera;
    camera.eye = vec3(0.2f, 2.0f, 0.1f);
    camera.target = vec3(0.0f, 0.0f, -2.0f);
    camera.farPlane = 300.0f;
    return camera;
}

vec2 twoSines(const vec2& uv)
{
    constexpr float twoPi = 2.0f * std::numbers::pi_v<float>;
    return vec2(0.1f * std::cos(twoPi * (2.0f * uv.x + uv.y)), 0.12f * std::sin(twoPi * (uv.y - uv.x)));
}

/// Largest difference of a pixel's values.
float difference(const Image& a, const Image& b)
{
    float largest = a.floats.size() == b.floats.size() ? 0.0f : 1e9f;
    for (std::size_t i = 0; i < a.floats.size(); ++i) largest = std::max(largest, std::abs(a.floats[i] - b.floats[i]));
    return largest;
}

Scene wavyLake()
{
    Scene scene = flatLake(2.0f);
    scene.sun = Sun{normalize(vec3(0.2f, 1.0f, -0.6f)), vec3(1.0f), false};
    scene.water.waves = {{0.03f, 2.3f, 0.3f, 0.4f, 0.0f}, {0.01f, 0.9f, 1.7f, 1.1f, 0.0f}};
    return scene;
}

} // namespace

TEST(Ripples, AFlatMapChangesNothing)
{
    const Scene plain = wavyLake();
    Scene rippled = plain;
    addNormalMap(rippled, 8, [](const vec2&) { return vec2(0.0f); });
    rippled.water.normalMap.bump = 0.2f;
    for (const bool filters : {true, false}) {
        Options options;
        options.water.filterWaves = filters;
        CheckedRenderer without(plain, options), with(rippled, options);
        for (const DebugView view : {DebugView::final, DebugView::normals, DebugView::positionW}) {
            const Image expected = without.linear(overTheWater(), pictureSize, time, view);
            EXPECT_LT(difference(with.linear(overTheWater(), pictureSize, time, view), expected), 1e-3f)
                << debugViewNames[static_cast<std::size_t>(view)];
        }
    }
}

TEST(Ripples, SwitchedOffTheyAreNotThere)
{
    const Scene plain = wavyLake();
    Scene rippled = plain;
    addNormalMap(rippled, 8, [](const vec2&) { return vec2(0.3f, 0.1f); });
    rippled.water.normalMap.enabled = false;
    CheckedRenderer without(plain), with(rippled);
    EXPECT_EQ(with.linear(overTheWater(), pictureSize, time).floats,
              without.linear(overTheWater(), pictureSize, time).floats);
}

// A map of one tilt is a tilted plane, plain or steepened, with normals of pixels or of vertices.
TEST(Ripples, OneTiltGivesTheNormalOfTheFormula)
{
    Scene scene = flatLake(2.0f);
    addNormalMap(scene, 8, [](const vec2&) { return vec2(0.12f, -0.05f); });
    Options options;
    CheckedRenderer renderer(scene, options);
    for (const auto normals : {WaterOptions::Normals::pixel, WaterOptions::Normals::vertex})
        for (const bool filters : {true, false})
            for (const float bump : {1.0f, 0.4f}) {
                options.water.normals = normals;
                options.water.filterWaves = filters;
                scene.water.normalMap.bump = bump;
                renderer.setOptions(options, scene.water);
                const vec3 expected = glm::normalize(vec3(-0.12f, bump, 0.05f));
                const Image image = renderer.linear(overTheWater(), pictureSize, time, DebugView::normals);
                int wrong = 0;
                for (int y = pictureSize.y / 2; y < pictureSize.y; ++y)
                    for (int x = 0; x < pictureSize.x; ++x)
                        wrong += glm::distance(vec3(pixel(image, x, y)), expected) > 1e-3f;
                EXPECT_EQ(wrong, 0) << bump;
            }
}

// The same picture, the same layers, the same filter: what the frame draws is what the reference traces.
TEST(Ripples, FrameAndReferenceAgreeOnAPlaneOverABed)
{
    Scene scene = flatLake(2.0f);
    addNormalMap(scene, 64, twoSines);
    scene.water.normalMap.tile = 1.5f;
    scene.water.normalMap.bump = 0.7f;
    Options options;
    options.water.filterWaves = false; // the reference looks at points
    options.refraction.steps = 8;
    options.refraction.targetSize = 1024;
    const auto shaders = makeShaderLibrary();
    gl::Profiler profiler;
    Renderer renderer(scene, options, *shaders, profiler);
    const Camera camera = overTheWater();
    const auto truthAt = [&](const WaterBody& water) {
        return reference::Tracer(scene, water)
            .quantities({.camera = camera, .time = time, .size = pictureSize, .approximations = {}}, {.photons = 1000});
    };
    const reference::Picture truth = truthAt(scene.water);
    const WaterQuantities used = readQuantities(renderer, camera, time, pictureSize);
    const ErrorFigures figures = errorFigures(used, truth);
    EXPECT_LT(figures.refractionMedian, 0.003);
    EXPECT_LT(figures.refractionP95, 0.02);
    EXPECT_LT(figures.reflectionMedian, 0.1);
    EXPECT_LT(figures.fresnelMean, 1e-3);

    // Without the map, or with its layers a second on, the errors are those of another surface.
    WaterBody level = scene.water;
    level.normalMap.enabled = false;
    EXPECT_GT(errorFigures(used, truthAt(level)).refractionMedian, 0.02);
    WaterBody drifted = scene.water;
    for (auto& layer : drifted.normalMap.layers) layer.velocity *= 1.5f;
    EXPECT_GT(errorFigures(used, truthAt(drifted)).refractionMedian, 0.02);
}

// Where a pixel spans many tiles the mean normal is level and all of the map's variance is roughness.
TEST(Ripples, FarAwayTheyAreRoughness)
{
    Scene scene = flatLake(2.0f, 2000.0f);
    addNormalMap(scene, 64, twoSines);
    scene.water.normalMap.tile = 0.05f;
    Camera camera = overTheWater();
    camera.eye.y = 30.0f;
    camera.target = vec3(0.0f, 0.0f, -60.0f);
    Options options;
    CheckedRenderer renderer(scene, options);
    const Image normals = renderer.linear(camera, pictureSize, time, DebugView::normals);
    for (int x = 0; x < pictureSize.x; ++x) EXPECT_GT(pixel(normals, x, pictureSize.y / 2).y, 0.9999f) << x;

    // A rough mirror spreads the sun: beside its image there is light that a smooth one has not.
    scene.sky.radiance = vec3(0.0f);
    scene.materials[0].diffuse = vec3(0.0f);
    scene.sun = Sun{normalize(vec3(0.0f, 30.0f, -60.0f)), vec3(10.0f), false};
    CheckedRenderer rough(scene, options);
    scene.water.normalMap.enabled = false;
    CheckedRenderer smooth(scene, options);
    // As many pixels beside the mirrored sun, in the picture's middle, as turn a facet by 2.5 degrees.
    const int beside = pictureSize.x / 2 + 12;
    EXPECT_GT(pixel(rough.linear(camera, pictureSize, time), beside, pictureSize.y / 2).x,
              2.0f * pixel(smooth.linear(camera, pictureSize, time), beside, pictureSize.y / 2).x);
}

// Lipp's highlight is about the unsteepened normal: the bump factor does not move it.
TEST(Ripples, ThePhongHighlightIsNotSteepened)
{
    Scene scene = flatLake(2.0f);
    scene.sky.radiance = vec3(0.0f);
    scene.materials[0].diffuse = vec3(0.0f);
    const vec3 normal = glm::normalize(vec3(-0.1f, 1.0f, 0.0f));
    addNormalMap(scene, 8, [](const vec2&) { return vec2(0.1f, 0.0f); });
    Camera camera = overTheWater();
    camera.eye = vec3(0.0f, 2.0f, 0.0f);
    camera.target = vec3(0.0f);
    camera.up = vec3(0.0f, 0.0f, -1.0f);
    scene.sun = Sun{glm::reflect(vec3(0.0f, -1.0f, 0.0f), normal), vec3(10.0f), false};
    Options options;
    options.frame.msaa = 1;
    options.glow.enabled = false;
    options.water.specular = WaterOptions::Specular::phong;
    for (const float bump : {1.0f, 0.5f}) {
        scene.water.normalMap.bump = bump;
        CheckedRenderer renderer(scene, options);
        const vec4 centre = pixel(renderer.linear(camera, pictureSize, time), pictureSize.x / 2, pictureSize.y / 2);
        const double cosine = static_cast<double>(glm::normalize(vec3(-0.1f, bump, 0.0f)).y);
        const double expected = 2.0 * optics64::fresnelExact(cosine, 1.0 / 1.33) * 10.0 / std::numbers::pi;
        EXPECT_NEAR(centre.x, expected, 0.03 * expected) << bump;
    }
}

} // namespace tarn::test
