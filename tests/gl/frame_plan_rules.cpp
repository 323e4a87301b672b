// What a frame keeps of the one before, and what it leaves out by its own depth, must not be seen in it.
#include "gl_test.h"

#include "gl/shader_library.h"
#include "test_renderer.h"
#include "test_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tarn::test {

namespace {

constexpr ivec2 size(96, 72);

/// A bed, a thing in the water, a thing over it, a sun.
Scene pond()
{
    Scene scene = flatLake(2.0f, 30.0f);
    addBox(scene, {-1, -1.9f, -1}, {1, -0.7f, 1}, 0);
    addBox(scene, {-4, -0.5f, -4}, {-3, 1.5f, -3}, 0);
    scene.sun = Sun{normalize(vec3(0.3f, 1.0f, -0.4f)), vec3(2.0f), false};
    return scene;
}

Options smallOptions()
{
    Options options;
    options.sunlight.mapSize = 256;
    options.refraction.targetSize = options.reflection.targetSize = 128;
    options.caustics.photons = options.caustics.textureSize = 64;
    return options;
}

Camera cameraAt(const vec3& eye, const vec3& target = vec3(0.0f))
{
    Camera camera;
    camera.eye = eye;
    camera.target = target;
    return camera;
}

/// A renderer that plans, and one that draws everything.
struct Pair {
    Pair(const Scene& scene, Options o) : options(o), planned(scene, o), full(scene, unplanned(o)), water(scene.water)
    {}

    static Options unplanned(Options options)
    {
        options.plan.enabled = false;
        return options;
    }

    void change(const Options& to)
    {
        options = to;
        planned.renderer.setOptions(to, water);
        full.renderer.setOptions(unplanned(to), water);
    }

    /// Draws both and expects the same picture.
    const FrameReport& draw(const Camera& camera, double time)
    {
        const FrameReport& stats = planned.renderer.render({camera, time, size});
        full.renderer.render({camera, time, size});
        const Image a = planned.renderer.readDisplay(), b = full.renderer.readDisplay();
        int most = 0;
        for (std::size_t i = 0; i < b.bytes.size(); ++i)
            most = std::max(most, std::abs(int(a.bytes[i]) - int(b.bytes[i])));
        EXPECT_LE(most, 1) << "at " << time << " from " << camera.eye.x << ", " << camera.eye.y << ", " << camera.eye.z;
        return stats;
    }

    Options options;
    TestRenderer planned, full;
    WaterBody water;
};

bool drew(const FrameReport& stats, PassId pass)
{
    return std::any_of(stats.passes.begin(), stats.passes.end(), [&](const FrameReport::Pass& drawn) {
        return drawn.name == passName(pass) && drawn.drawCalls > 0;
    });
}

} // namespace

TEST(FrameKept, NothingIsDrawnAgainWhileNothingChanges)
{
    const Scene scene = pond();
    Pair pair(scene, smallOptions());
    const Camera camera = cameraAt({0, 2, 7});
    EXPECT_FALSE(pair.draw(camera, 0.0).rule(RuleId::keepFrame).applies);
    const FrameReport& again = pair.draw(camera, 5.0); // still water: time moves nothing
    EXPECT_TRUE(again.rule(RuleId::keepFrame).applies);
    EXPECT_TRUE(again.passes.empty());
    EXPECT_FALSE(pair.draw(cameraAt({0, 2, 6.9f}), 5.0).rule(RuleId::keepFrame).applies);
    Options brighter = pair.options;
    brighter.frame.exposure = 2.0f;
    pair.change(brighter);
    const FrameReport& changed = pair.draw(cameraAt({0, 2, 6.9f}), 5.0);
    EXPECT_FALSE(changed.rule(RuleId::keepFrame).applies);
    brighter.plan.rules[static_cast<std::size_t>(RuleId::keepFrame)] = false;
    pair.change(brighter);
    pair.draw(camera, 5.0);
    EXPECT_FALSE(pair.draw(camera, 5.0).rule(RuleId::keepFrame).applies);
}

TEST(FrameKept, APausedMomentIsKeptAndTheNextOneIsNot)
{
    Scene scene = pond();
    scene.water.waves = {{0.05f, 2.0f, 0.4f, 0.0f, 0.0f}};
    Pair pair(scene, smallOptions());
    const Camera camera = cameraAt({0, 2, 7});
    pair.draw(camera, 0.5);
    EXPECT_TRUE(pair.draw(camera, 0.5).rule(RuleId::keepFrame).applies);
    EXPECT_FALSE(pair.draw(camera, 0.6).rule(RuleId::keepFrame).applies);
}

