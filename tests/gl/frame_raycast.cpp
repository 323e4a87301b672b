// refraction.method = raycast: rays marched through the bed's heights, against formulas and against the other method.
#include "raycast_frames.h"
#include "test_renderer.h"
#include "test_scenes.h"

#include "gl/shader_library.h"
#include "measure/water_errors.h"
#include "optics/optics.h"
#include "render/renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tarn::test {
namespace {

using glm::dvec3;

/// Calls a function with U, the refracted direction in still water and the value of each pixel that shows water.
template <typename Visit>
int forWater(CheckedRenderer& renderer, const Camera& camera, DebugView view, const Visit& visit)
{
    const Image surface = renderer.linear(camera, pictureSize, 0.0, DebugView::positionU);
    const Image image = renderer.linear(camera, pictureSize, 0.0, view);
    int count = 0;
    for (int y = 0; y < pictureSize.y; ++y)
        for (int x = 0; x < pictureSize.x; ++x) {
            const vec4 u = pixel(surface, x, y);
            if (u.w == 0.0f) continue;
            const dvec3 ray = glm::normalize(dvec3(u) - dvec3(camera.eye));
            visit(dvec3(u), optics64::refractRay(ray, dvec3(0, 1, 0), 1.0 / n), pixel(image, x, y));
            ++count;
        }
    return count;
}

TEST(Raycast, ALevelBedIsMetWhereSnellSays)
{
    constexpr float depth = 2.0f;
    const Scene scene = flatLake(depth, 20.0f);
    const Camera camera = over({0, 1.6f, 6}, {0, -1, 0});
    using March = HeightsOptions::March;
    for (const auto& [march, combines] :
         {std::pair(March::pyramid, false), {March::classic, false}, {March::pyramid, true}}) {
        Options options = raycastOptions(march);
        if (combines) options.refraction.method = RefractionOptions::Method::combined;
        CheckedRenderer renderer(scene, options);
        for (const DebugView view : {DebugView::positionW, DebugView::positionA}) {
            double worst = 0.0;
            const int water =
                forWater(renderer, camera, view, [&](const dvec3& u, const dvec3& refracted, const vec4& value) {
                    const dvec3 hit = u - refracted * (depth / refracted.y);
                    if (std::max(std::abs(hit.x), std::abs(hit.z)) < 9.5)
                        worst = std::max(worst, glm::distance(hit, dvec3(value)));
                });
            EXPECT_GT(water, pictureSize.x * pictureSize.y / 2);
            EXPECT_LT(worst, 2.0e-3);
        }
        EXPECT_EQ(renderer.stats.plan[PassId::refraction].wanted, combines);
        EXPECT_TRUE(renderer.stats.plan[PassId::heights].wanted);
    }
}

TEST(Raycast, TheMapIsDrawnOnceForAllThatMoves)
{
    Scene scene = flatLake(2.0f, 20.0f);
    scene.sun = Sun{};
    scene.sun->direction = glm::normalize(vec3(0.3f, 1.0f, 0.2f));
    Wave wave;
    wave.amplitude = 0.05f;
    wave.wavelength = 2.0f;
    scene.water.waves = {wave};
    CheckedRenderer renderer(scene, raycastOptions());
    const auto trianglesOfMap = [&] {
        for (const FrameReport::Pass& pass : renderer.stats.passes)
            if (std::string(pass.name) == "heights") return pass.triangles;
        return std::size_t{0};
    };
    renderer.linear(over({0, 1.6f, 6}, {0, -1, 0}), pictureSize, 0.0);
    EXPECT_GT(trianglesOfMap(), 0u);
    renderer.linear(over({1, 2.6f, 4}, {0, -1, 0}), pictureSize, 0.7);
    EXPECT_EQ(trianglesOfMap(), 0u) << "eye and waves moved";
    WaterBody body = scene.water;
    body.absorption *= 2.0f;
    body.absorption += 0.1f;
    renderer.setOptions(raycastOptions(), body);
    renderer.linear(over({1, 2.6f, 4}, {0, -1, 0}), pictureSize, 0.7);
    EXPECT_GT(trianglesOfMap(), 0u) << "the water is another";
}

/// Metres along a ray to a box, less `inset` on all sides; negative when it passes by.
double toBox(const dvec3& from, const dvec3& direction, const vec3& lower, const vec3& upper, double inset)
{
    double near = 0.0, far = 1.0e9;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (static_cast<double>(lower[axis]) + inset - from[axis]) / direction[axis];
        const double b = (static_cast<double>(upper[axis]) - inset - from[axis]) / direction[axis];
        near = std::max(near, std::min(a, b));
        far = std::min(far, std::max(a, b));
    }
    return near <= far ? near : -1.0;
}

