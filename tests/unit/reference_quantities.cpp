// The reference's geometry against closed forms: where rays meet the water and the bed, and what share is reflected.
#include "optics/water_grid.h"
#include "optics/waves.h"
#include "reference/reference.h"
#include "test_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tarn {
namespace {

using glm::dvec3;
using reference::Event;
using reference::Picture;
using reference::Tracer;

constexpr double ior = 1.33;

Camera cameraAt(const vec3& eye, const vec3& target, float degrees = 50.0f)
{
    Camera camera;
    camera.eye = eye;
    camera.target = target;
    camera.verticalFov = glm::radians(degrees);
    return camera;
}

Picture quantitiesOf(const Scene& scene, const Camera& camera, ivec2 size = {64, 48}, double time = 0.0)
{
    const Tracer tracer(scene, scene.water);
    return tracer.quantities({.camera = camera, .time = time, .size = size, .approximations = {}}, {.photons = 10000});
}

void addWaves(Scene& scene)
{
    scene.water.waves = {
        {0.06f, 2.3f, 0.3f, 0.4f, 0.0f}, {0.03f, 0.9f, 1.7f, 1.1f, 0.0f}, {0.01f, 0.3f, -0.6f, 2.0f, 0.0f}};
}

std::vector<optics64::WaveTerm> termsOf(const Scene& scene)
{
    std::vector<optics64::WaveTerm> terms;
    for (const Wave& w : scene.water.waves)
        terms.push_back(optics64::makeWaveTerm(w.amplitude, w.wavelength, w.direction, w.phase, w.period));
    return terms;
}

// An oblique frustum's pixels see what the passes' matrices put there.
TEST(ReferenceQuantities, AShiftedLensSeesWhatItsMatrixShows)
{
    Scene scene = test::flatLake(2.0f);
    addWaves(scene);
    Camera camera = cameraAt({0.0f, 3.0f, 0.0f}, {0.0f, 0.0f, -4.0f});
    camera.lensShift = 0.3f;
    const ivec2 size(64, 48);
    const Picture picture = quantitiesOf(scene, camera, size);
    const glm::dmat4 clipFromWorld =
        glm::dmat4(clipFromView(camera, 64.0f / 48.0f)) * glm::dmat4(viewFromWorld(camera));
    std::size_t checked = 0;
    for (std::size_t i = 0; i < picture.pixels(); ++i) {
        if (!picture.has(i, Event::meetsWater)) continue;
        const glm::dvec4 clip = clipFromWorld * glm::dvec4(dvec3(picture.surface[i]), 1.0);
        ASSERT_NEAR(0.5 * (clip.x / clip.w + 1.0) * size.x, static_cast<double>(i % 64) + 0.5, 1e-3) << i;
        ASSERT_NEAR(0.5 * (1.0 - clip.y / clip.w) * size.y, static_cast<double>(i / 64) + 0.5, 1e-3) << i;
        ++checked;
    }
    EXPECT_GT(checked, picture.pixels() / 2);
    const Tracer tracer(scene, scene.water);
    Camera unshifted = camera;
    unshifted.lensShift = 0.0f;
    const auto identity = [&](const Camera& c) { return tracer.identity({.camera = c, .approximations = {}}, {}); };
    EXPECT_NE(identity(camera), identity(unshifted));
}

TEST(ReferenceQuantities, FlatWaterShowsTheBedWhereSnellPutsIt)
{
    const double depth = 2.0, height = 3.0;
    const Scene scene = test::flatLake(static_cast<float>(depth));
    const Picture picture = quantitiesOf(scene, cameraAt({0.0f, 3.0f, 0.0f}, {0.0f, 0.0f, -4.0f}));
    std::size_t checked = 0;
    for (std::size_t i = 0; i < picture.pixels(); ++i) {
        if (!picture.has(i, Event::refractionHit)) continue;
        const dvec3 U(picture.surface[i]), W(picture.refractionHit[i]);
        const double across = std::hypot(U.x, U.z);
        const double sine = across / std::hypot(across, height) / ior;
        const double further = depth * sine / std::sqrt(1.0 - sine * sine);
        EXPECT_NEAR(U.y, 0.0, 1e-5);
        EXPECT_NEAR(W.y, -depth, 1e-4);
        EXPECT_NEAR(std::hypot(W.x, W.z), across + further, 1e-4 * (1.0 + across));
        EXPECT_NEAR(picture.path[i], std::hypot(further, depth), 1e-4 * (1.0 + across));
        ++checked;
    }
    EXPECT_GT(checked, picture.pixels() / 2);
}

TEST(ReferenceQuantities, StraightDownTheBedIsNearerByTheIndex)
{
    // Two rays a small angle apart seem to come from depth / n.
    const Scene scene = test::flatLake(2.0f);
    const Picture picture = quantitiesOf(scene, cameraAt({0.0f, 1.0f, 0.001f}, {0.0f, 0.0f, 0.0f}, 1.0f), {65, 65});
    const std::size_t centre = 32 * 65 + 32, beside = centre + 16;
    const double apart = glm::distance(picture.refractionHit[centre], picture.refractionHit[beside]);
    const double angle = 16.0 / 65.0 * 2.0 * std::tan(glm::radians(0.5));
    EXPECT_NEAR(apart / angle - 1.0, 2.0 / ior, 2e-3);
}

TEST(ReferenceQuantities, RaysMeetTheWavesThemselves)
{
    Scene scene = test::flatLake(1.5f, 30.0f);
    addWaves(scene);
    const double time = 1.3;
    const auto terms = termsOf(scene);
    for (const vec3& eye : {vec3(0.0f, 0.4f, 9.0f), vec3(2.0f, 3.0f, 4.0f)}) {
        const Picture picture = quantitiesOf(scene, cameraAt(eye, {0.0f, 0.0f, 0.0f}), {96, 72}, time);
        std::size_t checked = 0;
        for (std::size_t i = 0; i < picture.pixels(); ++i) {
            if (!picture.has(i, Event::meetsWater)) continue;
            ++checked;
            const dvec3 U(picture.surface[i]), n = optics64::waveNormalAt(terms, {U.x, U.z}, time);
            EXPECT_NEAR(U.y, optics64::waveHeight(terms, {U.x, U.z}, time), 1e-5);
            EXPECT_LT(glm::distance(dvec3(picture.normal[i]), n), 1e-4);
            // Nothing of the surface lies between the eye and U.
            for (double s = 0.02; s < 0.98; s += 0.01) {
                const dvec3 p = glm::mix(dvec3(eye), U, s);
                if (std::abs(p.x) > 15.0 || std::abs(p.z) > 15.0) continue;
                EXPECT_GT(p.y - optics64::waveHeight(terms, {p.x, p.z}, time), -1e-5);
            }
            if (!picture.has(i, Event::refractionHit)) continue;
            // Snell: n × d is the same on both sides, times the index.
            const dvec3 in = glm::normalize(U - dvec3(eye)), out = glm::normalize(dvec3(picture.refractionHit[i]) - U);
            EXPECT_LT(glm::length(glm::cross(n, in) - ior * glm::cross(n, out)), 2e-4);
        }
        EXPECT_GT(checked, picture.pixels() / 3);
    }
}

TEST(ReferenceQuantities, FresnelFromStraightDownToGrazing)
{
    const Scene scene = test::flatLake(2.0f, 4000.0f, 4000.0f);
    for (const double degrees : {0.01, 30.0, 53.06, 70.0, 85.0, 89.0, 89.9}) {
        const double a = degrees * std::numbers::pi / 180.0;
        const vec3 eye(0.0f, static_cast<float>(std::cos(a)), static_cast<float>(std::sin(a)));
        const Picture picture = quantitiesOf(scene, cameraAt(eye, vec3(0.0f), 0.01f), {1, 1});
        ASSERT_TRUE(picture.has(0, Event::meetsWater)) << degrees;
        const double b = std::asin(std::sin(a) / ior);
        // Fresnel's sine and tangent laws.
        const double s = std::sin(a - b) / std::sin(a + b), p = std::tan(a - b) / std::tan(a + b);
        EXPECT_NEAR(picture.fresnel[0], 0.5 * (s * s + p * p), 5e-5) << degrees;
    }
}

TEST(ReferenceQuantities, FromBelowTheWorldLiesInSnellsWindow)
{
    const Scene scene = test::flatLake(4.0f);
    const Camera camera = cameraAt({0.0f, -1.5f, 0.001f}, {0.0f, 0.0f, 0.0f}, 120.0f);
    const Picture picture = quantitiesOf(scene, camera, {101, 101});
    const double critical = 1.5 * std::tan(std::asin(1.0 / ior));
    for (std::size_t i = 0; i < picture.pixels(); ++i) {
        if (!picture.has(i, Event::meetsWater)) continue;
        EXPECT_TRUE(picture.has(i, Event::fromBelow));
        const double radius = std::hypot(picture.surface[i].x, picture.surface[i].z);
        if (std::abs(radius - critical) < 1e-3) continue;
        EXPECT_EQ(picture.has(i, Event::refracted), radius < critical) << radius;
        if (radius > critical) {
            EXPECT_FLOAT_EQ(picture.fresnel[i], 1.0f);
        }
    }
}

TEST(ReferenceQuantities, TheGridsSurfaceIsThatOfItsTriangles)
{
    Scene scene = test::flatLake(1.5f, 30.0f);
    addWaves(scene);
    const auto terms = termsOf(scene);
    const Tracer tracer(scene, scene.water);
    const Picture picture = tracer.quantities({.camera = cameraAt({0.0f, 2.0f, 6.0f}, {0.0f, 0.0f, 0.0f}),
                                               .time = 0.7,
                                               .size = {64, 48},
                                               .gridSize = 49,
                                               .approximations = {}},
                                              {.photons = 10000});
    const optics64::WaterGrid grid = optics64::uniformGrid({0.0, 0.0, 15.0, 15.0}, 49);
    double furthest = 0.0;
    for (std::size_t i = 0; i < picture.pixels(); ++i) {
        if (!picture.has(i, Event::meetsWater)) continue;
        const dvec3 U(picture.surface[i]);
        EXPECT_NEAR(U.y, optics64::gridHeight(terms.data(), 3, {U.x, U.z}, 0.7, grid[0], grid[1]), 1e-5);
        furthest = std::max(furthest, std::abs(U.y - optics64::waveHeight(terms, {U.x, U.z}, 0.7)));
    }
    EXPECT_GT(furthest, 1e-3); // and that is not the waves'
}

} // namespace
} // namespace tarn
