// The debug views that say where the water pass looks: in still water over a level bed a formula gives every point.
#include "test_renderer.h"
#include "test_scenes.h"

#include "gl/shader_library.h"
#include "optics/optics.h"
#include "optics/waves.h"
#include "render/renderer.h"
#include "render/view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace tarn::test {

namespace {

using glm::dvec3;

constexpr ivec2 pictureSize(160, 120);
constexpr float depth = 2.0f;
constexpr double n = 1.33;

/// Over the origin's water, or under it, looking so many degrees off the horizontal, towards -z.
Camera lookAlong(float degreesUp, float height)
{
    const float angle = glm::radians(degreesUp);
    Camera camera;
    camera.name = "test";
    camera.eye = vec3(0.0f, height, 0.0f);
    camera.target = camera.eye + vec3(0.0f, std::sin(angle), -std::cos(angle));
    camera.verticalFov = glm::radians(45.0f);
    camera.farPlane = 300.0f;
    return camera;
}

/// Waves of one length, 30 degrees off the view.
Scene lakeWithWave(float amplitude, float wavelength)
{
    Scene scene = flatLake(depth);
    Wave wave;
    wave.amplitude = amplitude;
    wave.wavelength = wavelength;
    wave.direction = 30.0f;
    scene.water.waves = {wave};
    return scene;
}

/// The rays through the centres of the pixels of a still lake at height 0.
class Rays {
public:
    explicit Rays(const Camera& camera) : eye_(camera.eye)
    {
        const float aspect = static_cast<float>(pictureSize.x) / static_cast<float>(pictureSize.y);
        worldFromClip_ = glm::inverse(glm::dmat4(clipFromView(camera, aspect)) * glm::dmat4(viewFromWorld(camera)));
    }

