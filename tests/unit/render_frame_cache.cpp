// What a frame keeps from an earlier one, and what it takes to be drawn anew: a row for each thing that may change.
#include "test_scenes.h"

#include "render/frame_cache.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace tarn::test {

namespace {

/// All that a frame's pictures and maps are asked for by.
struct Asked {
    FrameKey key;
    CausticsKey caustics;
    TargetUse refraction, reflection;
};

FrameKey movingKey()
{
    FrameKey key;
    key.water.present = true;
    key.water.waves = {{0.05f, 2.0f, 0.4f, 0.0f, 0.0f}};
    key.camera.eye = {0, 2, 7};
    key.time = 1.0;
    key.size = {64, 48};
    return key;
}

Asked firstFrame()
{
    Asked asked;
    asked.key = movingKey();
    asked.caustics.light.time = 1.0f;
    asked.refraction = asked.reflection = {asked.key.camera, WaterSide::above, {}, true, true};
    return asked;
}

/// What a frame finds as it needs it.
struct Held {
    bool frame = false, caustics = false, refraction = false, reflection = false;
    bool operator==(const Held&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Held& held)
{
    return out << "frame " << held.frame << ", caustics " << held.caustics << ", refraction " << held.refraction
               << ", reflection " << held.reflection;
}

/// Asks for everything and draws what is not there, as the renderer does.
Held draw(FrameCache& cache, const Asked& asked)
{
    Held held;
    held.frame = cache.holdsFrame(asked.key);
    cache.beginFrame(asked.key);
    held.caustics = cache.holdsCaustics(asked.caustics);
    if (!held.caustics) cache.causticsWereDrawn(asked.caustics);
    held.refraction = cache.holdsTarget(PassId::refraction, asked.refraction);
    cache.targetShows(PassId::refraction, asked.refraction);
    held.reflection = cache.holdsTarget(PassId::reflection, asked.reflection);
    cache.targetShows(PassId::reflection, asked.reflection);
    cache.endFrame();
    return held;
}

constexpr Held everything{true, true, true, true}, nothing{};

void setCamera(Asked& asked, const vec3& eye)
{
    asked.key.camera.eye = asked.refraction.camera.eye = asked.reflection.camera.eye = eye;
}

} // namespace

TEST(FrameCache, AFirstFrameDrawsAllAndItsTwinNothing)
{
    FrameCache cache;
    EXPECT_EQ(draw(cache, firstFrame()), nothing);
    EXPECT_EQ(draw(cache, firstFrame()), everything);
}

TEST(FrameCache, WhatInvalidatesWhat)
{
    struct Row {
        const char* what;
        std::function<void(Asked&)> change;
        Held left; ///< of the first frame, what the second still finds
    };
    const std::vector<Row> rows{
        {"an option of the frame", [](Asked& a) { a.key.options.frame.exposure = 2.0f; }, {false, true, false, false}},
        {"an option of the caustics", [](Asked& a) { a.key.options.caustics.photons = 100; }, nothing},
        {"an option of the sun's maps", [](Asked& a) { a.key.options.sunlight.taps = 4; }, nothing},
        {"the water", [](Asked& a) { a.key.water.ior = 1.2f; }, {false, true, false, false}},
        {"the camera",
         [](Asked& a) {
             setCamera(a, {1, 2, 7});
         },
         {false, true, false, false}},
        {"the time: targets show no waves, unless they show caustics",
         [](Asked& a) {
             a.key.time = 2.0;
             a.caustics.waves.waves[0].phase = 1.0f;
             a.reflection.showsCaustics = false;
         },
         nothing}, // the reflection's key had caustics in it
        {"the size",
         [](Asked& a) {
             a.key.size = {32, 48};
         },
         {false, true, false, false}},
        {"the debug view", [](Asked& a) { a.key.view = DebugView::normals; }, {false, true, true, true}},
        {"a shader's file", [](Asked& a) { a.key.rebuilt = 1; }, nothing},
        {"the sample", [](Asked& a) { a.key.sample = 2; }, {false, true, true, true}},
        {"the sun",
         [](Asked& a) {
             a.caustics.light.sunDirection = {0, 1, 0};
         },
         {true, false, false, false}},
        {"the clock in the light's block alone", [](Asked& a) { a.caustics.light.time = 9.0f; }, everything},
        {"where the caustics lie",
         [](Asked& a) { a.caustics.region.rect.centre.x = 3.0f; },
         {true, false, false, false}},
        {"the side of the surface", [](Asked& a) { a.refraction.side = WaterSide::below; }, {true, true, false, true}},
        {"what is drawn of a target", [](Asked& a) { a.reflection.bounds.upper.x = 0.5f; }, {true, true, true, false}},
        {"that there are caustics", [](Asked& a) { a.refraction.hasCaustics = false; }, {true, true, false, true}},
    };
    for (const Row& row : rows) {
        FrameCache cache;
        draw(cache, firstFrame());
        Asked second = firstFrame();
        row.change(second);
        EXPECT_EQ(draw(cache, second), row.left) << row.what;
        EXPECT_EQ(draw(cache, second), everything) << row.what << ", and then stays";
    }
}

// A target that shows nothing that caustics light does not mind when they are drawn anew.
TEST(FrameCache, CausticsAgeOnlyWhatShowsThem)
{
    FrameCache cache;
    Asked asked = firstFrame();
    asked.reflection.showsCaustics = false;
    draw(cache, asked);
    asked.key.time = 2.0;
    asked.caustics.waves.waves[0].phase = 1.0f;
    EXPECT_EQ(draw(cache, asked), (Held{false, false, false, true}));
}

TEST(FrameCache, StillWaterIsTheSameAtAnyTime)
{
    FrameCache cache;
    Asked asked = firstFrame();
    asked.key.water.waves.clear();
    draw(cache, asked);
    asked.caustics.waves.waves[0].phase = 1.0f; // of waves without height
    EXPECT_EQ(draw(cache, asked), everything);

    Camera camera;
    FrameInput input{camera, 5.0};
    EXPECT_EQ(frameKeyOf(input, {}, asked.key.water, 0).time, 0.0);
    EXPECT_EQ(frameKeyOf(input, {}, movingKey().water, 0).time, 5.0);
}

TEST(FrameCache, WhatIsForgottenIsDrawn)
{
    FrameCache cache;
    draw(cache, firstFrame());
    cache.forgetTargets();
    EXPECT_EQ(draw(cache, firstFrame()), (Held{true, true, false, false}));
    cache.forget();
    EXPECT_EQ(draw(cache, firstFrame()), nothing);
}

// Asking changes nothing.
TEST(FrameCache, QuestionsLeaveItAsItIs)
{
    FrameCache cache;
    const Asked asked = firstFrame();
    cache.beginFrame(asked.key);
    for (int i = 0; i < 2; ++i) {
        EXPECT_FALSE(cache.holdsFrame(asked.key));
        EXPECT_FALSE(cache.holdsCaustics(asked.caustics));
        EXPECT_FALSE(cache.holdsTarget(PassId::refraction, asked.refraction));
        EXPECT_FALSE(cache.mayReuse(PassId::refraction, asked.key.camera, WaterSide::above));
    }
}

// What is drawn in every third frame takes turns, and a picture that used something old is not kept.
TEST(FrameCache, IntervalsTakeTurnsAndEndAtRest)
{
    FrameCache cache;
    FrameKey key = movingKey();
    key.options.refraction.interval = key.options.reflection.interval = key.options.caustics.interval = 3;
    const auto frame = [&](double time) {
        key.time = time;
        cache.beginFrame(key);
        std::string drawn;
        if (cache.mayReuse(PassId::caustics, key.camera, WaterSide::above))
            cache.noteReuse(PassId::caustics, key.camera, WaterSide::above);
        else {
            CausticsKey caustics;
            caustics.waves.waves[0].phase = static_cast<float>(time);
            cache.causticsWereDrawn(caustics);
            drawn += 'c';
        }
        for (const PassId pass : {PassId::refraction, PassId::reflection}) {
            if (cache.mayReuse(pass, key.camera, WaterSide::above)) {
                cache.noteReuse(pass, key.camera, WaterSide::above);
                continue;
            }
            cache.targetShows(pass, {key.camera, WaterSide::above, {}, false, false});
            drawn += pass == PassId::refraction ? 'r' : 'm';
        }
        cache.endFrame();
        return drawn;
    };
    EXPECT_EQ(frame(0.0), "crm");
    std::string sequence;
    for (int i = 1; i <= 6; ++i) sequence += frame(0.01 * i) + ' ';
    EXPECT_EQ(sequence.size(), 12u) << sequence << ": one of the three in each frame";
    for (const char kind : {'c', 'r', 'm'})
        EXPECT_EQ(std::count(sequence.begin(), sequence.end(), kind), 2) << sequence;

    int frames = 0; // at rest: until all of it is of this time
    while (!cache.holdsFrame(key) && frames < 10) {
        frame(0.06);
        ++frames;
    }
    EXPECT_GE(frames, 1);
    EXPECT_LE(frames, 4);

    FrameKey other = key;
    other.size = {10, 10};
    cache.beginFrame(other);
    for (const PassId pass : {PassId::caustics, PassId::refraction, PassId::reflection})
        EXPECT_FALSE(cache.mayReuse(pass, key.camera, WaterSide::above)) << "another size draws all anew";
}

} // namespace tarn::test
