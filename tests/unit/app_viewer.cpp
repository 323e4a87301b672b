// The parts of the viewer that need no window: keys, the flown camera, the clock, the figures, screenshot
// names.

#include "app/viewer/fly_camera.h"
#include "app/viewer/frame_rate.h"
#include "app/viewer/input_map.h"
#include "app/viewer/scene_clock.h"
#include "app/viewer/screenshot.h"
#include "app/viewer/stereo_view.h"
#include "base/files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <random>
#include <unistd.h>

namespace tarn {
namespace {

namespace fs = std::filesystem;

Action actionOf(Key key)
{
    const auto command = commandOf(key);
    return command ? command->action : Action::leave;
}

TEST(InputMap, KeysDoWhatTheManualSays)
{
    EXPECT_EQ(actionOf(keyOf('C')), Action::caustics);
    EXPECT_EQ(actionOf(keyOf('U')), Action::underwater);
    EXPECT_EQ(actionOf(keyOf('G')), Action::glow);
    EXPECT_EQ(actionOf(keyOf('R')), Action::reflection);
    EXPECT_EQ(actionOf(keyOf('F')), Action::refraction);
    EXPECT_EQ(actionOf(keyOf('P')), Action::pause);
    EXPECT_EQ(actionOf(keyOf('V')), Action::nextView);
    EXPECT_EQ(actionOf(keyOf('O')), Action::stereo);
    EXPECT_EQ(actionOf(keyOf('B')), Action::compare);
    EXPECT_EQ(actionOf(keyOf('[')), Action::sliderLeft);
    EXPECT_EQ(actionOf(keyOf(']')), Action::sliderRight);
    EXPECT_EQ(actionOf(keyOf('T')), Action::governor);
    EXPECT_EQ(actionOf(keyOf('H')), Action::help);
    EXPECT_EQ(actionOf(Key::tab), Action::panel);
    EXPECT_EQ(actionOf(Key::f12), Action::screenshot);
    EXPECT_EQ(commandOf(Key::escape)->action, Action::leave);
    EXPECT_FALSE(commandOf(keyOf('Z')).has_value());
}

TEST(InputMap, NumberKeysAreCamerasInTheirOrderOnTheKeyboard)
{
    for (int i = 0; i < 10; ++i) {
        const auto command = commandOf(keyOf("1234567890"[i]));
        ASSERT_TRUE(command);
        EXPECT_EQ(command->action, Action::camera);
        EXPECT_EQ(command->index, i);
    }
}

TEST(InputMap, HelpTellsOfEveryKey)
{
    std::string text;
    for (const HelpLine& line : helpLines()) text += line.keys + ": " + line.what + "\n";
    for (const char* key :
         {"W", "A", "S",  "D", "Q", "E", "Up", "Left", "Shift", "C",   "U",   "G",     "R",          "F",
          "P", "V", "O:", "B", "[", "]", "T:", "H",    "Tab",   "F12", "Esc", "wheel", "left button"})
        EXPECT_NE(text.find(key), std::string::npos) << key;
}

TEST(StereoView, OGoesRoundAndSaysWhere)
{
    StereoOptions options;
    EXPECT_EQ(stereoText(options), "");
    options.output = nextStereo(options.output);
    EXPECT_EQ(options.output, StereoOptions::Output::sideBySide);
    EXPECT_EQ(stereoText(options), "stereo: side by side, eyes 0.065 m apart, converging at 5 m");
    options.output = nextStereo(options.output);
    EXPECT_EQ(options.output, StereoOptions::Output::anaglyph);
    options.convergence = 12.5f;
    EXPECT_EQ(stereoText(options), "stereo: anaglyph, eyes 0.065 m apart, converging at 12.5 m");
    EXPECT_EQ(nextStereo(options.output), StereoOptions::Output::off);
    EXPECT_EQ(nextStereo(StereoOptions::Output::pair), StereoOptions::Output::anaglyph);
}

TEST(HeldKeys, AddUpAndCancelOut)
{
    HeldKeys keys;
    EXPECT_EQ(keys.direction(), vec3(0.0f));
    keys.press(keyOf('W'));
    keys.press(keyOf('D'));
    keys.press(keyOf('E'));
    EXPECT_EQ(keys.direction(), vec3(1.0f, 1.0f, 1.0f));
    keys.press(keyOf('S'));
    EXPECT_EQ(keys.direction(), vec3(1.0f, 1.0f, 0.0f));
    keys.press(Key::shift);
    EXPECT_TRUE(keys.fast());
}

TEST(HeldKeys, TwoKeysOfOneActionAreOneMotion)
{
    HeldKeys keys;
    keys.press(keyOf('W'));
    keys.press(Key::up);
    EXPECT_EQ(keys.direction(), vec3(0.0f, 0.0f, 1.0f));
    keys.release(keyOf('W'));
    EXPECT_EQ(keys.direction(), vec3(0.0f, 0.0f, 1.0f)) << "the other key is still held";
    keys.release(Key::up);
    EXPECT_EQ(keys.direction(), vec3(0.0f));
}

TEST(HeldKeys, LosingTheFocusLetsGo)
{
    HeldKeys keys;
    keys.press(keyOf('A'));
    keys.press(Key::shift);
    keys.releaseAll();
    EXPECT_EQ(keys.direction(), vec3(0.0f));
    EXPECT_FALSE(keys.fast());
}

Camera level()
{
    Camera camera;
    camera.eye = vec3(0.0f, 2.0f, 0.0f);
    camera.target = vec3(0.0f, 2.0f, -1.0f);
    camera.verticalFov = 1.0f;
    return camera;
}

void expectNear(const vec3& a, const vec3& b, float tolerance)
{
    EXPECT_LT(glm::distance(a, b), tolerance)
        << a.x << "," << a.y << "," << a.z << " is not " << b.x << "," << b.y << "," << b.z;
}

vec3 forwardOf(const FlyCamera& fly) { return glm::normalize(fly.camera().target - fly.camera().eye); }

TEST(FlyCamera, SamePathAtAnyFrameRate)
{
    FlyCamera slow(level()), quick(level());
    for (int i = 0; i < 10; ++i) slow.move({1.0f, 0.0f, 1.0f}, false, 0.1);
    for (int i = 0; i < 1000; ++i) quick.move({1.0f, 0.0f, 1.0f}, false, 0.001);
    expectNear(slow.camera().eye, quick.camera().eye, 1e-3f);
    EXPECT_NEAR(glm::distance(slow.camera().eye, level().eye), slow.speed(), 1e-3f) << "diagonals are not faster";
}

TEST(FlyCamera, MovesAlongItsOwnAxes)
{
    FlyCamera fly(level());
    fly.move({0.0f, 0.0f, 1.0f}, false, 0.1);
    expectNear(fly.camera().eye, vec3(0.0f, 2.0f, -0.1f * fly.speed()), 1e-5f);
    fly.jumpTo(level());
    fly.move({1.0f, 0.0f, 0.0f}, true, 0.1);
    EXPECT_GT(fly.camera().eye.x, 0.1f * fly.speed() * 2.0f) << "fast is faster";
    expectNear(forwardOf(fly), vec3(0.0f, 0.0f, -1.0f), 1e-6f);
}

TEST(FlyCamera, MayGoUnderWater)
{
    FlyCamera fly(level());
    for (int i = 0; i < 100; ++i) fly.move({0.0f, -1.0f, 0.0f}, false, 0.1);
    EXPECT_LT(fly.camera().eye.y, -10.0f);
}

TEST(FlyCamera, OneWindowHeightTurnsByOneFieldOfView)
{
    FlyCamera fly(level());
    fly.look({500.0f, 0.0f}, 500.0f);
    expectNear(forwardOf(fly), vec3(std::sin(1.0f), 0.0f, -std::cos(1.0f)), 1e-5f);
    fly.jumpTo(level());
    fly.look({0.0f, 250.0f}, 500.0f);
    expectNear(forwardOf(fly), vec3(0.0f, -std::sin(0.5f), -std::cos(0.5f)), 1e-5f);
    fly.look({0.0f, -1e6f}, 500.0f);
    EXPECT_GT(forwardOf(fly).y, 0.99f);
    EXPECT_LT(forwardOf(fly).y, 1.0f) << "never quite upright";
}

TEST(FlyCamera, LookingStraightDownTurnsOnlyAsFarAsTheMouse)
{
    Camera down = level();
    down.target = down.eye - vec3(0.0f, 5.0f, 0.0f);
    down.up = vec3(1.0f, 0.0f, 0.0f); // the picture's upper edge is towards +x
    FlyCamera fly(down);
    fly.look({0.0f, -250.0f}, 500.0f); // half a radian up
    const vec3 forward = forwardOf(fly);
    EXPECT_GT(forward.x, 0.3f);
    EXPECT_NEAR(forward.z, 0.0f, 1e-4f);
}

TEST(FlyCamera, NothingMakesItNaN)
{
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    FlyCamera fly(level());
    fly.look({nan, 1.0f}, 500.0f);
    fly.look({1.0f, 1.0f}, 0.0f);
    fly.move({nan, 0.0f, 0.0f}, false, 0.1);
    fly.move({0.0f, 0.0f, infinity}, false, 0.1);
    fly.move({1.0f, 0.0f, 0.0f}, false, static_cast<double>(nan));
    fly.changeSpeed(std::numeric_limits<double>::infinity());
    Camera broken = level();
    broken.eye.x = nan;
    fly.jumpTo(broken);
    broken.eye = broken.target;
    fly.jumpTo(broken);
    expectNear(fly.camera().eye, level().eye, 1e-6f);

    std::mt19937 random(1);
    std::uniform_real_distribution<float> any(-1.0f, 1.0f);
    for (int i = 0; i < 20000; ++i) {
        fly.look({3000.0f * any(random), 3000.0f * any(random)}, 300.0f);
        fly.changeSpeed(static_cast<double>(10.0f * any(random) + 1.0f));
        fly.move({any(random), any(random), any(random)}, true, 1e6);
        const Camera& camera = fly.camera();
        for (int axis = 0; axis < 3; ++axis)
            ASSERT_TRUE(std::isfinite(camera.eye[axis]) && std::isfinite(camera.target[axis])) << i;
        ASSERT_GT(glm::length(camera.target - camera.eye), 0.1f) << i;
        ASSERT_GT(glm::length(glm::cross(forwardOf(fly), camera.up)), 1e-3f) << i;
    }
}

TEST(FlyCamera, SpeedHasEnds)
{
    FlyCamera fly(level());
    const float start = fly.speed();
    fly.changeSpeed(1.0);
    EXPECT_NEAR(fly.speed(), 1.2f * start, 1e-4f);
    for (int i = 0; i < 100; ++i) fly.changeSpeed(-20.0);
    EXPECT_GT(fly.speed(), 0.0f);
    for (int i = 0; i < 100; ++i) fly.changeSpeed(20.0);
    EXPECT_LT(fly.speed(), 1e4f);
}

TEST(SceneClock, FollowsTheClockAndKeepsStillInPauses)
{
    SceneClock clock(5.0);
    clock.advance(1000.0); // the zero of a steady clock is anywhere
    EXPECT_DOUBLE_EQ(clock.time(), 5.0);
    clock.advance(1000.5);
    EXPECT_DOUBLE_EQ(clock.time(), 5.5);
    clock.togglePause();
    clock.advance(1007.0);
    EXPECT_DOUBLE_EQ(clock.time(), 5.5);
    clock.togglePause();
    clock.advance(1007.25);
    EXPECT_DOUBLE_EQ(clock.time(), 5.75) << "the pause must not be made up for";
    clock.advance(1000.0);
    EXPECT_DOUBLE_EQ(clock.time(), 5.75) << "time does not run back";
}

TEST(FrameRate, SettlesOnTheTrueRateWhateverItIs)
{
    for (const double seconds : {1.0 / 200.0, 1.0 / 30.0, 1.0}) {
        FrameRate rate;
        rate.add(0.1, {});
        for (double t = 0.0; t < 5.0; t += seconds) rate.add(seconds, {{"water", 3.0}});
        EXPECT_NEAR(rate.framesPerSecond() * seconds, 1.0, 1e-2);
        ASSERT_EQ(rate.passes().size(), 1u);
        EXPECT_NEAR(rate.passes()[0].milliseconds, 3.0, 1e-9);
    }
}

TEST(FrameRate, ForgetsPassesThatNoLongerRun)
{
    FrameRate rate;
    rate.add(0.1, {{"refraction", 1.0}, {"water", 2.0}});
    rate.add(0.1, {{"water", 4.0}});
    ASSERT_EQ(rate.passes().size(), 1u);
    EXPECT_GT(rate.passes()[0].milliseconds, 2.0);
    EXPECT_LT(rate.passes()[0].milliseconds, 4.0);
    rate.add(0.0, {});
    EXPECT_EQ(rate.passes().size(), 1u) << "no time, no frame";
}

TEST(Screenshot, TakesTheFirstFreeNameAndNeverAnother)
{
    const fs::path folder = fs::temp_directory_path() / ("tarn screenshots " + std::to_string(getpid()));
    fs::create_directories(folder);
    EXPECT_EQ(nextScreenshot(folder).filename(), "tarn-0001.png");
    writeFile(folder / "tarn-0001.png", "x");
    fs::create_symlink("nowhere", folder / "tarn-0002.png");
    EXPECT_EQ(nextScreenshot(folder).filename(), "tarn-0003.png");
    fs::remove_all(folder);
}

} // namespace
} // namespace tarn
