// Which passes a frame runs, and that it says why.
#include "plan/frame_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tarn {

namespace {

WaterBody lake()
{
    WaterBody water;
    water.present = true;
    water.level = 1.0f;
    water.extent = vec2(40.0f, 20.0f);
    water.centre = vec2(5.0f, 0.0f);
    return water;
}

Camera cameraAt(const vec3& eye, const vec3& target)
{
    Camera camera;
    camera.eye = eye;
    camera.target = target;
    return camera;
}

FramePlan planFor(const WaterBody& water, const Camera& camera, const Options& options = {}, double time = 0.0)
{
    Scene scene;
    scene.water = water;
    scene.sun = Sun{normalize(vec3(0.0f, 0.3f, -1.0f)), vec3(100.0f), false}; // ahead of most of the cameras below
    return planFrame(scene, water, camera, options, {640, 480}, time);
}

void expectReasons(const FramePlan& plan)
{
    for (const PassPlan& pass : plan.passes) {
        EXPECT_FALSE(pass.reason.empty());
        EXPECT_EQ(pass.wanted, pass.size.x > 0 && pass.size.y > 0);
    }
}

} // namespace

// The frame is drawn at its scale, and what is presented, the glow and the targets do not follow.
TEST(FramePlan, TheFrameIsDrawnAtItsScale)
{
    const Camera camera = cameraAt({0, 4, 15}, {0, 0, 0});
    Options options;
    const FramePlan plain = planFor(lake(), camera, options);
    for (const auto& [scale, size] : {std::pair(0.5f, ivec2(320, 240)), std::pair(0.67f, ivec2(429, 322)),
                                      std::pair(1.25f, ivec2(800, 600)), std::pair(4.0f, ivec2(2560, 1920))}) {
        options.frame.scale = scale;
        const FramePlan plan = planFor(lake(), camera, options);
        EXPECT_EQ(plan[PassId::scene].size, size);
        EXPECT_EQ(plan[PassId::water].size, size);
        for (const PassId pass : {PassId::present, PassId::glow, PassId::refraction, PassId::reflection})
            EXPECT_EQ(plan[pass].size, plain[pass].size) << passName(pass);
    }
    options.frame.scale = 0.25f;
    EXPECT_EQ(scaledSize({1, 3}, options.frame), ivec2(1, 1));
}

// Seen from above a map takes the place of a target; an eye that looks from below keeps it.
TEST(FramePlan, RaysThatAreMarchedNeedTheMapsAndNotTheTargets)
{
    Options options;
    options.refraction.method = RefractionOptions::Method::raycast;
    FramePlan plan = planFor(lake(), cameraAt({0, 4, 15}, {0, 0, 0}), options);
    EXPECT_TRUE(plan[PassId::heights].wanted);
    EXPECT_TRUE(plan.raycastsBed);
    EXPECT_FALSE(plan.raycastsMirror);
    EXPECT_FALSE(plan[PassId::refraction].wanted);
    EXPECT_TRUE(plan[PassId::reflection].wanted);
    expectReasons(plan);
    EXPECT_FALSE(plan.targetsBed);
    options.refraction.method = RefractionOptions::Method::combined;
    options.reflection.method = ReflectionOptions::Method::combined;
    plan = planFor(lake(), cameraAt({0, 4, 15}, {0, 0, 0}), options);
    for (const PassId pass : {PassId::heights, PassId::refraction, PassId::reflection}) EXPECT_TRUE(plan[pass].wanted);
    EXPECT_TRUE(plan.raycastsBed && plan.targetsBed && plan.raycastsMirror && plan.targetsMirror);
    expectReasons(plan);
    options.refraction.method = RefractionOptions::Method::raycast;
    options.reflection.method = ReflectionOptions::Method::raycast;
    plan = planFor(lake(), cameraAt({0, 4, 15}, {0, 0, 0}), options);
    EXPECT_TRUE(plan.raycastsMirror);
    EXPECT_FALSE(plan[PassId::reflection].wanted);
    plan = planFor(lake(), cameraAt({0, -1, 5}, {0, -1, 0}), options);
    EXPECT_FALSE(plan[PassId::heights].wanted);
    EXPECT_TRUE(plan[PassId::refraction].wanted);
    EXPECT_TRUE(plan[PassId::reflection].wanted);
    expectReasons(plan);
    options.water.reflects = false;
    EXPECT_FALSE(planFor(lake(), cameraAt({0, 4, 15}, {0, 0, 0}), options).raycastsMirror);
}

