// What pictures and targets were drawn from, so that they are kept while it stays as it is.
#pragma once

#include "optics/blocks.h"
#include "plan/frame_plan.h"
#include "plan/options.h"
#include "render/debug_view.h"
#include "render/passes/sunlight.h"
#include "scene/scene.h"

#include <cstring>
#include <optional>

namespace tarn {

/// Remembers the key that a target was last drawn from.
template <typename Key> class LastDrawn {
public:
    /// True when the target holds what this key makes: it need not be drawn. Else it must be, now.
    bool holds(const Key& key)
    {
        if (isFrom(key)) return true;
        last_ = key;
        return false;
    }
    bool isFrom(const Key& key) const { return last_ && *last_ == key; }
    /// Whatever comes next must be drawn.
    void forget() { last_.reset(); }

private:
    std::optional<Key> last_;
};

/// All that a picture depends on beside the scene.
struct Moment {
    Options options;
    WaterBody water;
    Camera camera;
    double time = 0.0; ///< s; 0 while nothing moves
    ivec2 size{0};
    DebugView view = DebugView::final;
    std::size_t rebuilt = 0; ///< programs, because their files were edited
    bool operator==(const Moment&) const = default;
};

/// What the refraction and the reflection target depend on beside the scene: waves move neither.
struct TargetKey {
    Moment moment; ///< its time 0, its view the final one
    WaterSide side = WaterSide::above;
    bool caustics = false;
    std::size_t causticsDrawn = 0; ///< so far, where the target shows any
    bool operator==(const TargetKey&) const = default;
};

/// What the caustics depend on beside the scene.
struct CausticsKey {
    SunlightPass::Inputs sun;
    CausticsRegion region;
    blocks::FrameBlock light;  ///< lastingLight
    blocks::WavesBlock waves;  ///< of the moment; zero while they are still
    CausticsOptions caustics;
    SunlightOptions sunlight;
    std::size_t rebuilt = 0;
    bool operator==(const CausticsKey& other) const
    {
        return sun == other.sun && region == other.region && caustics == other.caustics && sunlight == other.sunlight &&
               rebuilt == other.rebuilt && std::memcmp(&light, &other.light, sizeof light) == 0 &&
               std::memcmp(&waves, &other.waves, sizeof waves) == 0; // floats, whose padding has names and is zero
    }
};

/// Whether nothing of the water moves with time.
inline bool isStill(const WaterBody& water) { return totalAmplitude(water) == 0.0f && !water.normalMap.isSeen(); }

} // namespace tarn
