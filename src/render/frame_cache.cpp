#include "render/frame_cache.h"

#include "render/frame_light.h"

#include <cstring>
#include <utility>

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

bool FrameCache::beginFrame(const FrameKey& moment, const PlanOptions& rules, bool mayKeepFrame)
{
    const bool isSequel =
        moment.options == moment_.options && moment.water == moment_.water && moment.size == moment_.size;
    if (!isSequel) {
        drawnFrames_ = 0;
        for (UpdateInterval* interval : {&causticsInterval_, &refractionInterval_, &reflectionInterval_})
            interval->forget();
    }
    moment_ = moment;
    rules_ = rules;
    noted_.clear();
    isAnyStale_ = false;
    if (mayKeepFrame && rules.allows(RuleId::keepFrame) && frame_.isFrom(moment)) return true;
    ++drawnFrames_;
    return false;
}

void FrameCache::endFrame()
{
    frame_.holds(moment_);
    if (isAnyStale_) frame_.forget(); // a picture that comes to rest is drawn until all of it is of its moment
}

UpdateInterval& FrameCache::intervalOf(PassId pass)
{
    return pass == PassId::caustics     ? causticsInterval_
           : pass == PassId::refraction ? refractionInterval_
                                        : reflectionInterval_;
}

UpdateState FrameCache::stateFor(const Camera& camera, WaterSide side) const
{
    return {moment_.options, moment_.water, camera, moment_.time, moment_.size, moment_.rebuilt, side, causticsDrawn_};
}

bool FrameCache::isUsedAgain(PassId pass, const Camera& camera, WaterSide side)
{
    const Options& options = moment_.options;
    const int interval = pass == PassId::caustics     ? options.caustics.interval
                         : pass == PassId::refraction ? options.refraction.interval
                                                      : options.reflection.interval;
    if (interval == 1 || !rules_.enabled || (pass != PassId::caustics && options.stereo.isOn())) return false;
    const UpdateState now = stateFor(camera, side);
    const bool isUsed = intervalOf(pass).serves(now, drawnFrames_, interval);
    isAnyStale_ = isAnyStale_ || (isUsed && intervalOf(pass).isStale(now));
    return isUsed;
}

bool FrameCache::keeps(RuleId rule, PassId pass, bool holds)
{
    if (!holds || !rules_.allows(rule)) return false;
    noted_ += (noted_.empty() ? "" : ", ") + std::string(passName(pass));
    return true;
}

bool FrameCache::caustics(CausticsKey key)
{
    key.light = lastingLight(key.light);
    if (totalAmplitude(moment_.water) == 0.0f) key.waves = {};
    return keeps(RuleId::keepMaps, PassId::caustics,
                 caustics_.holds({key, moment_.options.caustics, moment_.options.sunlight, moment_.rebuilt}));
}

void FrameCache::causticsWereDrawn()
{
    ++causticsDrawn_;
    causticsInterval_.wasDrawn(stateFor(moment_.camera, WaterSide::above), drawnFrames_);
}

bool FrameCache::target(PassId pass, const Camera& camera, WaterSide side, const TargetBounds& bounds, bool hasCaustics,
                        bool showsCaustics)
{
    TargetKey key{moment_, side, bounds, hasCaustics, hasCaustics && showsCaustics ? causticsDrawn_ : 0};
    key.moment.camera = camera;
    key.moment.time = 0.0;
    key.moment.sample = 0;
    key.moment.view = DebugView::final;
    CachedKey<TargetKey>& last = pass == PassId::refraction ? refraction_ : reflection_;
    // Cached or drawn: it is what this frame needs.
    intervalOf(pass).wasDrawn(stateFor(camera, side), drawnFrames_);
    return keeps(RuleId::keepTargets, pass, last.holds(key));
}

void FrameCache::tell(FramePlan& plan, RuleId rule)
{
    const std::string noted = std::exchange(noted_, "");
    if (!rules_.allows(rule)) return; // the plan says so
    plan.rule(rule) = noted.empty() ? RuleState{false, "nothing is as an earlier frame left it"}
                                    : RuleState{true, "as an earlier frame left it: " + noted};
}

void FrameCache::forgetTargets()
{
    refraction_.forget();
    reflection_.forget();
    refractionInterval_.forget();
    reflectionInterval_.forget();
}

void FrameCache::forget()
{
    forgetTargets();
    frame_.forget();
    caustics_.forget();
    causticsInterval_.forget();
}

} // namespace tarn