// auto takes a map where it can hold what there is, and shows it as finely as the picture does.
TEST(FramePlan, AutoTakesAMapWhereItCanKnow)
{
    Options options;
    options.refraction.method = RefractionOptions::Method::automatic;
    options.reflection.method = ReflectionOptions::Method::automatic;
    options.heights.mapSize = 4096;
    Scene scene;
    scene.water = lake();
    const auto plan = [&](const DepthComplexity* complexity) {
        return planFrame(scene, scene.water, cameraAt({0, 9, 15}, {0, 0, 0}), options, {640, 480}, 0.0, complexity);
    };
    const DepthComplexity simple{0.001, 0.001}, ledges{0.2, 0.001}, crowns{0.001, 0.4};
    EXPECT_TRUE(plan(&simple).raycastsBed);
    EXPECT_FALSE(plan(&simple).targetsBed);
    EXPECT_TRUE(plan(&simple).raycastsMirror);
    EXPECT_TRUE(plan(&ledges).raycastsBed && plan(&ledges).targetsBed) << "the target sees under them";
    EXPECT_TRUE(plan(&ledges).raycastsMirror);
    EXPECT_NE(plan(&ledges)[PassId::refraction].reason.find("20.0 %"), std::string::npos);
    EXPECT_FALSE(plan(&crowns).raycastsMirror);
    EXPECT_FALSE(plan(nullptr).raycastsBed) << "nothing is known";
    options.heights.mapSize = 128;
    EXPECT_TRUE(plan(&simple).targetsBed) << "a texel is a third of a metre";
    EXPECT_NE(plan(&simple)[PassId::refraction].reason.find("a texel of the map"), std::string::npos);
}

TEST(FramePlan, WaterInViewNeedsEveryPass)
{
    Options options;
    options.refraction.targetSize = 256;
    const FramePlan plan = planFor(lake(), cameraAt({0, 4, 15}, {0, 0, 0}), options);
    for (std::size_t i = 0; i < passCount; ++i)
        EXPECT_EQ(plan.passes[i].wanted, static_cast<PassId>(i) != PassId::heights) << passName(static_cast<PassId>(i));
    EXPECT_FALSE(plan.underwater);
    EXPECT_EQ(plan[PassId::refraction].size, ivec2(256));
    EXPECT_EQ(plan[PassId::scene].size, ivec2(640, 480));
    expectReasons(plan);
}

TEST(FramePlan, NothingOfTheWaterRunsWithoutIt)
{
    const Camera camera = cameraAt({0, 4, 15}, {0, 0, 0});
    WaterBody none = lake();
    none.present = false;
    Options off;
    off.water.enabled = false;
    const Camera away = cameraAt({0, 4, 15}, {0, 60, 100});
    for (const FramePlan& plan : {planFor(none, camera), planFor(lake(), camera, off), planFor(lake(), away)}) {
        EXPECT_FALSE(plan[PassId::water].wanted);
        EXPECT_FALSE(plan[PassId::refraction].wanted);
        EXPECT_FALSE(plan[PassId::reflection].wanted);
        EXPECT_FALSE(plan[PassId::glow].wanted);
        EXPECT_TRUE(plan[PassId::scene].wanted);
        EXPECT_TRUE(plan[PassId::present].wanted);
        expectReasons(plan);
    }
}

TEST(FramePlan, SwitchesTurnOffOnePassEach)
{
    Options options;
    options.refraction.enabled = false;
    FramePlan plan = planFor(lake(), cameraAt({0, 4, 15}, {0, 0, 0}), options);
    EXPECT_FALSE(plan[PassId::refraction].wanted);
    EXPECT_TRUE(plan[PassId::reflection].wanted);
    EXPECT_TRUE(plan[PassId::water].wanted);

    options = {};
    options.reflection.enabled = false;
    plan = planFor(lake(), cameraAt({0, 4, 15}, {0, 0, 0}), options);
    EXPECT_TRUE(plan[PassId::refraction].wanted);
    EXPECT_FALSE(plan[PassId::reflection].wanted);
}

TEST(FramePlan, AMirrorlessSurfaceNeedsNoReflectionAndHasNoGlow)
{
    Options options;
    options.water.reflects = false;
    for (const vec3& eye : {vec3(0, 4, 15), vec3(0, -2, 5)}) {
        const FramePlan plan = planFor(lake(), cameraAt(eye, {0, 0.5f, 0}), options);
        EXPECT_TRUE(plan[PassId::water].wanted);
        EXPECT_TRUE(plan[PassId::refraction].wanted);
        EXPECT_FALSE(plan[PassId::reflection].wanted);
        EXPECT_FALSE(plan[PassId::glow].wanted);
        EXPECT_NE(plan[PassId::reflection].reason.find("water.reflects"), std::string::npos);
        expectReasons(plan);
    }
}

