#include "render/water_targets.h"

#include <fmt/format.h>

namespace tarn {

void WaterTargets::begin(const Inputs& inputs, const FramePlan& plan)
{
    firstViews_ = viewsFor(inputs, plan.side == WaterSide::below);
    firstViews_.reflection.lookedUp = plan.mirrorBounds;
    if (plan.side == WaterSide::crossing) belowViews_ = viewsFor(inputs, true);
}

WaterTargets::Views WaterTargets::viewsFor(const Inputs& inputs, bool underwater) const
{
    const Options& options = inputs.options;
    const auto placed = [&](View view, int targetSize) {
        view.geometryError = geometryErrorOf(view, ivec2(targetSize), options.detail.pixels);
        return view;
    };
    return {placed(refractionView(inputs.camera, inputs.aspect, inputs.water, options, underwater),
                   options.refraction.targetSize),
            placed(reflectionView(inputs.camera, inputs.aspect, inputs.water, options.reflection, underwater),
                   options.reflection.targetSize)};
}

void WaterTargets::draw(const Inputs& inputs, const VisibilityFacts& visibility, FrameContext& context)
{
    const FramePlan& plan = context.plan();
    const auto keeps = [&](PassId pass, const View& view, bool receives) {
        const bool showsCaustics = plan.side != WaterSide::above || receives;
        return context.cache.target(pass, inputs.camera, plan.side, view.lookedUp, inputs.lit.caustics, showsCaustics);
    };
    const auto isUsedAgain = [&](PassId pass) {
        if (!plan[pass].wanted || !context.cache.isUsedAgain(pass, inputs.camera, plan.side)) return false;
        context.stats.plan[pass].reason += fmt::format(" ({}.interval: an earlier frame's)", passName(pass));
        return true;
    };
    if (!isUsedAgain(PassId::refraction)) {
        first_.refractionView = firstViews_.refraction;
        below_.refractionView = belowViews_.refraction;
        if (plan[PassId::refraction].wanted &&
            !keeps(PassId::refraction, first_.refractionView, visibility.refractionReceives))
            drawRefraction(inputs, context);
    }
    if (!isUsedAgain(PassId::reflection)) {
        first_.reflectionView = firstViews_.reflection;
        below_.reflectionView = belowViews_.reflection;
        if (plan[PassId::reflection].wanted &&
            !keeps(PassId::reflection, first_.reflectionView, visibility.reflectionReceives))
            drawReflection(inputs, context);
    }
    context.cache.tell(context.stats.plan, RuleId::keepTargets);
}

void WaterTargets::drawRefraction(const Inputs& frame, FrameContext& context)
{
    gl::PassScope scope(context.profiler, passName(PassId::refraction));
    const FramePlan& plan = context.plan();
    const auto draw = [&](Side& side, bool underwater) {
        FrameStats::Pass& pass =
            context.beginPass(PassId::refraction, side.refractionView, plan[PassId::refraction].size);
        const RefractionPass::Inputs inputs{.view = side.refractionView,
                                            .underwater = underwater,
                                            .deepRadiance = frame.deepRadiance,
                                            .cull = frame.options.plan.allows(RuleId::cullChunks),
                                            .variant = frame.lit};
        context.check(PassId::refraction,
                      side.refraction.draw(context.sceneRenderer, frame.options.refraction, inputs, pass));
    };
    if (plan.targetsBed) draw(first_, plan.side == WaterSide::below);
    if (plan.side == WaterSide::crossing) draw(below_, true);
}

void WaterTargets::drawReflection(const Inputs& frame, FrameContext& context)
{
    gl::PassScope scope(context.profiler, passName(PassId::reflection));
    const FramePlan& plan = context.plan();
    const auto draw = [&](Side& side, bool underwater) {
        FrameStats::Pass& pass =
            context.beginPass(PassId::reflection, side.reflectionView, plan[PassId::reflection].size);
        const ReflectionPass::Inputs inputs{.view = side.reflectionView,
                                            .underwater = underwater,
                                            .cull = frame.options.plan.allows(RuleId::cullChunks),
                                            .variant = frame.lit};
        context.check(PassId::reflection,
                      side.reflection.draw(context.sceneRenderer, frame.options.reflection, inputs, pass));
    };
    if (plan.targetsMirror) draw(first_, plan.side == WaterSide::below);
    if (plan.side == WaterSide::crossing) draw(below_, true);
}

} // namespace tarn