    dvec3 through(int x, int y) const
    {
        const glm::dvec4 far = worldFromClip_ * glm::dvec4(2.0 * (x + 0.5) / pictureSize.x - 1.0,
                                                           1.0 - 2.0 * (y + 0.5) / pictureSize.y, 1.0, 1.0);
        return glm::normalize(dvec3(far) / far.w - eye_);
    }
    dvec3 surface(const dvec3& ray) const { return eye_ - ray * (eye_.y / ray.y); }

private:
    dvec3 eye_;
    glm::dmat4 worldFromClip_;
};

/// Calls a function with the ray and the surface point of each pixel that shows water nearer than so many metres.
template <typename Visit> int forWater(const Camera& camera, const Image& image, double farthest, const Visit& visit)
{
    const Rays rays(camera);
    int visited = 0;
    for (int y = 0; y < pictureSize.y; ++y) {
        for (int x = 0; x < pictureSize.x; ++x) {
            const vec4 value = pixel(image, x, y);
            if (value.w == 0.0f) continue;
            const dvec3 ray = rays.through(x, y), surface = rays.surface(ray);
            if (glm::distance(surface, dvec3(camera.eye)) > farthest) continue;
            visit(ray, surface, value);
            ++visited;
        }
    }
    return visited;
}

dvec3 mirrored(const dvec3& ray) { return {ray.x, -ray.y, ray.z}; }

double angleBetween(const dvec3& a, const dvec3& b)
{
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

} // namespace

TEST(Positions, TheSurfaceIsWhereTheEyesRayMeetsIt)
{
    const Scene scene = flatLake(depth);
    const Camera camera = lookAlong(-20.0f, 1.6f);
    CheckedRenderer renderer(scene);
    const Image image = renderer.linear(camera, pictureSize, 0.0, DebugView::positionU);
    double worst = 0.0;
    const int water = forWater(camera, image, 50.0, [&](const dvec3&, const dvec3& surface, const vec4& value) {
        EXPECT_EQ(value.w, 1.0f);
        worst = std::max(worst, glm::distance(surface, dvec3(value)));
    });
    EXPECT_GT(water, pictureSize.x * pictureSize.y / 3);
    EXPECT_LT(worst, 2.0e-3);
}

// Converged, the point whose picture is taken is the one that is looked for.
TEST(Positions, ThePictureOfTheBedIsThatOfTheTrueHit)
{
    const Scene scene = flatLake(depth);
    const Camera camera = lookAlong(-40.0f, 1.6f);
    Options options;
    options.refraction.steps = 8;
    CheckedRenderer renderer(scene, options);
    const Image image = renderer.linear(camera, pictureSize, 0.0, DebugView::positionA);
    double worst = 0.0;
    const int water = forWater(camera, image, 20.0, [&](const dvec3& ray, const dvec3& surface, const vec4& value) {
        const dvec3 refracted = optics64::refractRay(ray, dvec3(0, 1, 0), 1.0 / n);
        EXPECT_EQ(value.w, 1.0f);
        worst = std::max(worst, glm::distance(surface - refracted * (depth / refracted.y), dvec3(value)));
    });
    EXPECT_GT(water, pictureSize.x * pictureSize.y / 2);
    EXPECT_LT(worst, 0.02);
}

// Seen through flat water, triangles of two metres are drawn straight though what they show is not: the lookup corrects
// it, from an eye so low that they would be off by centimetres.
TEST(Positions, LargeTrianglesDoNotBendThePictureThroughFlatWater)
{
    Scene scene = flatLake(depth, 400.0f, 0.1f);
    addFloor(scene, -depth, 60.0f, 0, 36);
    const Camera camera = lookAlong(-25.0f, 0.4f);
    Options options;
    options.refraction.camera = RefractionOptions::CameraMode::flat;
    options.refraction.targetSize = 2048;
    options.refraction.steps = 8;
    CheckedRenderer renderer(scene, options);
    for (const DebugView view : {DebugView::positionA, DebugView::positionW}) {
        const Image image = renderer.linear(camera, pictureSize, 0.0, view);
        double worst = 0.0;
        const int water = forWater(camera, image, 4.0, [&](const dvec3& ray, const dvec3& surface, const vec4& value) {
            const dvec3 refracted = optics64::refractRay(ray, dvec3(0, 1, 0), 1.0 / n);
            worst = std::max(worst, glm::distance(surface - refracted * (depth / refracted.y), dvec3(value)));
        });
        EXPECT_GT(water, pictureSize.x * pictureSize.y / 3);
        // Uncorrected both are off by 17 cm; the last look at the picture has one correction, the search several.
        EXPECT_LT(worst, view == DebugView::positionW ? 0.01 : 0.05);
    }
}

// The first approximation's W is beside the bed; its picture is of the bed all the same.
TEST(Positions, ThePlanarLookupsPictureIsOfTheBed)
{
    const Scene scene = flatLake(depth);
    const Camera camera = lookAlong(-30.0f, 1.6f);
    Options options;
    options.refraction.method = RefractionOptions::Method::planar;
    options.refraction.camera = RefractionOptions::CameraMode::main; // the turned camera leaves little to be wrong
    CheckedRenderer renderer(scene, options);
    const auto heightRange = [&](DebugView view) {
        vec2 range(1.0e6f, -1.0e6f);
        const auto widen = [&](const dvec3&, const dvec3&, const vec4& value) {
            range = {std::min(range.x, value.y), std::max(range.y, value.y)};
        };
        forWater(camera, renderer.linear(camera, pictureSize, 0.0, view), 10.0, widen);
        return range;
    };
    const vec2 place = heightRange(DebugView::positionW), picture = heightRange(DebugView::positionA);
    EXPECT_GT(place.y - place.x, 0.2f);
    EXPECT_NEAR(picture.x, -depth, 0.01f);
    EXPECT_NEAR(picture.y, -depth, 0.01f);
}

// A bed of two metres in a wide lake: past its edge the target is empty, and says so.
TEST(Positions, WhereTheBedEndsThereIsNoSample)
{
    const Scene scene = flatLake(depth, 400.0f, 2.0f);
    const Camera camera = lookAlong(-89.0f, 4.0f);
    Options options;
    options.refraction.steps = 8;
    CheckedRenderer renderer(scene, options);
    const Image image = renderer.linear(camera, pictureSize, 0.0, DebugView::positionA);
    int onBed = 0, beside = 0;
    forWater(camera, image, 20.0, [&](const dvec3& ray, const dvec3& surface, const vec4& value) {
        const dvec3 refracted = optics64::refractRay(ray, dvec3(0, 1, 0), 1.0 / n);
        const dvec3 hit = surface - refracted * (depth / refracted.y);
        const double fromEdge = std::max(std::abs(hit.x), std::abs(hit.z)) - 1.0;
        // Between, the search may end on either side of the edge, or on it.
        if (fromEdge < -0.3) {
            ++onBed;
            EXPECT_EQ(value.w, 1.0f);
            EXPECT_NEAR(value.y, -depth, 0.01f);
        } else if (fromEdge > 0.7) {
            ++beside;
            EXPECT_EQ(value.w, 0.5f);
        }
    });
    EXPECT_GT(onBed, 500);
    EXPECT_GT(beside, 500);
}

TEST(Positions, TheReflectionShowsTheWallAndTheSky)
{
    Scene scene = flatLake(depth);
    addBox(scene, {-40.0f, -depth, -12.0f}, {40.0f, 2.0f, -10.0f}, addMaterial(scene, vec3(0.2f)));
    const Camera camera = lookAlong(-20.0f, 1.6f);
    for (const float distance : {0.0f, 1.0f, 20.0f}) { // in still water any c of eq. 6 is right
        Options options;
        options.reflection.distance = distance;
        CheckedRenderer renderer(scene, options);
        const Image image = renderer.linear(camera, pictureSize, 0.0, DebugView::reflectionHit);
        int walls = 0, skies = 0;
        double worst = 0.0, worstAngle = 0.0;
        forWater(camera, image, 9.0, [&](const dvec3& ray, const dvec3& surface, const vec4& value) {
            const dvec3 reflected = mirrored(ray);
            const dvec3 hit = surface + reflected * ((-10.0 - surface.z) / reflected.z);
            if (std::abs(hit.y - 2.0) < 0.05) return; // the pixels of its edge
            ASSERT_EQ(value.w, hit.y < 2.0 ? 1.0f : 2.0f) << distance;
            ++(hit.y < 2.0 ? walls : skies);
            if (hit.y < 2.0)
                worst = std::max(worst, glm::distance(hit, dvec3(value)));
            else
                worstAngle = std::max(worstAngle, angleBetween(reflected, dvec3(value)));
        });
        EXPECT_GT(walls, 1000);
        EXPECT_GT(skies, 1000);
        EXPECT_LT(worst, 0.01) << distance;
        EXPECT_LT(worstAngle, 1.0e-3) << distance;
    }
}

TEST(Positions, WithoutTheirTargetsThereIsNoSampleAndTheSkyIsMirrored)
{
    const Scene scene = flatLake(depth);
    const Camera camera = lookAlong(-30.0f, 1.6f);
    Options options;
    options.refraction.enabled = options.reflection.enabled = false;
    CheckedRenderer renderer(scene, options);
    const Image taken = renderer.linear(camera, pictureSize, 0.0, DebugView::positionA);
    forWater(camera, taken, 20.0, [](const dvec3&, const dvec3&, const vec4& value) { EXPECT_EQ(value.w, 0.5f); });
    const Image mirror = renderer.linear(camera, pictureSize, 0.0, DebugView::reflectionHit);
    forWater(camera, mirror, 20.0, [](const dvec3& ray, const dvec3&, const vec4& value) {
        EXPECT_EQ(value.w, 2.0f);
        EXPECT_LT(angleBetween(mirrored(ray), dvec3(value)), 1.0e-3);
    });
}

// From below: a ceiling over the water in the window's middle, sky about it, and total reflection beyond.
TEST(Positions, AnEyeUnderWaterSeesTheCeilingAndMirrorsTheBed)
{
    Scene scene = flatLake(4.0f);
    const double ceiling = 3.0;
    addBox(scene, {-2.0f, static_cast<float>(ceiling), -2.0f}, {2.0f, 5.0f, 2.0f}, 0);
    const Camera camera = lookAlong(80.0f, -1.5f);
    Options options;
    options.refraction.steps = 8;
    CheckedRenderer renderer(scene, options);
    const Image taken = renderer.linear(camera, pictureSize, 0.0, DebugView::positionA);
    int found = 0, missing = 0;
    forWater(camera, taken, 20.0, [&](const dvec3& ray, const dvec3& surface, const vec4& value) {
        if (ray.y < 0.85) return; // leaves the target
        const dvec3 refracted = optics64::refractRay(ray, dvec3(0, -1, 0), n);
        const dvec3 hit = surface + refracted * (ceiling / refracted.y);
        const double fromEdge = std::max(std::abs(hit.x), std::abs(hit.z)) - 2.0;
        if (std::abs(fromEdge) < 0.7) return; // past the edge its side is a near miss, which counts in part
        EXPECT_EQ(value.w, fromEdge < 0.0 ? 1.0f : 0.5f);
        ++(fromEdge < 0.0 ? found : missing);
        if (fromEdge < 0.0) {
            EXPECT_LT(glm::distance(hit, dvec3(value)), 0.02);
        }
    });
    EXPECT_GT(found, 500);
    EXPECT_GT(missing, 100);

    const Image mirror = renderer.linear(camera, pictureSize, 0.0, DebugView::reflectionHit);
    double worst = 0.0;
    forWater(camera, mirror, 3.0, [&](const dvec3& ray, const dvec3& surface, const vec4& value) {
        worst = std::max(worst, glm::distance(surface + mirrored(ray) * (4.0 / ray.y), dvec3(value)));
    });
    EXPECT_LT(worst, 0.02);
}

// water.surface_steps: Newton's method brings the grid's points onto the waves, whatever the grid.
TEST(FramePositions, NewtonsMethodLeavesTheTrianglesForTheWaves)
{
    const Scene scene = lakeWithWave(0.02f, 3.0f);
    const std::vector<optics64::WaveTerm> terms{optics64::makeWaveTerm(0.02, 3.0, 30.0, 0.0)};
    constexpr double time = 0.8;
    Options options;
    options.frame.msaa = 1;
    options.water.filterWaves = false;
    options.water.gridSize = 1025; // cells of 0.4 m over 400 m
    CheckedRenderer renderer(scene, options);
    const Camera camera = lookAlong(-35.0f, 2.0f);
    const Rays rays(camera);
    std::array<double, 3> worst{};
    for (int steps = 0; steps <= 2; ++steps) {
        options.water.surfaceSteps = steps;
        renderer.setOptions(options, scene.water);
        const Image u = renderer.linear(camera, pictureSize, time, DebugView::positionU);
        double& error = worst[static_cast<std::size_t>(steps)];
        for (int y = pictureSize.y / 2; y < pictureSize.y; ++y) {
            for (int x = 0; x < pictureSize.x; ++x) {
                const dvec3 p(pixel(u, x, y));
                const double height = optics64::waveTerm(terms.front(), {p.x, p.z}, time).x;
                error = std::max(error, std::abs(p.y - height));
                // Along the eye's ray and nowhere else.
                const dvec3 way = glm::normalize(p - dvec3(camera.eye));
                ASSERT_LT(glm::distance(way, rays.through(x, y)), 1e-4);
            }
        }
    }
    EXPECT_GT(worst[0], 5e-4); // else there is nothing to mend
    EXPECT_LT(worst[1], 0.1 * worst[0]);
    EXPECT_LT(worst[2], 1e-5);
}

// What the surface mirrors is a mean over the waves of a pixel; what is seen through it is one ray's all the same.
TEST(FramePositions, TheFilterFadesOnlyWhatIsMirrored)
{
    const Scene scene = lakeWithWave(0.002f, 0.12f);
    const Camera camera = lookAlong(-15.0f, 2.0f); // a pixel covers up to metres
    Options options;
    options.frame.msaa = 1;
    CheckedRenderer renderer(scene, options);
    const auto both = [&](DebugView view) {
        std::array<Image, 2> pictures;
        for (const bool filters : {false, true}) {
            options.water.filterWaves = filters;
            renderer.setOptions(options, scene.water);
            pictures[filters ? 1 : 0] = renderer.linear(camera, pictureSize, 0.3, view);
        }
        return pictures;
    };
    for (const DebugView view : {DebugView::positionU, DebugView::positionW}) {
        const auto points = both(view);
        float worst = 0.0f;
        for (int y = pictureSize.y / 2; y < pictureSize.y; ++y)
            for (int x = 0; x < pictureSize.x; ++x)
                worst = std::max(worst, glm::distance(pixel(points[0], x, y), pixel(points[1], x, y)));
        EXPECT_LT(worst, 1e-5f) << static_cast<int>(view);
    }
    const auto normals = both(DebugView::normals);
    const auto tilt = [](const Image& image) {
        double sum = 0.0;
        for (int y = pictureSize.y / 2; y < pictureSize.y; ++y)
            for (int x = 0; x < pictureSize.x; ++x)
                sum += glm::length(vec2(pixel(image, x, y).x, pixel(image, x, y).z));
        return sum;
    };
    EXPECT_GT(tilt(normals[0]), 0.0);
    EXPECT_LT(tilt(normals[1]), 0.5 * tilt(normals[0]));
}

} // namespace tarn::test