// Waves move, the eye does not: what the targets hold is the same but for the caustics in it.
TEST(FrameKept, TargetsStayWhileOnlyTheSurfaceMoves)
{
    Scene scene = pond();
    scene.water.waves = {{0.05f, 2.0f, 0.4f, 0.0f, 0.0f}, {0.02f, 0.9f, 1.2f, 0.0f, 0.0f}};
    Options options = smallOptions();
    options.caustics.enabled = false;
    Pair pair(scene, options);
    const Camera camera = cameraAt({0, 2, 7});
    pair.draw(camera, 0.0);
    const FrameReport& moved = pair.draw(camera, 0.3);
    EXPECT_TRUE(moved.rule(RuleId::keepTargets).applies) << moved.rule(RuleId::keepTargets).why;
    EXPECT_FALSE(drew(moved, PassId::refraction));
    EXPECT_FALSE(drew(moved, PassId::reflection));
    EXPECT_TRUE(drew(pair.draw(cameraAt({0, 2.1f, 7}), 0.3), PassId::refraction));
    options.caustics.enabled = true;
    pair.change(options);
    pair.draw(camera, 0.3);
    EXPECT_TRUE(drew(pair.draw(camera, 0.6), PassId::refraction)) << "the caustics on the bed have moved";
}

TEST(FrameKept, CausticsOfStillWaterAreMadeOnce)
{
    Scene scene = pond();
    Options options = smallOptions();
    options.caustics.extent = 40.0f; // all of the water, wherever the eye is
    Pair pair(scene, options);
    EXPECT_TRUE(drew(pair.draw(cameraAt({0, 2, 7}), 0.0), PassId::caustics));
    const FrameReport& moved = pair.draw(cameraAt({1, 3, 6}), 1.0);
    EXPECT_FALSE(drew(moved, PassId::caustics));
    EXPECT_NE(moved.rule(RuleId::keepMaps).why.find("caustics"), std::string::npos);
    scene.water.waves = {{0.05f, 2.0f, 0.4f, 0.0f, 0.0f}};
    pair.water = scene.water;
    pair.change(pair.options);
    EXPECT_TRUE(drew(pair.draw(cameraAt({1, 3, 6}), 1.0), PassId::caustics));
    EXPECT_TRUE(drew(pair.draw(cameraAt({1, 3, 6}), 1.1), PassId::caustics));
}

// A wall before the water, and steps aside: what the last frame saw decides only whether this one asks.
TEST(FrameHiddenWater, NoFrameIsWrongWhenTheEyeJumps)
{
    Scene scene = pond();
    scene.water.waves = {{0.05f, 2.0f, 0.4f, 0.0f, 0.0f}};
    addBox(scene, {-30, -2, 16}, {30, 8, 17}, 0);
    Pair pair(scene, smallOptions());
    const Camera behind = cameraAt({0, 2, 20}, {0, 1, 0}), before = cameraAt({0, 2, 12}),
                 aside = cameraAt({0, 9.5f, 20});
    const auto asks = [](const FrameReport& stats) { return stats.rule(RuleId::waterHidden).applies; };
    EXPECT_FALSE(asks(pair.draw(before, 0.0)));
    EXPECT_FALSE(asks(pair.draw(behind, 0.1))) << "nothing hid the water before";
    EXPECT_TRUE(asks(pair.draw(behind, 0.2)));
    EXPECT_TRUE(asks(pair.draw(aside, 0.3))) << "over the wall some water is seen, which the frame itself finds out";
    EXPECT_FALSE(asks(pair.draw(aside, 0.4)));
    pair.draw(behind, 0.5);
    EXPECT_TRUE(asks(pair.draw(behind, 0.6)));
    EXPECT_TRUE(asks(pair.draw(before, 0.7)));
    EXPECT_FALSE(asks(pair.draw(before, 0.8)));
}

