// What is read back of a frame, against a reference that formulas give: still water over a level bed.
#include "test_renderer.h"
#include "test_scenes.h"

#include "gl/shader_library.h"
#include "measure/error_map.h"
#include "measure/water_errors.h"
#include "optics/optics.h"
#include "render/renderer.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tarn::test {

namespace {

using glm::dvec3;
using reference::Event;

constexpr ivec2 pictureSize(160, 120);
constexpr float depth = 2.0f;

Camera lookDown()
{
    Camera camera;
    camera.eye = vec3(0.0f, 2.0f, 0.0f);
    camera.target = vec3(0.0f, 0.0f, -2.0f);
    camera.farPlane = 300.0f;
    return camera;
}

/// Exact refraction and reflection; light: of every point of the bed.
reference::Picture exactPicture(const Camera& camera, double light)
{
    reference::Picture truth(pictureSize);
    const float aspect = static_cast<float>(pictureSize.x) / static_cast<float>(pictureSize.y);
    const glm::dmat4 worldFromClip =
        glm::inverse(glm::dmat4(clipFromView(camera, aspect)) * glm::dmat4(viewFromWorld(camera)));
    for (std::size_t i = 0; i < truth.pixels(); ++i) {
        const auto x = static_cast<double>(i % static_cast<std::size_t>(pictureSize.x));
        const auto y = static_cast<double>(i / static_cast<std::size_t>(pictureSize.x));
        const glm::dvec4 far = worldFromClip * glm::dvec4(2.0 * (x + 0.5) / pictureSize.x - 1.0,
                                                          1.0 - 2.0 * (y + 0.5) / pictureSize.y, 1.0, 1.0);
        const dvec3 ray = glm::normalize(dvec3(far) / far.w - dvec3(camera.eye)), up(0.0, 1.0, 0.0);
        if (ray.y > -0.05) continue; // the horizon and what is near it
        const dvec3 surface = dvec3(camera.eye) - ray * (static_cast<double>(camera.eye.y) / ray.y);
        const dvec3 refracted = optics64::refractRay(ray, up, 1.0 / 1.33);
        truth.surface[i] = vec3(surface);
        truth.normal[i] = vec3(up);
        truth.path[i] = static_cast<float>(depth / -refracted.y);
        truth.refractionHit[i] = vec3(surface + refracted * (depth / -refracted.y));
        truth.fresnel[i] = static_cast<float>(optics64::fresnelExact(-ray.y, 1.0 / 1.33));
        truth.caustics[i] = vec3(static_cast<float>(light));
        truth.events[i] = Event::meetsWater | Event::refracted | Event::refractionHit | Event::causticsKnown;
    }
    return truth;
}

} // namespace

TEST(Quantities, OfStillWaterAreTheFormulas)
{
    Scene scene = flatLake(depth);
    scene.sun = Sun{normalize(vec3(1.0f, 2.0f, 0.0f)), vec3(10.0f), false};
    Options options;
    options.refraction.steps = 8;
    TestRenderer test(scene, options);
    const Camera camera = lookDown();
    const WaterQuantities used = readQuantities(test.renderer, camera, 0.0, pictureSize);
    EXPECT_EQ(used.display.width, pictureSize.x);
    EXPECT_EQ(used.linear.height, pictureSize.y);

    const double cosine = static_cast<double>(scene.sun->direction.y);
    const double light = 1.0 - optics64::fresnelExact(cosine, 1.0 / 1.33);
    const reference::Picture truth = exactPicture(camera, light);
    ErrorFigures figures = errorFigures(used, truth);
    EXPECT_LT(figures.refractionMedian, 0.005);
    EXPECT_LT(figures.refractionP95, 0.05);
    EXPECT_LT(figures.refractionWrongTexel, 0.01);
    EXPECT_LT(figures.reflectionMax, 0.2);
    EXPECT_LT(figures.fresnelMax, 1e-5);
    options.water.fresnel = WaterOptions::Fresnel::schlick;
    test.renderer.setOptions(options, scene.water);
    const ErrorFigures bySchlick = errorFigures(readQuantities(test.renderer, camera, 0.0, pictureSize), truth);
    EXPECT_LT(bySchlick.fresnelMax, 0.065);
    EXPECT_GT(bySchlick.fresnelMax, 0.01);
    EXPECT_LT(figures.pathMedian, 0.005);
    const WaterAgreement agreement = waterAgreement(used, truth);
    EXPECT_EQ(agreement.onlyTruth, 0u);
    EXPECT_GT(agreement.both, used.pixels() / 2);

    ASSERT_TRUE(used.caustics);
    addCausticsFigures(figures, *used.caustics, [&](const vec2&) { return vec3(static_cast<float>(light)); });
    EXPECT_LT(figures.causticsRmse, 0.02);
    EXPECT_NEAR(figures.causticsEnergy, 1.0, 0.01);
    const Image map = errorMap(ErrorKind::caustics, used, truth);
    std::size_t known = 0;
    for (const float error : map.floats) {
        if (std::isnan(error)) continue;
        ++known;
        EXPECT_LT(error, 0.05f);
    }
    EXPECT_GT(known, used.pixels() / 4);
}