TEST(FramePlan, CausticsNeedASunAndABedInSight)
{
    const Camera camera = cameraAt({0, 4, 15}, {0, 0, 0});
    Scene scene;
    scene.water = lake();
    const auto plan = [&](const Options& options, const Camera& eye) {
        const FramePlan result = planFrame(scene, scene.water, eye, options, {640, 480}, 0.0);
        expectReasons(result);
        return result;
    };
    EXPECT_FALSE(plan({}, camera)[PassId::caustics].wanted);
    EXPECT_FALSE(plan({}, camera)[PassId::sunlight].wanted);
    scene.sun = Sun{};
    Options options;
    options.caustics.textureSize = 128;
    options.sunlight.mapSize = 1024;
    EXPECT_EQ(plan(options, camera)[PassId::caustics].size, ivec2(128));
    EXPECT_EQ(plan(options, camera)[PassId::sunlight].size, ivec2(1024));
    options.refraction.enabled = false; // the bed is not seen
    EXPECT_FALSE(plan(options, camera)[PassId::caustics].wanted);
    // An eye in the water sees the bed directly, also with its back to the surface.
    EXPECT_TRUE(plan(options, cameraAt({0, 0, 0}, {0, -5, 1}))[PassId::caustics].wanted);
    options = {};
    options.caustics.enabled = false;
    EXPECT_FALSE(plan(options, camera)[PassId::caustics].wanted);
    EXPECT_TRUE(plan(options, camera)[PassId::sunlight].wanted);
    options.sunlight.shadows = false;
    EXPECT_FALSE(plan(options, camera)[PassId::sunlight].wanted);
    options.caustics.enabled = true; // photons find the bed in the sun's maps
    EXPECT_TRUE(plan(options, camera)[PassId::sunlight].wanted);
    for (const float height : {-0.3f, 0.0f}) {
        scene.sun->direction = normalize(vec3(1.0f, height, 0.0f));
        EXPECT_FALSE(plan({}, camera)[PassId::caustics].wanted);
        EXPECT_FALSE(plan({}, camera)[PassId::sunlight].wanted);
    }
}

TEST(FramePlan, GlowNeedsASunOverTheWater)
{
    const Camera camera = cameraAt({0, 4, 15}, {0, 0, 0});
    const auto wantsGlow = [&camera](const Scene& scene, const Options& options) {
        return planFrame(scene, scene.water, camera, options, {640, 480}, 0.0)[PassId::glow].wanted;
    };
    Scene scene;
    scene.water = lake();
    EXPECT_FALSE(wantsGlow(scene, {}));
    scene.sun = Sun{};
    scene.sun->direction = normalize(vec3(0.0f, 0.3f, -1.0f));
    EXPECT_TRUE(wantsGlow(scene, {}));
    scene.sun->direction = normalize(vec3(1.0f, -0.1f, 0.0f));
    EXPECT_FALSE(wantsGlow(scene, {}));
    scene.sun->direction = normalize(vec3(0.0f, 0.3f, -1.0f));
    Options options;
    options.glow.divisor = 10;
    EXPECT_EQ(planFrame(scene, scene.water, camera, options, {640, 480}, 0.0)[PassId::glow].size, ivec2(64, 48));
    options.glow.enabled = false;
    EXPECT_FALSE(wantsGlow(scene, options));
}

TEST(FramePlan, TheEyeIsUnderTheMovingSurfaceNotTheLevel)
{
    WaterBody water = lake();
    water.waves = {{0.5f, 10.0f, 0.0f, 0.0f, 2.0f}};
    const auto under = [&](const vec3& eye, double time) {
        return planFor(water, cameraAt(eye, eye + vec3(0, 0, -1)), {}, time).underwater;
    };
    // y = level + 0.5 sin(2π x / 10 - π t): a crest at x = 2.5 and a trough at x = 7.5 for t = 0, swapped at t = 1.
    EXPECT_TRUE(under({2.5f, 1.4f, 0.0f}, 0.0));
    EXPECT_FALSE(under({2.5f, 1.4f, 0.0f}, 1.0));
    EXPECT_FALSE(under({7.5f, 0.6f, 0.0f}, 0.0));
    EXPECT_TRUE(under({7.5f, 0.6f, 0.0f}, 1.0));
    // Beside the water's rectangle there is none to be under.
    EXPECT_FALSE(under({2.5f, 0.0f, 11.0f}, 0.0));
}

