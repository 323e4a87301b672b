#include "plan/reduce.h"

#include "optics/optics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tarn {

float displayChange(FrameOptions::ToneCurve curve, float exposed)
{
    const auto displayed = [curve](float value) {
        const vec3 colour(value);
        switch (curve) {
        case FrameOptions::ToneCurve::linear: return optics::srgbFromLinear(optics::toneLinear(colour).x);
        case FrameOptions::ToneCurve::reinhard: return optics::srgbFromLinear(optics::toneReinhard(colour).x);
        case FrameOptions::ToneCurve::aces: break;
        }
        return optics::srgbFromLinear(optics::toneAces(colour).x);
    };
    float most = displayed(exposed);
    for (int i = 0; i < 64; ++i) { // from 1e-4 to 4, by 18 %: the slope changes less than twofold from one to the next
        const float base = 1.0e-4f * std::exp2(0.24f * static_cast<float>(i));
        most = std::max(most, displayed(base + exposed) - displayed(base));
    }
    return most;
}

PlanOptions planForRawValues(PlanOptions plan)
{
    for (std::size_t i = 0; i < ruleCount; ++i) {
        const auto id = static_cast<RuleId>(i);
        if (id != RuleId::cullChunks && id != RuleId::keepMaps && id != RuleId::keepFrame) plan.rules[i] = false;
    }
    return plan;
}

namespace {

/// What nobody sees: half of a step of the display, less a little for this sum's own rounding.
constexpr float invisible = 0.48f / 255.0f;

/// Of a target: what is left out beside it is not worth the rule.
constexpr float nearlyAll = 0.95f;

class Reduction {
public:
    Reduction(FramePlan& plan, const Scene& scene, const WaterBody& water, const Camera& camera, const Options& options,
              ivec2 size, const VisibilityFacts* visibility)
        : plan_(plan), scene_(scene), water_(water), camera_(camera), options_(options),
          aspect_(static_cast<float>(size.x) / static_cast<float>(size.y)), visibility_(visibility)
    {}

    void run()
    {
        decide(RuleId::cullChunks, "", "each pass draws what its own camera may see");
        decide(RuleId::waterOutOfView, whyWaterInView(), "no water in the view's frustum");
        if (applies(RuleId::waterOutOfView))
            drop({PassId::heights, PassId::refraction, PassId::reflection, PassId::water, PassId::glow},
                 "no water in the view's frustum");
        decide(RuleId::waterHidden, whyNotAskedForWater(),
               "hidden in the last frame: its passes run only if this frame's depth shows some of its slab");
        decide(RuleId::onlySkyMirrored, whyMirrors(), "the mirrored camera sees nothing but sky");
        if (applies(RuleId::onlySkyMirrored))
            drop({PassId::reflection}, "the water mirrors the sky alone: nothing else is in the mirrored frustum");
        decide(RuleId::noBed, whySeesBed(), "the refraction's camera sees nothing");
        if (applies(RuleId::noBed)) drop({PassId::refraction}, "nothing is under the water in its camera's frustum");
        decideDepth();
        decide(RuleId::nothingForCaustics, whyReceives(), "no camera sees anything under water");
        if (applies(RuleId::nothingForCaustics)) dropCaustics("nothing that is seen lies under water");
        decideGlow();
        decide(RuleId::cullHidden, "there is no earlier frame to tell what is hidden",
               ""); // until the renderer knows better
        decideBounds();
        for (const RuleId id : {RuleId::keepMaps, RuleId::keepTargets, RuleId::keepFrame})
            decide(id, "there is no earlier frame to keep anything of", "");
    }

private:
    bool applies(RuleId id) const { return plan_.rule(id).applies; }

    /// @param whyNot empty where the rule's condition holds
    void decide(RuleId id, const std::string& whyNot, const std::string& why)
    {
        RuleState& state = plan_.rule(id);
        if (!options_.plan.enabled)
            state = {false, "plan.enabled is off"};
        else if (!options_.plan.allows(id)) {
            const bool isOff = !options_.plan.rules[static_cast<std::size_t>(id)];
            state = {false, isOff ? fmt::format("plan.{} is off", tarn::rule(id).name) : "plan.exact refuses it"};
        } else
            state = {whyNot.empty(), whyNot.empty() ? why : whyNot};
    }