/// A pool with a post of a few centimetres that stands out of the water.
struct Pool {
    Scene scene = flatLake(1.0f, 4.0f);
    vec3 lower{-0.02f, -1.0f, -0.02f}, upper{0.02f, 0.5f, 0.02f};
    Camera camera = over({0, 1.2f, 2.2f}, {0, -0.6f, -0.3f});

    Pool() { addBox(scene, lower, upper, addMaterial(scene, vec3(0.8f, 0.1f, 0.1f))); }

    /// Of the rays that meet the post's middle: how many, and how many of them were found to end somewhere else.
    std::pair<int, int> missed(CheckedRenderer& renderer) const
    {
        int meet = 0, pass = 0;
        forWater(renderer, camera, DebugView::positionW,
                 [&](const dvec3& u, const dvec3& refracted, const vec4& value) {
                     const double t = toBox(u, refracted, lower, upper, 0.008);
                     if (t < 0.0) return;
                     ++meet;
                     pass += glm::distance(u + t * refracted, dvec3(value)) > 0.1;
                 });
        return {meet, pass};
    }
};

TEST(Raycast, AThinPostIsNeverSteppedOver)
{
    const Pool pool;
    CheckedRenderer pyramid(pool.scene, raycastOptions(HeightsOptions::March::pyramid, 1024));
    const auto [meet, pass] = pool.missed(pyramid);
    EXPECT_GT(meet, 40);
    EXPECT_EQ(pass, 0) << "of " << meet;
    CheckedRenderer classic(pool.scene, raycastOptions(HeightsOptions::March::classic, 1024));
    const auto [meetToo, missed] = pool.missed(classic);
    EXPECT_GT(missed, meetToo / 5) << "steps of 10 to 30 cm find a post of 4 cm by chance";
}

/// The fraction of water pixels whose ray was marched past what its map holds.
double missed(const Scene& scene, const Camera& camera, const Options& options)
{
    TestRenderer test(scene, options);
    const WaterQuantities used = readQuantities(test.renderer, camera, 0.0, pictureSize);
    reference::Picture truth(pictureSize); // of which the figure needs only where there is water and something under it
    for (std::size_t i = 0; i < truth.pixels(); ++i)
        truth.events[i] = reference::meetsWater | reference::refracted | reference::refractionHit;
    return errorFigures(used, truth).refractionMissed;
}

