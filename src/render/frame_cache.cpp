#include "render/frame_cache.h"

#include "render/frame_light.h"

#include <cstring>

namespace tarn {

FrameKey frameKeyOf(const FrameInput& input, const Options& options, const WaterBody& water, std::size_t rebuilt)
{
    const bool isStill = totalAmplitude(water) == 0.0f && !water.normalMap.isSeen();
    return {options, water, input.camera, isStill ? 0.0 : input.time, input.size, input.view, rebuilt, input.sample};
}

bool CausticsKey::operator==(const CausticsKey& other) const
{
    // Floats, whose padding has names and is zero.
    return sun == other.sun && region == other.region && sameLight(light, other.light) &&
           std::memcmp(&waves, &other.waves, sizeof waves) == 0;
}

void FrameCache::beginFrame(const FrameKey& key)
{
    const bool isSequel = key.options == key_.options && key.water == key_.water && key.size == key_.size;
    if (!isSequel) {
        drawnFrames_ = 0;
        for (UpdateInterval& interval : intervals_) interval.forget();
    }
    key_ = key;
    isAnyStale_ = false;
    ++drawnFrames_;
}

void FrameCache::endFrame()
{
    if (isAnyStale_) // a picture that comes to rest is drawn until all of it is of its own time and camera
        frame_.forget();
    else
        frame_.set(key_);
}

std::size_t FrameCache::indexOf(PassId pass)
{
    return pass == PassId::caustics ? 2 : pass == PassId::refraction ? 1 : 0;
}

UpdateState FrameCache::stateFor(const Camera& camera, WaterSide side) const
{
    return {key_.options, key_.water, camera, key_.time, key_.size, key_.rebuilt, side, causticsDrawn_};
}

bool FrameCache::mayReuse(PassId pass, const Camera& camera, WaterSide side) const
{
    const Options& options = key_.options;
    const int interval = pass == PassId::caustics     ? options.caustics.interval
                         : pass == PassId::refraction ? options.refraction.interval
                                                      : options.reflection.interval;
    if (interval == 1 || !options.plan.enabled || (pass != PassId::caustics && options.stereo.isOn())) return false;
    return intervalOf(pass).serves(stateFor(camera, side), drawnFrames_, interval);
}

void FrameCache::noteReuse(PassId pass, const Camera& camera, WaterSide side)
{
    isAnyStale_ = isAnyStale_ || intervalOf(pass).isStale(stateFor(camera, side));
}

FrameCache::CausticsFrameKey FrameCache::keyOf(CausticsKey key) const
{
    key.light = lastingLight(key.light);
    if (totalAmplitude(key_.water) == 0.0f) key.waves = {};
    return {std::move(key), key_.options.caustics, key_.options.sunlight, key_.rebuilt};
}

bool FrameCache::holdsCaustics(const CausticsKey& key) const { return caustics_.matches(keyOf(key)); }

void FrameCache::causticsWereDrawn(const CausticsKey& key)
{
    caustics_.set(keyOf(key));
    ++causticsDrawn_;
    intervalOf(PassId::caustics).wasDrawn(stateFor(key_.camera, WaterSide::above), drawnFrames_);
}

FrameCache::TargetKey FrameCache::keyOf(const TargetUse& use) const
{
    TargetKey key{key_, use.side, use.bounds, use.hasCaustics,
                  use.hasCaustics && use.showsCaustics ? causticsDrawn_ : 0};
    key.frame.camera = use.camera;
    key.frame.time = 0.0;
    key.frame.sample = 0;
    key.frame.view = DebugView::final;
    return key;
}

bool FrameCache::holdsTarget(PassId pass, const TargetUse& use) const
{
    return (pass == PassId::refraction ? refraction_ : reflection_).matches(keyOf(use));
}

void FrameCache::targetShows(PassId pass, const TargetUse& use)
{
    (pass == PassId::refraction ? refraction_ : reflection_).set(keyOf(use));
    intervalOf(pass).wasDrawn(stateFor(use.camera, use.side), drawnFrames_);
}

void FrameCache::forgetTargets()
{
    refraction_.forget();
    reflection_.forget();
    intervalOf(PassId::refraction).forget();
    intervalOf(PassId::reflection).forget();
}

void FrameCache::forget()
{
    forgetTargets();
    frame_.forget();
    caustics_.forget();
    intervalOf(PassId::caustics).forget();
}

} // namespace tarn
