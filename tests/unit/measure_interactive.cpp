// The delay from input to picture, on a clock that the test moves; and the recorded flight.
#include "app/recorded_flight.h"
#include "base/error.h"
#include "measure/interactive.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace tarn {
namespace {

/// Draws frames that take as long as they are told; the last duration goes on.
struct FakeScreen {
    std::vector<double> durations;
    double time = 1000.0; // clocks do not begin at zero
    std::vector<InteractiveFrame> frames{};

    InteractiveTimes play(std::span<const double> due)
    {
        return playInputs(
            due, [this] { return time; },
            [this](const InteractiveFrame& frame) {
                time += durations[std::min(frames.size(), durations.size() - 1)];
                frames.push_back(frame);
            });
    }
};

void expectNear(const std::vector<double>& values, const std::vector<double>& expected)
{
    ASSERT_EQ(values.size(), expected.size());
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i], expected[i], 1e-6) << i;
}

TEST(Interactive, AnInputWaitsForTheFrameUnderWayAndForItsOwn)
{
    FakeScreen screen{{0.100}};
    // At the beginning; just after the first frame began; as the second begins; late in the second.
    const InteractiveTimes times = screen.play(std::vector<double>{0.0, 0.001, 0.1, 0.19});
    expectNear(times.frameMs, {100.0, 100.0, 100.0});
    expectNear(times.delayMs, {100.0, 199.0, 100.0, 110.0});
    ASSERT_EQ(screen.frames.size(), 3u);
    EXPECT_EQ(screen.frames[1].firstInput, 1u);
    EXPECT_EQ(screen.frames[1].inputCount, 2u) << "both that came during the first frame";
    EXPECT_NEAR(screen.frames[2].time, 0.2, 1e-9);
}

TEST(Interactive, OneSlowFrameIsTheLongestDelayOfAllThatWaitedForIt)
{
    FakeScreen screen{{0.015, 0.500, 0.015}};
    std::vector<double> due;
    for (int i = 0; i <= 100; ++i) due.push_back(0.01 * i);
    const InteractiveTimes times = screen.play(due);
    ASSERT_EQ(times.delayMs.size(), due.size()) << "every input is shown";
    // The input of 10 ms is taken by the slow frame at 15 ms; the one of 20 ms comes during it and waits for
    // the next.
    EXPECT_NEAR(times.delayMs[1], 505.0, 1e-6);
    EXPECT_NEAR(times.delayMs[2], 510.0, 1e-6);
    EXPECT_NEAR(*std::max_element(times.frameMs.begin(), times.frameMs.end()), 500.0, 1e-6);
    EXPECT_LT(times.delayMs.back(), 31.0);
}

TEST(Interactive, PlaysUntilTheLastInputIsSeen)
{
    FakeScreen screen{{0.3}};
    const InteractiveTimes times = screen.play(std::vector<double>{1.0});
    expectNear(times.frameMs, {300.0, 300.0, 300.0, 300.0, 300.0});
    expectNear(times.delayMs, {500.0});
}

TEST(Interactive, RefusesWhatIsNoRecording)
{
    FakeScreen screen{{0.1}};
    EXPECT_THROW(screen.play({}), Error);
    EXPECT_THROW(screen.play(std::vector<double>{0.2, 0.1}), Error);
    EXPECT_THROW(screen.play(std::vector<double>{-0.1}), Error);
}

TEST(Interactive, TellsPercentiles)
{
    InteractiveTimes times;
    for (int i = 0; i <= 100; ++i) {
        times.frameMs.push_back(i);
        times.delayMs.push_back(2 * i);
    }
    const nlohmann::json json = toJson(times);
    EXPECT_DOUBLE_EQ(json["frame_ms"]["p99"], 99.0);
    EXPECT_DOUBLE_EQ(json["input_to_picture_ms"]["p95"], 190.0);
    EXPECT_DOUBLE_EQ(json["input_to_picture_ms"]["median"], 100.0);
    EXPECT_NE(toTable(times).find("input to picture, ms"), std::string::npos);
    EXPECT_NE(toTable(times).find("198.0"), std::string::npos) << toTable(times);
}

TEST(RecordedFlight, IsInOrderAndJumpsToEveryCamera)
{
    const std::vector<RecordedInput> inputs = recordFlight(3, 6.0);
    std::vector<double> jumps;
    std::size_t looks = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (i > 0) {
            EXPECT_GE(inputs[i].due, inputs[i - 1].due);
        }
        EXPECT_LT(inputs[i].due, 6.0);
        if (std::holds_alternative<RecordedInput::Jump>(inputs[i].what)) jumps.push_back(inputs[i].due);
        looks += std::holds_alternative<RecordedInput::Look>(inputs[i].what) ? 1 : 0;
    }
    expectNear(jumps, {0.0, 2.0, 4.0});
    EXPECT_NEAR(static_cast<double>(looks), 6.0 * 60.0, 3.0) << "a report of the mouse each 60th of a second";
    EXPECT_THROW(recordFlight(0, 1.0), Error);
    EXPECT_THROW(recordFlight(1, 0.0), Error);
}

TEST(RecordedFlight, ThePilotFliesAtRealSpeedWhateverTheFrameRate)
{
    Camera start;
    start.eye = vec3(0.0f, 2.0f, 0.0f);
    start.target = vec3(0.0f, 2.0f, -10.0f);
    const std::vector<Camera> cameras{start};
    const std::vector<RecordedInput> inputs = {{0.0, RecordedInput::Jump{0}}, {0.0, RecordedInput::Press{keyOf('W')}}};
    for (const double step : {0.01, 0.2}) {
        RecordedPilot pilot(cameras);
        pilot.take(inputs, 0.0);
        for (int i = 1; i * step <= 1.0 + 1e-9; ++i) pilot.take({}, i * step);
        EXPECT_NEAR(pilot.camera().eye.z, -FlyCamera(start).speed(), 1e-3f) << step;
    }
}

TEST(RecordedFlight, LooksAsFarAsTheMouseGoes)
{
    const std::vector<Camera> cameras(1);
    RecordedPilot pilot(cameras);
    pilot.take(std::vector<RecordedInput>{{0.0, RecordedInput::Look{{0.5f, 0.0f}}}}, 0.0);
    FlyCamera turned(cameras.front());
    turned.look({0.5f, 0.0f}, 1.0f);
    EXPECT_EQ(pilot.camera().target, turned.camera().target);
    EXPECT_NE(pilot.camera().target, cameras.front().target);
}

} // namespace
} // namespace tarn