// The figure of the trade: of the rays that meet the post in truth, those that do not end there.
TEST(Raycast, WhatAClassicMarchStepsOverIsCounted)
{
    // The bed fills the map: over its brim a step may go as well.
    Pool pool;
    pool.scene = flatLake(1.0f, 4.0f, 12.0f);
    addBox(pool.scene, pool.lower, pool.upper, addMaterial(pool.scene, vec3(0.8f, 0.1f, 0.1f)));
    EXPECT_EQ(missed(pool.scene, pool.camera, raycastOptions(HeightsOptions::March::pyramid, 1024)), 0.0);
    EXPECT_EQ(missed(pool.scene, pool.camera, raycastOptions(HeightsOptions::March::pyramid, 256)), 0.0);
    const Options classic = raycastOptions(HeightsOptions::March::classic, 1024);
    const double fraction = missed(pool.scene, pool.camera, classic);
    CheckedRenderer renderer(pool.scene, classic);
    int water = 0, passed = 0;
    water = forWater(renderer, pool.camera, DebugView::positionW,
                     [&](const dvec3& u, const dvec3& refracted, const vec4& value) {
                         const double t = toBox(u, refracted, pool.lower, pool.upper, 0.0);
                         passed += t >= 0.0 && glm::distance(u, dvec3(value)) > t + 8.0 / 1024.0;
                     });
    const double wanted = static_cast<double>(passed) / water;
    EXPECT_GT(wanted, 0.001);
    EXPECT_NEAR(fraction, wanted, 0.25 * wanted) << "the map's post is wider by up to a texel";
    const Scene bare = flatLake(1.0f, 4.0f, 12.0f);
    EXPECT_EQ(missed(bare, pool.camera, classic), 0.0) << "there is nothing to step over";
}

// The post is cut by the surface: its column is solid, though it has no top there.
TEST(Raycast, WhatStandsOutOfTheWaterIsSolidToTheSurface)
{
    Pool pool;
    pool.lower = vec3(-0.3f, -1.0f, -0.3f);
    pool.upper = vec3(0.3f, 0.5f, 0.3f);
    pool.scene = flatLake(1.0f, 4.0f);
    addBox(pool.scene, pool.lower, pool.upper, addMaterial(pool.scene, vec3(0.8f, 0.1f, 0.1f)));
    CheckedRenderer renderer(pool.scene, raycastOptions(HeightsOptions::March::pyramid, 512));
    const auto [meet, pass] = pool.missed(renderer);
    EXPECT_GT(meet, 300);
    EXPECT_EQ(pass, 0) << "of " << meet;
}

// A map has a curtain under a ledge: what is under it is known to the target alone, which the eye sees it in.
TEST(Raycast, CombinedWithTheTargetSeesUnderALedge)
{
    Scene scene = flatLake(1.5f, 6.0f);
    const vec3 lower(-0.8f, -0.5f, -0.8f), upper(0.8f, -0.4f, 0.8f);
    addBox(scene, lower, upper, addMaterial(scene, vec3(0.8f, 0.1f, 0.1f)));
    const Camera camera = over({0, 0.7f, 3.0f}, {0, -0.6f, 0});
    const auto wrong = [&](bool combines) {
        Options options = raycastOptions(HeightsOptions::March::pyramid, 512);
        if (combines) options.refraction.method = RefractionOptions::Method::combined;
        options.refraction.camera = RefractionOptions::CameraMode::snell;
        options.refraction.steps = 6;
        CheckedRenderer renderer(scene, options);
        int under = 0, misplaced = 0;
        forWater(renderer, camera, DebugView::positionA,
                 [&](const dvec3& u, const dvec3& refracted, const vec4& value) {
                     const dvec3 onBed = u - refracted * (1.5 / refracted.y);
                     if (toBox(u, refracted, lower, upper, -0.04) >= 0.0) return; // meets the ledge, or its edge
                     if (std::abs(onBed.x) > 0.7 || std::abs(onBed.z) > 0.7) return;
                     ++under;
                     misplaced += glm::distance(onBed, dvec3(value)) > 0.05;
                 });
        EXPECT_GT(under, 200);
        return static_cast<double>(misplaced) / under;
    };
    EXPECT_GT(wrong(false), 0.5) << "a map alone fills what is under a ledge";
    EXPECT_LT(wrong(true), 0.02);
}

