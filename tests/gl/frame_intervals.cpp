// Targets that are drawn in every n-th frame only: which frames draw them, and that the others show the same
// picture.
#include "gl/shader_library.h"
#include "test_renderer.h"
#include "test_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace tarn::test {
namespace {

constexpr ivec2 size(96, 72);

/// A bed, a thing in the water, a thing over it, a sun, and waves that move.
Scene livelyPond()
{
    Scene scene = flatLake(2.0f, 30.0f);
    addBox(scene, {-1, -1.9f, -1}, {1, -0.7f, 1}, addMaterial(scene, vec3(0.6f, 0.2f, 0.1f)));
    addBox(scene, {-4, -0.5f, -4}, {-3, 1.5f, -3}, addMaterial(scene, vec3(0.1f, 0.2f, 0.6f)));
    scene.sun = Sun{normalize(vec3(0.3f, 1.0f, -0.4f)), vec3(2.0f), false};
    Wave wave;
    wave.amplitude = 0.01f;
    wave.wavelength = 1.5f;
    wave.direction = 30.0f;
    scene.water.waves = {wave};
    return scene;
}

Options smallOptions(int interval)
{
    Options options;
    options.sunlight.mapSize = 256;
    options.refraction.targetSize = options.reflection.targetSize = 256;
    options.caustics.photons = options.caustics.textureSize = 64;
    options.refraction.interval = options.reflection.interval = options.caustics.interval = interval;
    return options;
}

/// Moves slowly to the right.
Camera cameraAt(int frame)
{
    Camera camera;
    camera.eye = vec3(-0.5f + 0.03f * static_cast<float>(frame), 2.0f, 6.0f);
    camera.target = vec3(camera.eye.x, 0.0f, 0.0f);
    return camera;
}

constexpr double secondsPerFrame = 1.0 / 30.0;

bool draws(const FrameReport& stats, PassId pass)
{
    const auto isIt = [&](const FrameReport::Pass& one) { return one.name == passName(pass); };
    return std::any_of(stats.passes.begin(), stats.passes.end(), isIt);
}

constexpr PassId targets[] = {PassId::caustics, PassId::refraction, PassId::reflection};

/// The mean difference of two shown pictures, in levels.
double difference(const Image& a, const Image& b)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < a.bytes.size(); ++i) sum += std::abs(int(a.bytes[i]) - int(b.bytes[i]));
    return sum / static_cast<double>(a.bytes.size());
}

TEST(FrameIntervals, TargetsTakeTurns)
{
    const Scene scene = livelyPond();
    TestRenderer test(scene, smallOptions(3));
    for (int frame = 0; frame < 10; ++frame) {
        const FrameReport& stats = test.renderer.render({cameraAt(frame), frame * secondsPerFrame, size});
        int drawn = 0;
        for (const PassId pass : targets) {
            drawn += draws(stats, pass) ? 1 : 0;
            EXPECT_TRUE(stats.plan[pass].wanted);
            EXPECT_EQ(stats.isReused(pass), !draws(stats, pass)) << passName(pass);
        }
        EXPECT_EQ(drawn, frame == 0 ? 3 : 1) << frame;
    }
}

// What was drawn from where the eye was is looked up from there.
TEST(FrameIntervals, AMovingEyeSeesThePicture)
{
    const Scene scene = livelyPond();
    Options one = smallOptions(1), three = smallOptions(3);
    one.caustics.enabled = three.caustics.enabled = false; // which move with the waves, not with the eye
    TestRenderer every(scene, one), third(scene, three);
    double most = 0.0, frameToFrame = 0.0;
    Image last;
    for (int frame = 0; frame < 7; ++frame) {
        const FrameInput input{cameraAt(frame), frame * secondsPerFrame, size};
        every.renderer.render(input);
        third.renderer.render(input);
        const Image full = every.renderer.readDisplay();
        most = std::max(most, difference(third.renderer.readDisplay(), full));
        if (frame > 0) frameToFrame = std::max(frameToFrame, difference(full, last));
        last = full;
    }
    EXPECT_GT(most, 0.0);
    EXPECT_LT(most, 0.5);
    EXPECT_LT(most, 0.3 * frameToFrame); // a picture of the last frame's would be off by as much
}

TEST(FrameIntervals, AJumpAndAnotherOptionDrawAll)
{
    const Scene scene = livelyPond();
    Options options = smallOptions(4);
    TestRenderer every(scene, smallOptions(1)), fourth(scene, options);
    const auto same = [&](const Camera& camera, double time) {
        every.renderer.render({camera, time, size});
        const FrameReport& stats = fourth.renderer.render({camera, time, size});
        for (const PassId pass : targets) EXPECT_EQ(draws(stats, pass), stats.plan[pass].wanted) << passName(pass);
        EXPECT_EQ(every.renderer.readDisplay().bytes, fourth.renderer.readDisplay().bytes);
    };
    same(cameraAt(0), 0.0);
    fourth.renderer.render({cameraAt(1), secondsPerFrame, size});
    same(cameraAt(200), 1.0); // both elsewhere and later
    Camera away = cameraAt(200);
    away.target += vec3(6.0f, 0.0f, 0.0f);
    fourth.renderer.render({cameraAt(200), 1.0 + secondsPerFrame, size});
    same(away, 2.0);
    options.frame.exposure = 0.9f;
    fourth.renderer.setOptions(options, scene.water);
    Options plain = smallOptions(1);
    plain.frame.exposure = 0.9f;
    every.renderer.setOptions(plain, scene.water);
    same(away, 3.0);
}

// When nothing moves any more, all of the picture is of its moment within an interval, and then kept.
TEST(FrameIntervals, AtRestThePictureIsThatOfAllTargets)
{
    const Scene scene = livelyPond();
    TestRenderer every(scene, smallOptions(1)), fourth(scene, smallOptions(4));
    for (int frame = 0; frame < 6; ++frame) fourth.renderer.render({cameraAt(frame), frame * secondsPerFrame, size});
    const FrameInput rest{cameraAt(6), 6 * secondsPerFrame, size};
    every.renderer.render(rest);
    int frames = 0;
    while (frames < 20 && !fourth.renderer.render(rest).rule(RuleId::keepFrame).applies) ++frames;
    EXPECT_GT(frames, 1);
    EXPECT_LE(frames, 8);
    EXPECT_EQ(every.renderer.readDisplay().bytes, fourth.renderer.readDisplay().bytes);
}

// Each eye has targets of its own.
TEST(FrameIntervals, TwoEyesDrawTheirTargets)
{
    const Scene scene = livelyPond();
    Options options = smallOptions(3);
    options.stereo.output = StereoOptions::Output::sideBySide;
    TestRenderer test(scene, options);
    for (int frame = 0; frame < 4; ++frame) {
        const FrameReport& stats = test.renderer.render({cameraAt(frame), frame * secondsPerFrame, size});
        EXPECT_TRUE(draws(stats, PassId::refraction));
        EXPECT_TRUE(draws(stats, PassId::reflection));
    }
}

} // namespace
} // namespace tarn::test