    void drop(std::initializer_list<PassId> passes, const std::string& reason)
    {
        for (const PassId pass : passes)
            if (plan_[pass].wanted) plan_[pass] = {false, reason, ivec2(0)};
        // The bed of an eye in the air is seen through its surface only.
        const bool drawsWater = plan_[PassId::water].wanted;
        if (!drawsWater) plan_.raycastsBed = plan_.raycastsMirror = false;
        if (!drawsWater && plan_.side == WaterSide::above && (!visibility_ || !visibility_->mainReceives))
            dropCaustics(reason);
    }

    void dropCaustics(const std::string& reason)
    {
        PassPlan& caustics = plan_[PassId::caustics];
        if (!caustics.wanted) return;
        caustics = {false, reason, ivec2(0)};
        if (!options_.sunlight.shadows)
            plan_[PassId::sunlight] = {false, "sunlight.shadows is off, and no caustics need the bed's depth",
                                       ivec2(0)};
    }

    bool isFromAbove() const { return plan_.side == WaterSide::above; }

    std::string whyWaterInView() const
    {
        if (!plan_[PassId::water].wanted) return "no water is drawn";
        const Frustum frustum(clipFromView(camera_, aspect_) * viewFromWorld(camera_));
        return frustum.intersects(waterBounds(water_)) ? "the water's slab is in the view's frustum" : "";
    }

    std::string whyNotAskedForWater() const
    {
        if (!plan_[PassId::water].wanted) return "no water is drawn";
        if (!isFromAbove()) return "the eye is not above the water";
        if (options_.stereo.isOn()) return "there are two eyes";
        if (camera_.eye.y <= waterBounds(water_).upper.y + camera_.nearPlane)
            return "the eye may be within the slab that the surface moves in";
        if (!visibility_ || !visibility_->waterWasHidden) return "the water was not hidden in the last frame";
        return "";
    }

    std::string whyMirrors() const
    {
        if (!plan_[PassId::reflection].wanted) return "there is no reflection target";
        if (!isFromAbove()) return "the surface is seen from below";
        if (!visibility_) return "what is in view is not known";
        if (options_.reflection.method == ReflectionOptions::Method::distance)
            return "reflection.method = distance takes the sky from beside the ray";
        if (scene_.sky.kind == Sky::Kind::picture) return "the sky is a picture, whose changes have no bound";
        return visibility_->mirrors ? "the mirrored camera may see something" : "";
    }

    std::string whySeesBed() const
    {
        if (!plan_[PassId::refraction].wanted) return "there is no refraction target";
        if (!isFromAbove()) return "the surface is seen from below";
        if (!visibility_) return "what is in view is not known";
        return visibility_->seesBed ? "the refraction's camera may see something" : "";
    }

    /// What the bed adds to the display at most.
    float bedVisibility() const
    {
        constexpr float gathering = 16.0f; // of light by waves (Rule::bound)
        const float depth = std::max(visibility_->leastDepth - totalAmplitude(water_), 0.0f);
        const vec3 down = optics::beerLambert(water_.absorption, depth);
        const vec3 light = gathering * visibility_->sunBelow * down + visibility_->skyBelow * down;
        const vec3 bed = visibility_->bedReflectance * light + visibility_->bedEmission;
        const vec3 up = options_.water.attenuation == WaterOptions::Attenuation::linear
                            ? vec3(optics::linearAttenuation(depth, options_.water.attenuationLength))
                            : down;
        const vec3 change =
            up * glm::max(bed, visibility_->deepRadiance) * optics::radianceThroughSurface(1.0f, water_.ior);
        return displayChange(options_.frame.toneCurve,
                             options_.frame.exposure * std::max({change.x, change.y, change.z}));
    }

    void decideDepth()
    {
        std::string whyNot = whySeesBed();
        if (plan_[PassId::refraction].wanted && isFromAbove() && visibility_) {
            if (!visibility_->seesBed)
                whyNot = "its camera sees nothing";
            else if (visibility_->leastDepth <= 0.0f)
                whyNot = "its camera may see what is not under water";
            else if (!scene_.pointLights.empty() || !scene_.spotLights.empty())
                whyNot = "lamps may light the bed without bound";
            else if (const float visible = bedVisibility(); visible > invisible)
                whyNot = fmt::format("the nearest bed, {:.2f} m deep, may be worth {:.3g}/255", visibility_->leastDepth,
                                     255.0f * visible);
            else
                whyNot.clear();
        }
        decide(RuleId::bedTooDeep, whyNot, "no light of the bed is left that could be seen");
        if (applies(RuleId::bedTooDeep))
            drop({PassId::refraction},
                 fmt::format("the bed, {:.2f} m deep and more, is not to be seen", visibility_->leastDepth));
    }