// The sun's highlight goes with the water, and nothing of an earlier frame's stays.
TEST(FrameHiddenWater, TheGlowOfHiddenWaterDoesNotStay)
{
    Scene scene = pond();
    scene.water.waves = {{0.05f, 2.0f, 0.4f, 0.0f, 0.0f}};
    scene.sun->direction = normalize(vec3(0.0f, 0.4f, -1.0f));
    addBox(scene, {-30, -2, 16}, {30, 8, 17}, 0);
    Pair pair(scene, smallOptions());
    const Camera behind = cameraAt({0, 2, 20}, {0, 1, 0}), before = cameraAt({0, 2, 12});
    pair.draw(before, 0.0);
    const Image glowing = pair.planned.renderer.readDisplay();
    pair.draw(behind, 0.1);
    const FramePlan& plan = pair.draw(behind, 0.2).plan;
    EXPECT_TRUE(plan.rule(RuleId::waterHidden).applies) << plan.rule(RuleId::waterHidden).why;
    EXPECT_TRUE(plan[PassId::glow].wanted) << plan[PassId::glow].reason;
    pair.draw(before, 0.3);
    Options dull = smallOptions();
    dull.glow.enabled = false;
    pair.change(dull);
    pair.draw(before, 0.0);
    EXPECT_NE(pair.planned.renderer.readDisplay().bytes, glowing.bytes) << "nothing glowed";
}

// A wall before a part of the water: its blocks are asked for, and drawn as soon as some of their box is seen.
TEST(FrameHiddenWater, BlocksComeBackInTheFrameThatSeesThem)
{
    Scene scene = pond();
    scene.water.waves = {{0.05f, 2.0f, 0.4f, 0.0f, 0.0f}};
    addBox(scene, {-30, -2, 10}, {0, 8, 11}, 0);
    Pair pair(scene, smallOptions());
    const auto asks = [](const FrameReport& stats) { return stats.rule(RuleId::cullHidden).applies; };
    const Camera left = cameraAt({-6, 2, 14}, {-3, 0, 0}), right = cameraAt({9, 2, 14}, {0, 0, 0});
    EXPECT_FALSE(asks(pair.draw(left, 0.0))) << "nothing is known yet";
    EXPECT_TRUE(asks(pair.draw(left, 0.1)));
    EXPECT_TRUE(asks(pair.draw(right, 0.2)));
    EXPECT_TRUE(asks(pair.draw(left, 0.3)));
    EXPECT_TRUE(asks(pair.draw(cameraAt({-6, 9, 14}, {-3, 0, 0}), 0.4))) << "over the wall";
    pair.draw(cameraAt({-6, -0.5f, 4}, {-3, 0, 0}), 0.5); // from below
    pair.draw(cameraAt({-6, 0.02f, 4}, {-3, 0, 0}), 0.6); // across
    Options off = pair.options;
    off.plan.rules[static_cast<std::size_t>(RuleId::cullHidden)] = false;
    pair.change(off);
    pair.draw(left, 0.7);
    EXPECT_FALSE(asks(pair.draw(left, 0.8)));
}

// Each rule where it applies, against the full frame: pictures differ by a step of the display at most.
TEST(FrameLeftOut, WhatIsNotThereIsNotMissed)
{
    Scene scene = pond();
    scene.water.waves = {{0.03f, 2.0f, 0.4f, 0.0f, 0.0f}};
    scene.elements.clear(); // no bed, and nothing over it
    Pair pair(scene, smallOptions());
    const FramePlan& plan = pair.draw(cameraAt({0, 2, 7}), 0.2).plan;
    for (const RuleId id : {RuleId::onlySkyMirrored, RuleId::noBed, RuleId::nothingForCaustics})
        EXPECT_TRUE(plan.rule(id).applies) << rule(id).name << ": " << plan.rule(id).why;
    EXPECT_FALSE(plan[PassId::refraction].wanted);
    EXPECT_FALSE(plan[PassId::reflection].wanted);
}

TEST(FrameLeftOut, ABedUnderTooMuchWaterIsNotMissed)
{
    Scene scene = flatLake(6.0f, 30.0f);
    scene.sun = Sun{normalize(vec3(0.3f, 1.0f, -0.4f)), vec3(2.0f), false};
    scene.water.waves = {{0.03f, 2.0f, 0.4f, 0.0f, 0.0f}};
    scene.water.absorption = vec3(1.2f);
    Pair pair(scene, smallOptions());
    EXPECT_TRUE(pair.draw(cameraAt({0, 2, 7}), 0.2).rule(RuleId::bedTooDeep).applies);
    scene.water.absorption = vec3(0.2f);
    pair.water = scene.water;
    pair.change(pair.options);
    EXPECT_FALSE(pair.draw(cameraAt({0, 2, 7}), 0.2).rule(RuleId::bedTooDeep).applies);
}

