#include "render/water_targets.h"

namespace tarn {

void WaterTargets::begin(const EyeFrame& eye)
{
    firstViews_ = viewsFor(eye, eye.isBelow());
    firstViews_.reflection.lookedUp = eye.plan.mirrorBounds;
    if (eye.isCrossing()) belowViews_ = viewsFor(eye, true);
}

WaterTargets::Views WaterTargets::viewsFor(const EyeFrame& eye, bool underwater) const
{
    const Options& options = eye.options;
    const Camera& camera = eye.input.camera;
    const auto detailed = [&](View view, int targetSize) {
        view.geometryError = geometryErrorOf(view, ivec2(targetSize), options.detail.pixels);
        return view;
    };
    return {detailed(refractionView(camera, eye.aspect, eye.water, options, underwater), options.refraction.targetSize),
            detailed(reflectionView(camera, eye.aspect, eye.water, options.reflection, underwater),
                     options.reflection.targetSize)};
}

void WaterTargets::draw(const EyeFrame& eye, const SceneVariant& lit, FrameContext& context)
{
    const Camera& camera = eye.input.camera;
    const WaterSide side = eye.plan.side;
    const auto isReused = [&](PassId pass) {
        if (!eye.plan[pass].wanted || !context.cache.mayReuse(pass, camera, side)) return false;
        context.cache.noteReuse(pass, camera, side);
        context.report.noteReused(pass);
        return true;
    };
    // Whether the target is as this frame needs it; it is from now on.
    const auto isKept = [&](PassId pass, const View& view, bool receives) {
        const bool showsCaustics = side != WaterSide::above || receives;
        const TargetUse use{camera, side, view.lookedUp, lit.caustics, showsCaustics};
        const bool keeps = eye.options.plan.allows(RuleId::keepTargets) && context.cache.holdsTarget(pass, use);
        context.cache.targetShows(pass, use);
        if (keeps) context.noteKept(pass);
        return keeps;
    };
    if (!isReused(PassId::refraction)) {
        first_.refractionView = firstViews_.refraction;
        below_.refractionView = belowViews_.refraction;
        if (eye.plan[PassId::refraction].wanted &&
            !isKept(PassId::refraction, first_.refractionView, eye.visibility.refractionReceives))
            drawRefraction(eye, lit, context);
    }
    if (!isReused(PassId::reflection)) {
        first_.reflectionView = firstViews_.reflection;
        below_.reflectionView = belowViews_.reflection;
        if (eye.plan[PassId::reflection].wanted &&
            !isKept(PassId::reflection, first_.reflectionView, eye.visibility.reflectionReceives))
            drawReflection(eye, lit, context);
    }
    context.reportKept(RuleId::keepTargets, eye.options.plan);
}

void WaterTargets::drawRefraction(const EyeFrame& eye, const SceneVariant& lit, FrameContext& context)
{
    gl::PassScope scope(context.profiler, passName(PassId::refraction));
    const FramePlan& plan = eye.plan;
    const auto draw = [&](Side& side, bool underwater) {
        FrameReport::Pass& pass =
            context.beginPass(PassId::refraction, side.refractionView, plan[PassId::refraction].size);
        const RefractionPass::Inputs inputs{.view = side.refractionView,
                                            .underwater = underwater,
                                            .deepRadiance = eye.light.deepRadiance,
                                            .cull = eye.options.plan.allows(RuleId::cullChunks),
                                            .variant = lit};
        context.check(PassId::refraction,
                      side.refraction.draw(context.sceneRenderer, eye.options.refraction, inputs, pass));
    };
    if (plan.targetsBed) draw(first_, eye.isBelow());
    if (eye.isCrossing()) draw(below_, true);
}

void WaterTargets::drawReflection(const EyeFrame& eye, const SceneVariant& lit, FrameContext& context)
{
    gl::PassScope scope(context.profiler, passName(PassId::reflection));
    const FramePlan& plan = eye.plan;
    const auto draw = [&](Side& side, bool underwater) {
        FrameReport::Pass& pass =
            context.beginPass(PassId::reflection, side.reflectionView, plan[PassId::reflection].size);
        const ReflectionPass::Inputs inputs{.view = side.reflectionView,
                                            .underwater = underwater,
                                            .cull = eye.options.plan.allows(RuleId::cullChunks),
                                            .variant = lit};
        context.check(PassId::reflection,
                      side.reflection.draw(context.sceneRenderer, eye.options.reflection, inputs, pass));
    };
    if (plan.targetsMirror) draw(first_, eye.isBelow());
    if (eye.isCrossing()) draw(below_, true);
}

} // namespace tarn