    std::string whyReceives() const
    {
        if (!plan_[PassId::caustics].wanted) return "there are no caustics";
        if (!visibility_) return "what is in view is not known";
        if (plan_.raycastsBed) return "rays find the bed in its map";
        if (visibility_->mainReceives) return "the eye may see something under water";
        if (plan_[PassId::refraction].wanted && visibility_->refractionReceives)
            return "the refraction's camera may see something under water";
        if (plan_[PassId::reflection].wanted && visibility_->reflectionReceives)
            return "the mirrored camera may see something under water";
        return plan_.raycastsMirror ? "the map of what stands over the water may hold it" : "";
    }

    /// The largest value of the glow's highlight in the view. A facet of slope s turns the mirrored sun by 2 atan s at
    /// most from where still water would mirror it.
    float largestHighlight() const
    {
        float slope = 0.0f;
        for (const Wave& wave : water_.waves) slope += std::abs(wave.amplitude) * 2.0f * pi / wave.wavelength;
        const vec3 toSun = scene_.sun->direction;
        const vec3 lobe(toSun.x, -toSun.y, toSun.z); // the view's ray that still water sends to the sun
        const ViewTangents tangents(clipFromView(camera_, aspect_));
        const vec2 corner = tangents.half + glm::abs(tangents.middle);
        const vec3 forward = glm::normalize(camera_.target - camera_.eye);
        const float between = std::acos(std::clamp(glm::dot(forward, lobe), -1.0f, 1.0f)) -
                              std::atan(glm::length(corner)) - 2.0f * std::atan(slope);
        if (between <= 0.0f) return 1.0f;
        return std::pow(std::max(std::cos(std::min(between, pi)), 1.0e-6f), options_.glow.exponent);
    }

    void decideGlow()
    {
        std::string whyNot;
        if (!plan_[PassId::glow].wanted)
            whyNot = "there is no glow";
        else if (water_.normalMap.isSeen())
            whyNot = "the slopes of the water's normal map have no bound";
        else {
            const vec3 colour = options_.glow.strength * options_.glow.colour;
            const float most = largestHighlight() * std::max({colour.x, colour.y, colour.z});
            if (displayChange(options_.frame.toneCurve, most) > invisible)
                whyNot = "waves may mirror the sun's lobe into the view";
        }
        decide(RuleId::glowOutOfView, whyNot, "no wave is steep enough to mirror the sun's lobe into the view");
        if (applies(RuleId::glowOutOfView))
            drop({PassId::glow}, "no wave is steep enough to mirror the sun's lobe into the view");
    }

    void decideBounds()
    {
        TargetBounds bounds;
        std::string whyNot;
        if (!plan_[PassId::reflection].wanted)
            whyNot = "there is no reflection target";
        else if (!isFromAbove())
            whyNot = "the surface is seen from below";
        else if (bounds = mirrorBounds(water_, camera_, options_, plan_[PassId::water].size);
                 bounds.fraction() > nearlyAll)
            whyNot = "the water may look up all of the reflection target";
        decide(RuleId::targetBounds, whyNot,
               fmt::format("the water looks up {:.0f} % of the reflection target at most", 100.0f * bounds.fraction()));
        if (applies(RuleId::targetBounds)) plan_.mirrorBounds = bounds;
    }

    FramePlan& plan_;
    const Scene& scene_;
    const WaterBody& water_;
    const Camera& camera_;
    const Options& options_;
    const float aspect_;
    const VisibilityFacts* visibility_;
};

} // namespace

void reducePlan(FramePlan& plan, const Scene& scene, const WaterBody& water, const Camera& camera,
                const Options& options, ivec2 size, const VisibilityFacts* visibility)
{
    Reduction(plan, scene, water, camera, options, size, visibility).run();
}

} // namespace tarn
