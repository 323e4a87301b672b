// What a frame is asked for, and what it did.
#pragma once

#include "plan/frame_plan.h"
#include "render/debug_view.h"
#include "scene/camera.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <string>
#include <vector>

namespace tarn {

struct FrameInput {
    const Camera& camera; ///< with stereo.output, between the eyes
    double time = 0.0;    ///< seconds
    ivec2 size{640, 480}; ///< of the picture, or of one eye's, pixels; both at least 1
    DebugView view = DebugView::final;
    /// Scene, water body, camera, time, size and options are those of the last frame: what that drew for the water to
    /// look up stays, and only the picture is drawn anew. For several debug views of one moment. Of no effect in
    /// stereo, where what is looked up is the other eye's.
    bool sameMoment = false;
    /// From 1: of the samples of a moment that are averaged, the how-many-eth this frame is. It is jittered within a
    /// pixel, and what is shown is the mean of all so far. Everything else is that of the frames before. 0: this frame
    /// alone. Of no effect in debug views and in stereo.
    int sample = 0;
    /// Looked at between passes: once it is true, render() throws FrameAbandoned. Null: the frame is drawn to its end.
    const std::atomic<bool>* abandoned = nullptr;
};

/// Nobody waits for the frame any more. What the renderer shows is undefined until the next one.
struct FrameAbandoned {};

/// What a frame did: the plan as it was made, and what came of it. Valid until the next frame.
struct FrameReport {
    FramePlan plan; ///< in stereo the right eye's
    /// The plan's rules; of those that the renderer applies, with what came of them.
    RuleStates rules;
    /// By PassId: passes whose target an earlier frame drew (refraction.interval and the like).
    std::array<bool, passCount> reused{};
    struct Pass {
        std::string name;
        std::size_t triangles = 0;
        std::size_t drawCalls = 0;
    };
    std::vector<Pass> passes; ///< in the order they began; both eyes' added up

    /// Of an eye whose drawing begins.
    void begin(FramePlan planned);
    RuleState& rule(RuleId id) { return rules[static_cast<std::size_t>(id)]; }
    const RuleState& rule(RuleId id) const { return rules[static_cast<std::size_t>(id)]; }
    void noteReused(PassId pass) { reused[static_cast<std::size_t>(pass)] = true; }
    bool isReused(PassId pass) const { return reused[static_cast<std::size_t>(pass)]; }
    std::size_t triangles() const;
    /// The pass of a name, added where there is none.
    Pass& of(const std::string& name);
};

/// Values that no target may hold.
struct BadPixels {
    std::string pass; ///< the pass that made them
    std::size_t nan = 0, infinite = 0, negative = 0;
    bool any() const { return nan + infinite + negative > 0; }
};

} // namespace tarn
