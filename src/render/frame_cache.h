// What of a frame is kept from an earlier one: the picture, the targets and the maps, each with the key that it was
// drawn from (the rules keep_frame, keep_targets and keep_maps), and targets that are drawn in every n-th frame only
// (refraction.interval and the like).
//
// Questions are const; what a frame drew or used is noted by the other functions.
#pragma once

#include "optics/blocks.h"
#include "plan/frame_plan.h"
#include "render/frame.h"
#include "render/passes/sunlight.h"
#include "render/update_interval.h"

#include <cstdint>
#include <optional>
#include <utility>

namespace tarn {

/// The key that something was last drawn from.
template <typename Key> class CachedKey {
public:
    bool matches(const Key& key) const { return key_ && *key_ == key; }
    void set(Key key) { key_ = std::move(key); }
    /// Whatever comes next must be drawn.
    void forget() { key_.reset(); }

private:
    std::optional<Key> key_;
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
    blocks::FrameBlock light{}; ///< of the frame
    blocks::WavesBlock waves{}; ///< at the frame's time
    bool operator==(const CausticsKey& other) const;
};

/// What the refraction or the reflection target depends on beside the frame's key. Waves move neither.
struct TargetUse {
    Camera camera; ///< of the eye that is drawn
    WaterSide side = WaterSide::above;
    TargetBounds bounds;        ///< of what is drawn of it
    bool hasCaustics = false;   ///< the frame has them
    bool showsCaustics = false; ///< the target may show something that they light
};

class FrameCache {
public:
    /// Whether the last frame's picture is that of this key.
    bool holdsFrame(const FrameKey& key) const { return frame_.matches(key); }
    /// Begins a frame that is drawn.
    void beginFrame(const FrameKey& key);
    void endFrame();

    bool holdsCaustics(const CausticsKey& key) const;
    void causticsWereDrawn(const CausticsKey& key);

    /// @param pass refraction or reflection
    bool holdsTarget(PassId pass, const TargetUse& use) const;
    /// The target shows this now, whether it was drawn or held it.
    void targetShows(PassId pass, const TargetUse& use);

    /// Whether a pass that is drawn in every n-th frame only (update_interval.h) is not due, so that this frame may use
    /// what an earlier one drew, from where that was drawn. Refraction and reflection: not for two eyes, of which each
    /// would use the other's targets.
    bool mayReuse(PassId pass, const Camera& camera, WaterSide side) const;
    /// This frame does.
    void noteReuse(PassId pass, const Camera& camera, WaterSide side);

    /// What becomes of the targets is not known here.
    void forgetTargets();
    void forget();

private:
    struct TargetKey {
        FrameKey frame; ///< its time and sample 0, its view the final one
        WaterSide side = WaterSide::above;
        TargetBounds bounds;
        bool hasCaustics = false;
        std::size_t causticsDrawn = 0; ///< so far, where the target shows any
        bool operator==(const TargetKey&) const = default;
    };
    struct CausticsFrameKey {
        CausticsKey caustics;
        CausticsOptions options;
        SunlightOptions sunlight;
        std::size_t rebuilt = 0;
        bool operator==(const CausticsFrameKey&) const = default;
    };

    CausticsFrameKey keyOf(CausticsKey key) const;
    TargetKey keyOf(const TargetUse& use) const;
    UpdateInterval& intervalOf(PassId pass) { return intervals_[indexOf(pass)]; }
    const UpdateInterval& intervalOf(PassId pass) const { return intervals_[indexOf(pass)]; }
    static std::size_t indexOf(PassId pass);
    UpdateState stateFor(const Camera& camera, WaterSide side) const;

    FrameKey key_; ///< of this frame
    CachedKey<FrameKey> frame_;
    CachedKey<CausticsFrameKey> caustics_;
    CachedKey<TargetKey> refraction_, reflection_;
    std::size_t causticsDrawn_ = 0; ///< so far
    /// Of reflection, refraction and caustics. By how many frames each is drawn before the next, so that they take
    /// turns.
    std::array<UpdateInterval, 3> intervals_{UpdateInterval{0}, UpdateInterval{1}, UpdateInterval{2}};
    std::uint64_t drawnFrames_ = 0; ///< of these options
    bool isAnyStale_ = false;       ///< of what this frame uses
};

} // namespace tarn
