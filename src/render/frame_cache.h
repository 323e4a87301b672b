// What of a frame is kept from an earlier one: the picture, the targets and the maps, while what they were drawn from
// stays as it is (the rules keep_frame, keep_targets and keep_maps).
#pragma once

#include "optics/blocks.h"
#include "plan/frame_plan.h"
#include "render/frame.h"
#include "render/passes/sunlight.h"
#include "render/update_interval.h"

#include <cstdint>
#include <optional>
#include <string>

namespace tarn {

/// Remembers the key that something was last drawn from.
template <typename Key> class CachedKey {
public:
    bool isFrom(const Key& key) const { return last_ && *last_ == key; }
    /// True when it holds what this key makes; else it must be drawn, now.
    bool holds(const Key& key)
    {
        if (isFrom(key)) return true;
        last_ = key;
        return false;
    }
    /// Whatever comes next must be drawn.
    void forget() { last_.reset(); }

private:
    std::optional<Key> last_;
};

/// All that a picture depends on beside the scene.
struct FrameKey {
    Options options;
    WaterBody water;
    Camera camera;
    double time = 0.0; ///< s; 0 while nothing moves
    ivec2 size{0};
    DebugView view = DebugView::final;
    std::size_t rebuilt = 0; ///< programs, because their files were edited
    int sample = 0;          ///< of those that are averaged
    bool operator==(const FrameKey&) const = default;
};

/// @param rebuilt gl::ShaderLibrary::rebuilt()
FrameKey frameKeyOf(const FrameInput& input, const Options& options, const WaterBody& water, std::size_t rebuilt);

/// What the caustics depend on beside the scene and the options.
struct CausticsKey {
    SunlightPass::Inputs sun;
    CausticsRegion region;
    blocks::FrameBlock light; ///< of the frame
    blocks::WavesBlock waves; ///< of the moment
    bool operator==(const CausticsKey& other) const;
};

class FrameCache {
public:
    /// True when the picture of the last frame is this one's. Else it, and endFrame() after it, must be drawn.
    bool beginFrame(const FrameKey& moment, const PlanOptions& rules, bool mayKeepFrame);
    void endFrame();

    /// Whether the pass's map may stay; it is noted. @param holds what this frame needs
    bool map(PassId pass, bool holds) { return keeps(RuleId::keepMaps, pass, holds); }
    bool caustics(CausticsKey key);
    void causticsWereDrawn();

    /// Whether a pass that is drawn in every n-th frame only (update_interval.h) is not due, so that this frame looks
    /// up what an earlier one drew, from where that was drawn. refraction, reflection: not for two eyes, whose targets
    /// are the other's
    bool isUsedAgain(PassId pass, const Camera& camera, WaterSide side);
    bool areCausticsUsedAgain() { return isUsedAgain(PassId::caustics, moment_.camera, WaterSide::above); }

    /// Whether the refraction or the reflection target may stay; it is noted. Waves move neither.
    /// @param camera of the eye that is drawn   @param bounds of what is drawn
    /// @param showsCaustics it may hold something that they light
    bool target(PassId pass, const Camera& camera, WaterSide side, const TargetBounds& bounds, bool hasCaustics,
                bool showsCaustics);

    /// Tells the plan what was noted since the last time.
    void tell(FramePlan& plan, RuleId rule);

    /// What becomes of the targets is not known here.
    void forgetTargets();
    void forget();

private:
    struct TargetKey {
        FrameKey moment; ///< its time and sample 0, its view the final one
        WaterSide side = WaterSide::above;
        TargetBounds bounds;
        bool hasCaustics = false;
        std::size_t causticsDrawn = 0; ///< so far, where the target shows any
        bool operator==(const TargetKey&) const = default;
    };
    struct MapKey {
        CausticsKey caustics;
        CausticsOptions options;
        SunlightOptions sunlight;
        std::size_t rebuilt = 0;
        bool operator==(const MapKey&) const = default;
    };

    bool keeps(RuleId rule, PassId pass, bool holds);
    UpdateInterval& intervalOf(PassId pass);
    UpdateState stateFor(const Camera& camera, WaterSide side) const;

    FrameKey moment_; ///< of this frame
    PlanOptions rules_;
    CachedKey<FrameKey> frame_;
    CachedKey<MapKey> caustics_;
    CachedKey<TargetKey> refraction_, reflection_;
    std::size_t causticsDrawn_ = 0; ///< so far
    std::string noted_;
    // By how many frames each is drawn before the next, so that they take turns.
    UpdateInterval causticsInterval_{2}, refractionInterval_{1}, reflectionInterval_{0};
    std::uint64_t drawnFrames_ = 0; ///< of these options
    bool isAnyStale_ = false;       ///< of what this frame looks up
};

} // namespace tarn