TEST(Raycast, HalvingTheStepFindsTheGroundMoreClosely)
{
    Scene scene = flatLake(1.0f, 8.0f);
    addBox(scene, {-1, -1, -1}, {1, -0.4f, 1}, addMaterial(scene, vec3(0.5f)));
    const Camera camera = over({0, 1.6f, 4}, {0, -1, 0});
    Options options = raycastOptions(HeightsOptions::March::classic, 1024);
    options.heights.filter = HeightsOptions::Filter::linear;
    const auto meanError = [&](int refine) {
        options.heights.refine = refine;
        CheckedRenderer renderer(scene, options);
        double sum = 0.0;
        int count = 0;
        forWater(renderer, camera, DebugView::positionW,
                 [&](const dvec3& u, const dvec3& refracted, const vec4& value) {
                     const dvec3 onTop = u - refracted * (0.4 / refracted.y);
                     // On the top, not far behind the edge that steps come over: there the ground before a step was the
                     // bed.
                     if (std::abs(onTop.x) > 0.95 || onTop.z < 0.6 || onTop.z > 0.95) return;
                     sum += glm::distance(dvec3(value), onTop);
                     ++count;
                 });
        EXPECT_GT(count, 500);
        return sum / count;
    };
    const double published = meanError(0), refined = meanError(8);
    EXPECT_LT(refined, 0.01);
    EXPECT_LT(refined, 0.2 * published);
}

/// Largest and mean difference of two pictures relative to the mean of the second, over the pixels whose water is near.
std::pair<double, double> difference(const Image& a, const Image& b)
{
    double worst = 0.0, sum = 0.0, mean = 0.0;
    for (std::size_t i = 0; i < b.floats.size(); ++i) mean += static_cast<double>(b.floats[i]);
    mean /= static_cast<double>(b.floats.size());
    for (std::size_t i = 0; i < b.floats.size(); ++i) {
        const double d = std::abs(static_cast<double>(a.floats[i]) - static_cast<double>(b.floats[i])) / mean;
        worst = std::max(worst, d);
        sum += d;
    }
    return {worst, sum / static_cast<double>(b.floats.size())};
}

// Sky, sun, caustics and shadows reach the bed as they do in the refraction target.
TEST(Raycast, LightsTheBedAsTheOtherMethodDoes)
{
    Scene scene = flatLake(1.0f, 8.0f);
    scene.sun = Sun{};
    scene.sun->direction = glm::normalize(vec3(0.4f, 1.0f, 0.3f));
    scene.sun->irradiance = vec3(3.0f, 2.5f, 2.0f);
    scene.water.absorption = vec3(0.4f, 0.2f, 0.1f);
    addBox(scene, {-0.4f, 0.4f, -0.4f}, {0.4f, 0.6f, 0.4f}, addMaterial(scene, vec3(0.5f))); // over the water: a shadow
    const Camera camera = over({0.0f, 3.0f, 2.5f}, {0, -1, -0.4f});
    for (const bool caustics : {false, true}) {
        Options options = raycastOptions(HeightsOptions::March::pyramid, 512);
        options.caustics.enabled = caustics;
        options.caustics.filter = 1;
        Options other = options;
        other.refraction.method = RefractionOptions::Method::iterative;
        other.refraction.steps = 8;
        CheckedRenderer a(scene, options), b(scene, other);
        const auto [worst, mean] = difference(a.linear(camera, pictureSize), b.linear(camera, pictureSize));
        EXPECT_LT(mean, 0.01) << caustics;
        EXPECT_LT(worst, 1.0) << caustics << ": edges of the shadow may differ, patches may not";
    }
}

Options mirrorOptions(HeightsOptions::March march = HeightsOptions::March::pyramid, int mapSize = 512)
{
    Options options = raycastOptions(march, mapSize);
    options.refraction.method = RefractionOptions::Method::iterative;
    options.reflection.method = ReflectionOptions::Method::raycast;
    return options;
}

/// Of the mirrored rays that plainly meet a box and those that plainly pass it: how many are found otherwise.
struct MirrorCount {
    int meet = 0, pass = 0, missed = 0, invented = 0;
};

