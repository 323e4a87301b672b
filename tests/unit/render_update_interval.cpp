// Which frames draw what is drawn in every n-th frame only.
#include "render/update_interval.h"

#include <gtest/gtest.h>

#include <array>

namespace tarn {
namespace {

UpdateState stateAt(const vec3& eye, const vec3& target, double time = 0.0)
{
    UpdateState state;
    state.water.present = true;
    state.camera.eye = eye;
    state.camera.target = target;
    state.time = time;
    state.size = {320, 240};
    return state;
}

/// In which of the frames it is drawn.
std::vector<int> drawnFrames(std::uint64_t phase, int interval, int frames)
{
    UpdateInterval update(phase);
    const UpdateState still = stateAt({0, 2, 5}, {0, 0, 0});
    std::vector<int> drawn;
    for (int i = 0; i < frames; ++i) {
        const auto frame = static_cast<std::uint64_t>(i + 1);
        if (update.serves(still, frame, interval)) continue;
        update.wasDrawn(still, frame);
        drawn.push_back(i);
    }
    return drawn;
}

TEST(UpdateInterval, EveryNthFrameDrawsAndTheFirst)
{
    EXPECT_EQ(drawnFrames(0, 1, 4), (std::vector<int>{0, 1, 2, 3}));
    EXPECT_EQ(drawnFrames(0, 2, 6), (std::vector<int>{0, 1, 3, 5}));
    EXPECT_EQ(drawnFrames(1, 2, 6), (std::vector<int>{0, 2, 4}));
    EXPECT_EQ(drawnFrames(0, 3, 9), (std::vector<int>{0, 2, 5, 8}));
}

TEST(UpdateInterval, TargetsOfOneIntervalTakeTurns)
{
    for (const int interval : {3, 4}) {
        std::array<int, 20> count{};
        for (const std::uint64_t phase : {0u, 1u, 2u})
            for (const int frame : drawnFrames(phase, interval, 20)) ++count[static_cast<std::size_t>(frame)];
        for (std::size_t i = 1; i < count.size(); ++i) EXPECT_LE(count[i], 1) << i; // the first draws all
    }
}

TEST(UpdateInterval, AJumpDraws)
{
    const UpdateState before = stateAt({0, 2, 5}, {0, 0, 0}, 1.0);
    EXPECT_FALSE(isJump(before, before));
    EXPECT_FALSE(isJump(before, stateAt({0.1f, 2, 5}, {0.1f, 0, 0}, 1.05))); // a step
    EXPECT_FALSE(isJump(before, stateAt({0, 2, 5}, {0.2f, 0, 0}, 1.05)));    // a look aside
    EXPECT_TRUE(isJump(before, stateAt({3, 2, 5}, {3, 0, 0}, 1.05)));
    EXPECT_TRUE(isJump(before, stateAt({0, 2, 5}, {4, 0, 0}, 1.05)));
    EXPECT_TRUE(isJump(before, stateAt({0, 2, 5}, {0, 0, 10}, 1.05))); // right round
    EXPECT_TRUE(isJump(before, stateAt({0, 2, 5}, {0, 0, 0}, 9.0)));
    UpdateState other = before;
    other.size.x = 321;
    EXPECT_TRUE(isJump(before, other));
    other = before;
    other.options.refraction.steps += 1;
    EXPECT_TRUE(isJump(before, other));
    other = before;
    other.water.level += 0.1f;
    EXPECT_TRUE(isJump(before, other));
    other = before;
    other.side = WaterSide::below;
    EXPECT_TRUE(isJump(before, other));
    UpdateInterval update(0);
    update.wasDrawn(before, 1);
    EXPECT_TRUE(update.serves(before, 3, 4));
    EXPECT_FALSE(update.serves(other, 3, 4));
    EXPECT_FALSE(update.serves(before, 9, 4)); // frames without it lie between
    EXPECT_FALSE(update.isStale(before));
    EXPECT_TRUE(update.isStale(stateAt({0, 2, 5}, {0, 0, 0}, 1.05)));
    EXPECT_TRUE(update.isStale(stateAt({0.1f, 2, 5}, {0, 0, 0}, 1.0)));
    update.forget();
    EXPECT_FALSE(update.serves(before, 3, 4));
}

} // namespace
} // namespace tarn
