// What is drawn in every n-th frame only (refraction.interval, reflection.interval, caustics.interval): which
// frames draw it, and when one that does not may use what an earlier frame drew.
#pragma once

#include "plan/frame_plan.h"
#include "scene/camera.h"

#include <cstdint>
#include <optional>

namespace tarn {

/// What a target that is not drawn anew was drawn for, and a frame that would use it.
struct UpdateState {
    Options options;
    WaterBody water;
    Camera camera;
    double time = 0.0;                 ///< s
    ivec2 size{0};                     ///< of the picture, pixels
    std::size_t rebuilt = 0;           ///< programs, because their files were edited
    WaterSide side = WaterSide::above; ///< that the frame shows
    std::size_t causticsDrawn = 0;     ///< so far
};

/// Whether something changed so much that what was drawn before shows another place or another thing:
/// options, water, the picture's size; a camera that is elsewhere, or looks where a target drawn from the
/// earlier one does not reach; a leap in time.
bool isJump(const UpdateState& before, const UpdateState& now);

/// One target's. Targets of one interval have phases of their own, so that a frame does not draw all of them.
class UpdateInterval {
public:
    /// @param phase by how many frames it is due before one of phase 0
    explicit UpdateInterval(std::uint64_t phase) : phase_(phase) {}

    /// Whether a frame may use what was drawn last.
    /// @param frame counts all frames that are drawn   @param interval frames from one drawing to the next;
    /// 1: every frame draws
    bool serves(const UpdateState& now, std::uint64_t frame, int interval) const;

    /// Whether what was drawn last is not what this frame would draw: the eye or the waves have moved on.
    bool isStale(const UpdateState& now) const;

    void wasDrawn(UpdateState now, std::uint64_t frame);
    /// The next frame must draw it.
    void forget() { drawn_.reset(); }

private:
    std::uint64_t phase_;
    std::optional<UpdateState> drawn_;
    std::uint64_t drawnFrame_ = 0;
};

} // namespace tarn