TEST(FrameLeftOut, AGlowBehindTheEyeIsNotMissed)
{
    Scene scene = pond();
    scene.water.waves = {{0.02f, 2.0f, 0.4f, 0.0f, 0.0f}};
    scene.sun->direction = normalize(vec3(0.0f, 0.4f, 1.0f));
    Options options = smallOptions();
    options.glow.strength = 10.0f;
    Pair pair(scene, options);
    EXPECT_TRUE(pair.draw(cameraAt({0, 2, 7}), 0.2).rule(RuleId::glowOutOfView).applies);
    EXPECT_FALSE(pair.draw(cameraAt({0, 2, -7}), 0.2).rule(RuleId::glowOutOfView).applies) << "towards the sun";
}

// A calm pond far away fills a strip of the picture. Only what its looks may need of the target is drawn; a debug view
// has all of it.
TEST(FrameLeftOut, WhatNoWaterOnTheScreenCanMirrorIsNotMissed)
{
    Scene scene = pond();
    scene.water.extent = vec2(8.0f, 6.0f);
    scene.water.waves = {{0.004f, 1.3f, 0.3f, 0.0f, 0.0f}, {0.001f, 0.4f, 1.2f, 0.0f, 0.0f}};
    addBox(scene, {-3, 1, -9}, {3, 4, -8}, 0);    // mirrored
    addBox(scene, {14, 1, -60}, {22, 6, -50}, 0); // in the mirrored camera's frustum, and in no mirror
    Pair pair(scene, smallOptions());
    const auto triangles = [](const FrameReport& stats) {
        for (const FrameReport::Pass& pass : stats.passes)
            if (pass.name == passName(PassId::reflection)) return pass.triangles;
        return std::size_t{0};
    };
    const Camera camera = cameraAt({3, 14, 30}, {0, 1, 0});
    const FrameReport bounded = pair.draw(camera, 0.2);
    EXPECT_TRUE(bounded.rule(RuleId::targetBounds).applies) << bounded.rule(RuleId::targetBounds).why;
    pair.planned.renderer.render({camera, 0.2, size, DebugView::reflection, true});
    pair.full.renderer.render({camera, 0.2, size, DebugView::reflection});
    const Image a = pair.planned.renderer.readLinear(), b = pair.full.renderer.readLinear();
    float most = 0.0f;
    for (std::size_t k = 0; k < b.floats.size(); ++k) most = std::max(most, std::abs(a.floats[k] - b.floats[k]));
    EXPECT_LT(most, 1.0e-3f);
    Options whole = pair.options;
    whole.plan.rules[static_cast<std::size_t>(RuleId::targetBounds)] = false;
    pair.change(whole);
    EXPECT_LT(triangles(bounded), triangles(pair.draw(camera, 0.2)));
    for (const vec3& eye : {vec3(20, 14, 20), vec3(-3, 25, 18), vec3(0, 9, -14)}) {
        pair.change(smallOptions());
        pair.draw(cameraAt(eye, {0, 0, 0}), 0.3);
    }
}

// A debug view of the moment that a picture was just drawn of shows what that picture did not need.
TEST(FrameLeftOut, DebugViewsOfTheSameMomentHaveIt)
{
    Scene scene = flatLake(3.0f, 30.0f);
    scene.water.waves = {{0.03f, 2.0f, 0.4f, 0.0f, 0.0f}};
    Pair pair(scene, smallOptions());
    const Camera camera = cameraAt({0, 2, 7});
    EXPECT_TRUE(pair.draw(camera, 0.2).rule(RuleId::onlySkyMirrored).applies);
    for (const DebugView view : {DebugView::reflection, DebugView::reflectionHit, DebugView::positionW}) {
        pair.planned.renderer.render({camera, 0.2, size, view, true});
        pair.full.renderer.render({camera, 0.2, size, view});
        const Image a = pair.planned.renderer.readLinear(), b = pair.full.renderer.readLinear();
        float most = 0.0f;
        for (std::size_t k = 0; k < b.floats.size(); ++k) most = std::max(most, std::abs(a.floats[k] - b.floats[k]));
        EXPECT_LT(most, 1.0e-3f);
    }
}

} // namespace tarn::test