// The footprint is the distance over the target's resolution: half the texels, twice the metres.
TEST(Quantities, ATexelsFootprintFollowsTheTarget)
{
    const Scene scene = flatLake(depth);
    Options options;
    options.refraction.camera = RefractionOptions::CameraMode::main;
    options.refraction.fovExtensionNear = options.refraction.fovExtensionFar = 1.0f;
    TestRenderer test(scene, options);
    Camera camera = lookDown();
    camera.verticalFov = glm::radians(90.0f);
    const vec3 point(0.0f, -2.0f, -3.0f);
    WaterQuantities used = readQuantities(test.renderer, camera, 0.0, pictureSize);
    // At 5 m a target of 512 texels spans 10 m from top to bottom and a third more across.
    EXPECT_NEAR(used.footprint.at(point), 10.0 * 4.0 / 3.0 / 512.0, 1e-5);
    options.refraction.targetSize = 256;
    test.renderer.setOptions(options, scene.water);
    used = readQuantities(test.renderer, camera, 0.0, pictureSize);
    EXPECT_NEAR(used.footprint.at(point), 10.0 * 4.0 / 3.0 / 256.0, 1e-5);
}

TEST(Quantities, ADryBasinHasNone)
{
    Scene scene = flatLake(depth);
    scene.water.present = false;
    TestRenderer test(scene, {});
    const Camera camera = lookDown();
    const WaterQuantities used = readQuantities(test.renderer, camera, 0.0, pictureSize);
    EXPECT_FALSE(used.caustics);
    const WaterAgreement agreement = waterAgreement(used, exactPicture(camera, 1.0));
    EXPECT_EQ(agreement.both + agreement.onlyUsed, 0u);
    for (const FigureField& field : errorFigureFields())
        EXPECT_TRUE(std::isnan(errorFigures(used, exactPicture(camera, 1.0)).*field.member)) << field.name;
}

// A setting that is known to be worse is measured as worse.
TEST(Quantities, ThePlanarLookupIsWorseThanTheIterative)
{
    const Scene scene = flatLake(depth);
    const Camera camera = lookDown();
    const reference::Picture truth = exactPicture(camera, 1.0);
    Options options;
    options.refraction.camera = RefractionOptions::CameraMode::main;
    TestRenderer test(scene, options);
    const auto median = [&] {
        test.renderer.setOptions(options, scene.water);
        return errorFigures(readQuantities(test.renderer, camera, 0.0, pictureSize), truth).refractionMedian;
    };
    const double iterative = median();
    options.refraction.method = RefractionOptions::Method::planar;
    const double planar = median();
    EXPECT_GT(planar, 2.0 * iterative);
    EXPECT_GT(planar, 0.02);
}

} // namespace tarn::test