MirrorCount countMirrored(CheckedRenderer& renderer, const Camera& camera, const vec3& lower, const vec3& upper,
                          double inset)
{
    MirrorCount count;
    const Image surface = renderer.linear(camera, pictureSize, 0.0, DebugView::positionU);
    const Image image = renderer.linear(camera, pictureSize, 0.0, DebugView::reflectionHit);
    for (int y = 0; y < pictureSize.y; ++y)
        for (int x = 0; x < pictureSize.x; ++x) {
            const vec4 u = pixel(surface, x, y), found = pixel(image, x, y);
            if (u.w == 0.0f) continue;
            dvec3 ray = glm::normalize(dvec3(u) - dvec3(camera.eye));
            ray.y = -ray.y;
            const double t = toBox(dvec3(u), ray, lower, upper, inset);
            if (t >= 0.0) {
                ++count.meet;
                count.missed += found.w > 1.5f || glm::distance(dvec3(u) + t * ray, dvec3(found)) > 6.0 * inset;
            } else if (toBox(dvec3(u), ray, lower, upper, -2.0 * inset) < 0.0) {
                ++count.pass;
                count.invented += found.w < 1.5f;
            }
        }
    return count;
}

TEST(RaycastMirror, APostIsMirroredWhereItStands)
{
    Scene scene = flatLake(1.0f, 8.0f);
    const vec3 lower(-0.25f, -0.5f, -1.25f), upper(0.25f, 1.5f, -0.75f);
    addBox(scene, lower, upper, addMaterial(scene, vec3(0.8f, 0.1f, 0.1f)));
    const Camera camera = over({0.3f, 1.4f, 3.5f}, {0, -0.3f, 0});
    CheckedRenderer renderer(scene, mirrorOptions());
    const MirrorCount count = countMirrored(renderer, camera, lower, upper, 0.03);
    EXPECT_GT(count.meet, 300);
    EXPECT_GT(count.pass, 3000);
    EXPECT_LE(count.missed, count.meet / 50) << "edges are a texel wide";
    EXPECT_EQ(count.invented, 0);
    EXPECT_FALSE(renderer.stats.plan[PassId::reflection].wanted);
}

// A deck is met from below, and rays that pass under it go on; as published it is solid down to the water.
TEST(RaycastMirror, ADeckHasAnUnderside)
{
    Scene scene = flatLake(1.0f, 8.0f);
    const vec3 lower(-1.0f, 0.6f, -2.0f), upper(1.0f, 0.7f, 0.0f);
    addBox(scene, lower, upper, addMaterial(scene, vec3(0.8f, 0.1f, 0.1f)));
    const Camera camera = over({0.3f, 1.0f, 3.5f}, {0, -0.1f, 0});
    CheckedRenderer pyramid(scene, mirrorOptions());
    const MirrorCount count = countMirrored(pyramid, camera, lower, upper, 0.03);
    EXPECT_GT(count.meet, 500);
    EXPECT_GT(count.pass, 3000);
    EXPECT_EQ(count.missed, 0);
    EXPECT_EQ(count.invented, 0);
    CheckedRenderer classic(scene, mirrorOptions(HeightsOptions::March::classic));
    EXPECT_GT(countMirrored(classic, camera, lower, upper, 0.03).invented, 200);
}

// A sky of one colour, an emissive box: what is mirrored is the one or the other.
TEST(RaycastMirror, ShowsWhatIsMet)
{
    Scene scene = flatLake(1.0f, 8.0f);
    const int red = addMaterial(scene, vec3(0.0f));
    scene.materials[static_cast<std::size_t>(red)].emissive = vec3(3.0f, 0.0f, 0.0f);
    addBox(scene, {-1, 0.0f, -2}, {1, 2, -1}, red);
    const Camera camera = over({0, 1.0f, 3.0f}, {0, 0, 0});
    Options other = mirrorOptions();
    other.reflection.method = ReflectionOptions::Method::iterative;
    other.reflection.targetSize = 1024;
    CheckedRenderer a(scene, mirrorOptions()), b(scene, other);
    const auto [worst, mean] = difference(a.linear(camera, pictureSize), b.linear(camera, pictureSize));
    EXPECT_LT(mean, 0.01);
}

} // namespace
} // namespace tarn::test
