#include "render/kept.h"

#include "render/frame_light.h"

#include <cstring>
#include <utility>

namespace tarn {

Moment momentOf(const FrameInput& input, const Options& options, const WaterBody& water, std::size_t rebuilt)
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

bool Kept::beginFrame(const Moment& moment, const PlanOptions& rules, bool mayKeepFrame)
{
    moment_ = moment;
    rules_ = rules;
    noted_.clear();
    return mayKeepFrame && rules.allows(RuleId::keepFrame) && frame_.isFrom(moment);
}

bool Kept::keeps(RuleId rule, PassId pass, bool holds)
{
    if (!holds || !rules_.allows(rule)) return false;
    noted_ += (noted_.empty() ? "" : ", ") + std::string(passName(pass));
    return true;
}

bool Kept::caustics(CausticsKey key)
{
    key.light = lastingLight(key.light);
    if (totalAmplitude(moment_.water) == 0.0f) key.waves = {};
    return keeps(RuleId::keepMaps, PassId::caustics,
                 caustics_.holds({key, moment_.options.caustics, moment_.options.sunlight, moment_.rebuilt}));
}

bool Kept::target(PassId pass, const Camera& camera, WaterSide side, const TargetBounds& bounds, bool hasCaustics,
                  bool showsCaustics)
{
    TargetKey key{moment_, side, bounds, hasCaustics, hasCaustics && showsCaustics ? causticsDrawn_ : 0};
    key.moment.camera = camera;
    key.moment.time = 0.0;
    key.moment.sample = 0;
    key.moment.view = DebugView::final;
    LastDrawn<TargetKey>& last = pass == PassId::refraction ? refraction_ : reflection_;
    return keeps(RuleId::keepTargets, pass, last.holds(key));
}

void Kept::tell(FramePlan& plan, RuleId rule)
{
    const std::string noted = std::exchange(noted_, "");
    if (!rules_.allows(rule)) return; // the plan says so
    plan.rule(rule) = noted.empty() ? RuleState{false, "nothing is as an earlier frame left it"}
                                    : RuleState{true, "as an earlier frame left it: " + noted};
}

void Kept::forgetTargets()
{
    refraction_.forget();
    reflection_.forget();
}

void Kept::forget()
{
    forgetTargets();
    frame_.forget();
    caustics_.forget();
}

} // namespace tarn