TEST(FramePlan, TheNearPlaneIsAboveBelowOrCutByTheSurface)
{
    WaterBody water = lake();
    const auto planAt = [&](const vec3& eye, const Options& options = {}) {
        return planFor(water, cameraAt(eye, eye + vec3(0, 0, -1)), options);
    };
    const auto side = [&](const vec3& eye) { return planAt(eye).side; };
    // Still water: the near plane reaches 0.1 tan(fov / 2) = 0.046 m up and down.
    EXPECT_EQ(side({2.5f, 1.05f, 0.0f}), WaterSide::above);
    EXPECT_EQ(side({2.5f, 1.04f, 0.0f}), WaterSide::crossing);
    EXPECT_EQ(side({2.5f, 0.96f, 0.0f}), WaterSide::crossing);
    EXPECT_EQ(side({2.5f, 0.95f, 0.0f}), WaterSide::below);
    EXPECT_EQ(side({2.5f, 0.95f, 11.0f}), WaterSide::above) << "beside the water";
    EXPECT_EQ(side({2.5f, 0.5f, 10.0f}), WaterSide::below) << "the eye is on the edge, the near plane within";
    EXPECT_EQ(side({-15.0f, 0.5f, 0.0f}), WaterSide::crossing) << "half of the near plane is beside the water";

    const FramePlan crossing = planAt({2.5f, 0.98f, 0.0f});
    EXPECT_TRUE(crossing.underwater) << "the eye itself";
    EXPECT_NE(crossing[PassId::water].reason.find("both sides"), std::string::npos);
    expectReasons(crossing);
    Options off;
    off.underwater.enabled = false;
    EXPECT_EQ(planAt({2.5f, 0.5f, 0.0f}, off).side, WaterSide::above);

    // Big waves: above the level in a trough, below it under a crest; never missed where the surface cuts.
    water.waves = {{0.5f, 10.0f, 0.0f, 0.0f, 2.0f}, {0.1f, 2.0f, 1.0f, 0.0f, 0.0f}};
    for (int i = 0; i < 200; ++i) {
        const vec3 eye(-14.0f + 0.14f * static_cast<float>(i), 0.4f + 0.013f * static_cast<float>((i * 37) % 93), 0.3f);
        float least = 1.0e9f;
        float most = -1.0e9f;
        for (int c = 0; c < 25; ++c) {
            const vec2 at(static_cast<float>(c % 5) * 0.5f - 1.0f, static_cast<float>(c / 5) * 0.5f - 1.0f);
            const vec3 p = eye + vec3(at.x * 0.0466f * 4.0f / 3.0f, at.y * 0.0466f, -0.1f);
            const float over = p.y - drawnHeight(water, planAt(eye).waterGrid, vec2(p.x, p.z), 0.0);
            least = std::min(least, over);
            most = std::max(most, over);
        }
        const WaterSide planned = side(eye);
        if (least <= 0.0f && most >= 0.0f) {
            EXPECT_EQ(planned, WaterSide::crossing) << i;
        }
        if (least > 0.15f) {
            EXPECT_EQ(planned, WaterSide::above) << i;
        }
        if (most < -0.15f) {
            EXPECT_EQ(planned, WaterSide::below) << i;
        }
    }
}

TEST(FramePlan, SurfaceHeightKeepsItsPhaseForDays)
{
    WaterBody water = lake();
    water.waves = {{0.1f, 0.5f, 0.3f, 1.0f, 0.0f}};
    const double omega = std::sqrt(9.81 * 2.0 * 3.14159265358979 / 0.5);
    const double period = 2.0 * 3.14159265358979 / omega;
    EXPECT_NEAR(surfaceHeight(water, {1.0f, 2.0f}, 0.2), surfaceHeight(water, {1.0f, 2.0f}, 0.2 + 1.0e6 * period),
                1.0e-5);
}

TEST(FramePlan, BoundsHoldTheSurface)
{
    WaterBody water = lake();
    water.waves = {{0.2f, 3.0f, 0.0f, 0.0f, 0.0f}, {-0.1f, 1.0f, 1.0f, 0.0f, 0.0f}};
    const Bounds bounds = waterBounds(water);
    EXPECT_FLOAT_EQ(bounds.lower.y, 0.7f);
    EXPECT_FLOAT_EQ(bounds.upper.y, 1.3f);
    EXPECT_FLOAT_EQ(bounds.lower.x, -15.0f);
    EXPECT_FLOAT_EQ(bounds.upper.z, 10.0f);
    for (int i = 0; i < 1000; ++i) {
        const float height = surfaceHeight(water, vec2(0.37f * static_cast<float>(i), 0.11f), 0.1 * i);
        EXPECT_GE(height, bounds.lower.y);
        EXPECT_LE(height, bounds.upper.y);
    }
}

} // namespace tarn
