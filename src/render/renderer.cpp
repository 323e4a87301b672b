#include "render/renderer.h"

#include "base/error.h"
#include "base/files.h"
#include "base/log.h"
#include "gl/workarounds.h"
#include "plan/reduce.h"
#include "render/bed_detail.h"
#include "render/bindings.h"
#include "render/frame_light.h"
#include "render/height_maps.h"
#include "render/kept.h"
#include "render/look_around.h"
#include "render/passes/caustics.h"
#include "render/passes/debug_copy.h"
#include "render/passes/downsample.h"
#include "render/passes/glow.h"
#include "render/passes/hidden_water.h"
#include "render/passes/present.h"
#include "render/passes/reflection.h"
#include "render/passes/refraction.h"
#include "render/passes/scene_pass.h"
#include "render/passes/stereo.h"
#include "render/passes/sunlight.h"
#include "render/passes/water.h"
#include "render/passes/waterline.h"
#include "render/pixel_check.h"
#include "render/read_back.h"
#include "render/sun_views.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace tarn {

namespace {

template <typename Block> gl::UniformBuffer<Block> uniformBuffer(BlockIndex index, const char* label)
{
    return gl::UniformBuffer<Block>(static_cast<int>(index), label);
}

/// Debug views that show values of single pixels: no samples to mix, and floats wide enough for positions.
bool wantsRawValues(DebugView view) { return view != DebugView::final; }

/// The anisotropy of the scene's textures: the option's, where the driver can bear it.
float anisotropyFor(const FrameOptions& options)
{
    return gl::avoidsAnisotropy() ? 1.0f : options.anisotropy;
}

/// Debug views that the water pass writes; the scene around them stays empty.
bool isWaterView(DebugView view)
{
    switch (view) {
    case DebugView::fresnel:
    case DebugView::pathLength:
    case DebugView::positionU:
    case DebugView::positionW:
    case DebugView::positionA:
    case DebugView::reflectionHit: return true;
    default: return false;
    }
}

} // namespace

std::size_t FrameStats::triangles() const
{
    std::size_t sum = 0;
    for (const Pass& pass : passes) sum += pass.triangles;
    return sum;
}

FrameStats::Pass& FrameStats::of(const std::string& name)
{
    for (Pass& pass : passes)
        if (pass.name == name) return pass;
    return passes.emplace_back(Pass{name, 0, 0});
}

std::unique_ptr<gl::ShaderLibrary> makeShaderLibrary()
{
    return std::make_unique<gl::ShaderLibrary>(projectRoot() / "shaders", shaderBindings());
}

namespace {

/// Whether a frame runs a pass that the one before did not, or may not have.
bool wantsMore(const FramePlan& plan, const FramePlan& before)
{
    if (before.rule(RuleId::waterHidden).applies) return true;
    for (std::size_t i = 0; i < passCount; ++i)
        if (plan.passes[i].wanted && !before.passes[i].wanted) return true;
    return plan.mirrorBounds != before.mirrorBounds;
}

/// Foliage by chance of its share of a pixel is right in the mean of several pixels, and noise where one must do.
bool ditherCutOuts(const FrameOptions& options) { return options.supersampling > 1; }

/// Levels of detail leave something out, and approximately.
bool allowsDetail(const Options& options) { return options.plan.enabled && !options.plan.exact; }

} // namespace

struct Renderer::State {
    State(const Scene& s, const Options& o, gl::ShaderLibrary& library, gl::Profiler& p, Progress* progress)
        : scene(s), options(o), water(s.water), shaders(library), profiler(p),
          gpuScene(s, anisotropyFor(o.frame), progress), painter(gpuScene, shaders), causticsPass(shaders),
          waterPass(shaders), waterline(shaders), hiddenWater(shaders), glowPass(shaders), downsample(shaders), presentPass(shaders), debugCopy(shaders), stereo(shaders)
    {
    }

    const Scene& scene;
    Options options;
    WaterBody water;
    gl::ShaderLibrary& shaders;
    gl::Profiler& profiler;
    GpuScene gpuScene;
    ScenePainter painter;
    Bounds bounds; ///< of the scene, world space
    std::vector<SceneBox> boxes = listBoxes(scene);
    float bedEdge = 0.0f; ///< m; of the triangles under water
    std::optional<DepthComplexity> complexity; ///< once a method is auto
    bool saidCoarse = false; ///< that they are too large for refraction.camera = flat

    gl::UniformBuffer<blocks::FrameBlock> frameBlock =
        uniformBuffer<blocks::FrameBlock>(BlockIndex::frame, "frame block");
    gl::UniformBuffer<blocks::ViewBlock> viewBlock =
        uniformBuffer<blocks::ViewBlock>(BlockIndex::view, "view block");
    gl::UniformBuffer<blocks::SunBlock> sunBlock = uniformBuffer<blocks::SunBlock>(BlockIndex::sun, "sun block");
    gl::UniformBuffer<blocks::WavesBlock> wavesBlock =
        uniformBuffer<blocks::WavesBlock>(BlockIndex::waves, "waves block");

    gl::Target frame{"frame"};
    SunlightPass sunlight;
    CausticsPass causticsPass;
    HeightMaps heights;
    RefractionPass refraction;
    ReflectionPass reflection;
    RefractionPass refractionBelow; ///< of the pixels under water, in a frame that shows both sides
    ReflectionPass reflectionBelow;
    ScenePass scenePass;
    WaterGrid waterGrid;
    WaterPass waterPass;
    WaterlinePass waterline;
    HiddenWaterPass hiddenWater;
    GlowPass glowPass;
    DownsamplePass downsample;
    PresentPass presentPass;
    DebugCopyPass debugCopy;
    StereoPass stereo;

    Kept kept;

    FrameStats stats;
    bool checking = false;
    std::vector<BadPixels> bad;
    const gl::Target* glow = nullptr;  ///< of this frame, or null
    const gl::Texture* sideOfPixels = nullptr; ///< of a frame that shows both sides of the surface, or null
    const gl::Target* shown = nullptr; ///< what the last frame presented, before the tone curve
    const gl::Target* beside = nullptr; ///< both eyes' displayed halves, or null for one eye
    const gl::Target* anaglyph = nullptr; ///< made of them, or null
    bool hasSunlight = false; ///< this frame's maps of the sun are drawn, or kept
    bool hasCaustics = false; ///< this frame's caustics are drawn; they are the same for both eyes

    // Of this frame, or of the eye that is being drawn.
    ivec2 drawnSize{1};      ///< of the frame, pixels: the picture's or a multiple of it
    View main, refractionView, reflectionView;
    View refractionViewBelow, reflectionViewBelow;
    Sight sight;
    bool looksUpAnew = true; ///< maps and targets are not as the last frame left them
    bool isBelow = false;    ///< all of the picture begins under water
    bool isCrossing = false; ///< some of it does: the views above are of the air's side, those Below of the water's
    blocks::FrameBlock light{};
    blocks::WavesBlock waves{};
    SunVolume volume;
    CausticsRegion region;
    PaintStyle lit; ///< what of the sun's light the passes look up

    void takeOptions(const Options& wanted, const WaterBody& body);
    void drawEye(const FrameInput& input, const Camera& head);
    void drawBothEyes(const FrameInput& input);
    const gl::Target& displayed() const { return anaglyph ? *anaglyph : beside ? *beside : presentPass.target(); }
    void beginEye(const FrameInput& input, const Camera& head);
    void allowErrors(ivec2 picture);
    void beginSunlight(const Camera& head);
    void drawMaps();
    void drawTargets(const FrameInput& input);
    void drawWaterIfSeen(const FrameInput& input);
    SunlightPass::Inputs sunlightInputs() const;
    void drawSunlight();
    SunMaps sunMaps(const gl::Texture* causticsMap) const;
    void drawCaustics();
    void drawHeights();
    void drawRefraction();
    void drawReflection();
    void drawScene(const FrameInput& input);
    void drawWater(const FrameInput& input);
    void drawGlow(const FrameInput& input);
    const gl::Target& selectShown(const FrameInput& input);
    void present(const FrameInput& input);
    FrameStats::Pass& beginPass(PassId pass, const View& view, ivec2 size);
    void check(PassId pass, const gl::Target& target);
};

Renderer::Renderer(const Scene& scene, const Options& options, gl::ShaderLibrary& shaders, gl::Profiler& profiler,
                   Progress* progress)
    : state_(std::make_unique<State>(scene, options, shaders, profiler, progress))
{
    if (scene.pointLights.size() + scene.spotLights.size() > static_cast<std::size_t>(blocks::maxLights))
        log::warning("{}: {} point and spot lights, but only the first {} are drawn", scene.file.string(),
                     scene.pointLights.size() + scene.spotLights.size(), blocks::maxLights);
    state_->bounds = worldBounds(scene);
    // Programs that the first frame would otherwise wait for: the variants of a sunlit scene, where there is a sun.
    const bool sunlit = scene.sun && scene.sun->direction.y > 0.0f;
    const bool watery = scene.water.present && options.water.enabled;
    if (options.detail.pixels > 0.0f && allowsDetail(options)) state_->gpuScene.wantDetail(progress);
    state_->painter.setWater(watery ? &scene.water : nullptr);
    state_->painter.setSunMaps({{}, nullptr, nullptr, options.sunlight.taps});
    PaintStyle lit;
    lit.shadows = sunlit && options.sunlight.shadows;
    lit.distantShadows =
        lit.shadows &&
        sunVolume(scene.water, state_->bounds, scene.sun->direction, options.sunlight).cascades.size() > 1;
    lit.caustics = sunlit && watery && options.caustics.enabled;
    lit.dithersCutOuts = ditherCutOuts(options.frame);
    PaintStyle main = lit;
    main.sunDisc = true;
    main.alphaToCoverage = options.frame.msaa > 1 && !lit.dithersCutOuts;
    state_->painter.prepare(main, false);
    if (watery) state_->painter.prepare(lit, true);
    if (watery) state_->hiddenWater.prepare();
    state_->bedEdge = coarseEdgeUnderWater(scene, scene.water);
    state_->takeOptions(options, scene.water);
}

Renderer::~Renderer() = default;

void Renderer::setOptions(const Options& options, const WaterBody& water)
{
    if (anisotropyFor(options.frame) != anisotropyFor(state_->options.frame))
        state_->gpuScene.setAnisotropy(anisotropyFor(options.frame));
    state_->takeOptions(options, water);
}

void Renderer::State::takeOptions(const Options& wanted, const WaterBody& body)
{
    if (body.level != water.level || body.extent != water.extent || body.centre != water.centre) {
        bedEdge = coarseEdgeUnderWater(scene, body);
        complexity.reset();
    }
    options = wanted;
    if (!allowsDetail(options)) options.detail.pixels = 0.0f;
    water = body;
    if (wantsDepthComplexity(options) && !complexity) complexity = depthComplexity(scene, water);
    if (ditherCutOuts(options.frame)) gpuScene.wantShares();
    if (options.detail.pixels > 0.0f && gpuScene.wantDetail(nullptr)) painter.setWater(water.present ? &water : nullptr);
    if (options.refraction.camera != RefractionOptions::CameraMode::flat || bedEdge <= longestBedEdge) return;
    options.refraction.camera = RefractionOptions::CameraMode::snell;
    if (!std::exchange(saidCoarse, true))
        log::info("refraction.camera = flat needs triangles under water of at most {} m, and they are up to {:.1f} m: "
                  "the camera turned by Snell's law takes its place",
                  longestBedEdge, bedEdge);
}

const Options& Renderer::options() const { return state_->options; }

void Renderer::setChecking(bool checking) { state_->checking = checking; }

const std::vector<BadPixels>& Renderer::badPixels() const { return state_->bad; }

const FrameStats& Renderer::render(const FrameInput& input)
{
    if (input.size.x < 1 || input.size.y < 1)
        throw Error("a picture of {}x{} pixels cannot be rendered", input.size.x, input.size.y);
    State& s = *state_;
    s.profiler.beginFrame();
    s.stats.passes.clear();
    s.bad.clear();
    const Moment moment = momentOf(input, s.options, s.water, s.shaders.rebuilt());
    if (s.kept.beginFrame(moment, s.options.plan, !s.checking)) {
        s.stats.plan.rule(RuleId::keepFrame) = {true, "nothing changed since the last frame"};
        s.profiler.endFrame();
        return s.stats;
    }
    s.beside = s.anaglyph = nullptr;
    s.hasSunlight = s.hasCaustics = false;
    try {
        if (s.options.stereo.isOn()) s.drawBothEyes(input);
        else s.drawEye(input, input.camera);
    } catch (...) {
        s.kept.forget();
        throw;
    }
    s.kept.endFrame();
    s.profiler.endFrame();
    return s.stats;
}

/// @param head what does not depend on the eye is drawn for this camera
void Renderer::State::drawEye(const FrameInput& input, const Camera& head)
{
    beginEye(input, head);
    if (looksUpAnew) drawMaps();
    drawScene(input);
    drawWaterIfSeen(input);
    if (stats.plan[PassId::glow].wanted) drawGlow(input);
    present(input);
}

void Renderer::State::drawBothEyes(const FrameInput& input)
{
    for (const Eye eye : bothEyes) {
        const Camera camera = eyeCamera(input.camera, options.stereo, eye);
        drawEye({camera, input.time, input.size, input.view}, input.camera);
        gl::PassScope scope(profiler, passName(PassId::present));
        stereo.take(eye, *shown, presentPass.target());
    }
    shown = &stereo.linear();
    beside = &stereo.display();
    if (options.stereo.output != StereoOptions::Output::anaglyph) return;
    gl::PassScope scope(profiler, passName(PassId::present));
    anaglyph = &stereo.drawAnaglyph();
}

void Renderer::State::beginEye(const FrameInput& input, const Camera& head)
{
    const float aspect = static_cast<float>(input.size.x) / static_cast<float>(input.size.y);
    light = tarn::frameBlock(scene, water, gpuScene.sky(), options);
    Options allowed = options;
    if (wantsRawValues(input.view)) allowed.plan = planForRawValues(options.plan);
    sight = lookAround(boxes, scene, water, input.camera, input.size, allowed, light);
    sight.waterWasHidden = hiddenWater.wasHidden() && !checking && !input.sameMoment;
    const FramePlan before = std::move(stats.plan);
    stats.plan = planFrame(scene, water, input.camera, allowed, input.size, input.time,
                           complexity ? &*complexity : nullptr, &sight);
    // What the last frame left out, a debug view of the same moment may want to show.
    looksUpAnew = !input.sameMoment || wantsMore(stats.plan, before);
    glow = nullptr;
    sideOfPixels = nullptr;
    isBelow = stats.plan.side == WaterSide::below;
    isCrossing = stats.plan.side == WaterSide::crossing;
    main = mainView(input.camera, aspect);
    refractionView = tarn::refractionView(input.camera, aspect, water, options, isBelow);
    reflectionView = tarn::reflectionView(input.camera, aspect, water, options.reflection, isBelow);
    reflectionView.lookedUp = stats.plan.mirrorBounds;
    if (isCrossing) {
        refractionViewBelow = tarn::refractionView(input.camera, aspect, water, options, true);
        reflectionViewBelow = tarn::reflectionView(input.camera, aspect, water, options.reflection, true);
    }
    allowErrors(input.size);
    for (std::size_t axis = 0; axis < 2; ++axis) light.waterGrid[axis] = narrowed(stats.plan.waterGrid[axis]);
    frameBlock.update(light);
    waves = tarn::wavesBlock(water, input.time);
    wavesBlock.update(waves);
    painter.setWater(light.hasWater > 0.5f ? &water : nullptr);
    beginSunlight(head);
}

/// How far off geometry may be in each view. The maps of heights hold full detail: what marches through them goes closer.
void Renderer::State::allowErrors(ivec2 picture)
{
    const auto allow = [&](View& view, ivec2 size) {
        view.geometryError = geometryErrorOf(view, size, options.detail.pixels);
    };
    allow(main, glm::max(picture, stats.plan[PassId::scene].size));
    for (View* view : {&refractionView, &refractionViewBelow}) allow(*view, ivec2(options.refraction.targetSize));
    for (View* view : {&reflectionView, &reflectionViewBelow}) allow(*view, ivec2(options.reflection.targetSize));
}

void Renderer::State::beginSunlight(const Camera& head)
{
    volume = sunVolume(water, bounds, light.sunDirection, options.sunlight);
    region = causticsRegion(water, head, options.caustics);
    sunBlock.update(tarn::sunBlock(volume, region, options));
    lit = PaintStyle{};
    lit.dithersCutOuts = ditherCutOuts(options.frame);
    lit.shadows = stats.plan[PassId::sunlight].wanted && options.sunlight.shadows;
    lit.distantShadows = lit.shadows && volume.cascades.size() > 1;
    lit.caustics = stats.plan[PassId::caustics].wanted;
}

SunlightPass::Inputs Renderer::State::sunlightInputs() const
{
    return {volume,      light.sunDirection, light.sunDirectionBelow,
            water.level, lit.dithersCutOuts, light.hasWater > 0.5f, options.detail.pixels};
}

void Renderer::State::drawSunlight()
{
    gl::PassScope scope(profiler, passName(PassId::sunlight));
    FrameStats::Pass& pass = stats.of(passName(PassId::sunlight));
    const SunlightPass::Inputs inputs = sunlightInputs();
    const bool holds = !sunlight.isStale(inputs, options.sunlight);
    if (!std::exchange(hasSunlight, true) && !kept.map(PassId::sunlight, holds)) {
        const auto draw = [&](SunLayer layer, std::size_t cascade, const vec3& toSun) {
            View view = sunView(volume, layer, cascade, toSun, water, inputs.hasWater);
            // What clears a surface by the bias must still clear it.
            view.geometryError = std::min(geometryErrorOf(view, ivec2(options.sunlight.mapSize), inputs.detail),
                                          0.5f * shadowBias(volume, cascade, options.sunlight));
            viewBlock.update(tarn::viewBlock(view, ivec2(options.sunlight.mapSize)));
            sunlight.draw(layer, cascade, view, painter, inputs, options.sunlight, options.plan.allows(RuleId::cullChunks), pass);
        };
        for (std::size_t cascade = 0; cascade < volume.cascades.size(); ++cascade)
            draw(SunLayer::afloat, cascade, inputs.toSun);
        draw(SunLayer::submerged, 0, inputs.toSunBelow);
        sunlight.keep(inputs, options.sunlight);
    }
    painter.setSunMaps(sunMaps(nullptr));
}

SunMaps Renderer::State::sunMaps(const gl::Texture* causticsMap) const
{
    SunMaps maps{{}, &sunlight.depth(SunLayer::submerged), causticsMap, options.sunlight.taps};
    for (std::size_t cascade = 0; cascade < volume.cascades.size(); ++cascade)
        maps.afloat.push_back(&sunlight.depth(SunLayer::afloat, cascade));
    return maps;
}

namespace {

/// Whether waves move the place where the sun's light enters by more than a quarter of a photon's cell.
bool movesSideways(const WaterBody& water, const vec3& toSun, float cellEdge)
{
    const float slant = std::sqrt(toSun.x * toSun.x + toSun.z * toSun.z) / toSun.y;
    return totalAmplitude(water) * slant > 0.25f * cellEdge;
}

} // namespace

void Renderer::State::drawCaustics()
{
    gl::PassScope scope(profiler, passName(PassId::caustics));
    FrameStats::Pass& pass = stats.of(passName(PassId::caustics));
    const float cell = 2.0f * region.rect.halfExtent.x / static_cast<float>(options.caustics.photons);
    const gl::Texture& afloat = sunlight.depth(SunLayer::afloat);
    const gl::Texture& submerged = sunlight.depth(SunLayer::submerged);
    const gl::Target& caustics =
        causticsPass.draw(options.caustics,
                          {.submergedDepth = submerged,
                           .afloatDepth = options.sunlight.shadows ? &afloat : nullptr,
                           .absorption = water.absorption,
                           .surfaceMovesSideways = movesSideways(water, light.sunDirection, cell)},
                          pass);
    kept.causticsWereDrawn();
    check(PassId::caustics, caustics);
}

FrameStats::Pass& Renderer::State::beginPass(PassId pass, const View& view, ivec2 size)
{
    viewBlock.update(tarn::viewBlock(view, size));
    return stats.of(passName(pass));
}

void Renderer::State::check(PassId pass, const gl::Target& target)
{
    if (!checking) return;
    if (BadPixels found = checkTarget(passName(pass), target); found.any()) bad.push_back(std::move(found));
}

/// What the scene and the water look up that does not depend on the eye, or little.
void Renderer::State::drawMaps()
{
    if (stats.plan[PassId::sunlight].wanted) drawSunlight();
    if (stats.plan[PassId::caustics].wanted) {
        if (!std::exchange(hasCaustics, true) && !kept.caustics({sunlightInputs(), region, light, waves})) drawCaustics();
        painter.setSunMaps(sunMaps(&causticsPass.target().colour()));
    }
    if (stats.plan[PassId::heights].wanted) drawHeights();
    kept.tell(stats.plan, RuleId::keepMaps);
}

/// What the water alone looks up.
void Renderer::State::drawTargets(const FrameInput& input)
{
    const auto keeps = [&](PassId pass, const View& view, bool receives) {
        const bool showsCaustics = stats.plan.side != WaterSide::above || receives;
        return kept.target(pass, input.camera, stats.plan.side, view.lookedUp, lit.caustics, showsCaustics);
    };
    if (stats.plan[PassId::refraction].wanted && !keeps(PassId::refraction, refractionView, sight.refractionReceives)) drawRefraction();
    if (stats.plan[PassId::reflection].wanted && !keeps(PassId::reflection, reflectionView, sight.reflectionReceives)) drawReflection();
    kept.tell(stats.plan, RuleId::keepTargets);
}

/// In a frame that may hide the water, its own depth decides, on the GPU, whether anything is drawn here.
void Renderer::State::drawWaterIfSeen(const FrameInput& input)
{
    const bool isAsked = stats.plan.rule(RuleId::waterHidden).applies;
    if (isAsked) {
        gl::PassScope scope(profiler, passName(PassId::water));
        viewBlock.update(tarn::viewBlock(main, drawnSize));
        hiddenWater.ask(frame, waterBounds(water), main.eye);
    }
    std::optional<gl::VisibilityQuery::Condition> ifSeen;
    if (isAsked) ifSeen.emplace(hiddenWater.query());
    if (looksUpAnew) drawTargets(input);
    if (stats.plan[PassId::water].wanted) {
        std::optional<gl::VisibilityQuery::Scope> counting;
        if (!isAsked && stats.plan.side == WaterSide::above) counting.emplace(hiddenWater.query());
        drawWater(input);
    }
    if (isAsked) kept.forgetTargets(); // the GPU alone knows whether they were drawn
}

void Renderer::State::drawHeights()
{
    gl::PassScope scope(profiler, passName(PassId::heights));
    FrameStats::Pass& pass = stats.of(passName(PassId::heights));
    const HeightMaps::Inputs inputs{stats.plan, options, water, bounds, volume, light, lit, scene.maps};
    heights.draw(inputs, painter, viewBlock, pass);
}

void Renderer::State::drawRefraction()
{
    gl::PassScope scope(profiler, passName(PassId::refraction));
    FrameStats::Pass& pass = beginPass(PassId::refraction, refractionView, stats.plan[PassId::refraction].size);
    const auto draw = [&](RefractionPass& side, const View& view, bool underwater) {
        const RefractionPass::Inputs inputs{.view = view,
                                            .underwater = underwater,
                                            .deepRadiance = light.deepRadiance,
                                            .cull = options.plan.allows(RuleId::cullChunks),
                                            .style = lit};
        check(PassId::refraction, side.draw(painter, options.refraction, inputs, pass));
    };
    if (stats.plan.targetsBed) draw(refraction, refractionView, isBelow);
    if (!isCrossing) return;
    viewBlock.update(tarn::viewBlock(refractionViewBelow, stats.plan[PassId::refraction].size));
    draw(refractionBelow, refractionViewBelow, true);
}

void Renderer::State::drawReflection()
{
    gl::PassScope scope(profiler, passName(PassId::reflection));
    FrameStats::Pass& pass = beginPass(PassId::reflection, reflectionView, stats.plan[PassId::reflection].size);
    const auto draw = [&](ReflectionPass& side, const View& view, bool underwater) {
        const ReflectionPass::Inputs inputs{
            .view = view, .underwater = underwater, .cull = options.plan.allows(RuleId::cullChunks), .style = lit};
        check(PassId::reflection, side.draw(painter, options.reflection, inputs, pass));
    };
    if (stats.plan.targetsMirror) draw(reflection, reflectionView, isBelow);
    if (!isCrossing) return;
    viewBlock.update(tarn::viewBlock(reflectionViewBelow, stats.plan[PassId::reflection].size));
    draw(reflectionBelow, reflectionViewBelow, true);
}

void Renderer::State::drawScene(const FrameInput& input)
{
    gl::PassScope scope(profiler, passName(PassId::scene));
    const bool raw = wantsRawValues(input.view);
    // A mean of raw values is none: a position between two others, a normal that is no longer of unit length.
    drawnSize = raw ? input.size : stats.plan[PassId::scene].size;
    frame.ensure({.size = drawnSize,
                  .colours = {raw ? gl::Format::rgba32f : gl::Format::rgba16f},
                  .depth = gl::Format::depth24,
                  .samples = raw ? 1 : options.frame.msaa});

    ScenePass::Inputs inputs{.view = main, .style = lit, .cover = {}, .cull = options.plan.allows(RuleId::cullChunks)};
    if (isWaterView(input.view)) { // what hides the water is all that they need
        inputs.style = PaintStyle{};
        inputs.style.depthOnly = true;
    }
    inputs.style.underwaterEye = isBelow;
    inputs.style.sunDisc = !isBelow;
    if (raw) inputs.style.dithersCutOuts = false; // no mean is taken
    inputs.style.alphaToCoverage = frame.isMultisampled() && !inputs.style.dithersCutOuts;
    inputs.style.debugNormals = input.view == DebugView::normals;
    inputs.style.sky = !raw;
    if (stats.plan[PassId::water].wanted && stats.plan.side == WaterSide::above &&
        input.view != DebugView::sceneDepth)
        inputs.cover = waterCover(water);
    FrameStats::Pass& pass = beginPass(PassId::scene, main, drawnSize);
    if (isCrossing) sideOfPixels = &waterline.draw(main, drawnSize);
    if (!inputs.style.depthOnly) inputs.style.waterline = sideOfPixels;
    scenePass.draw(painter, frame, inputs, pass);
    if (isWaterView(input.view)) frame.drawFramebuffer().clearColour(vec4(0.0f));
    if (!raw) check(PassId::scene, frame);
}

void Renderer::State::drawWater(const FrameInput& input)
{
    gl::PassScope scope(profiler, passName(PassId::water));
    const bool refracts = stats.plan[PassId::refraction].wanted;
    const bool reflects = stats.plan[PassId::reflection].wanted;
    const bool marchesBed = stats.plan.raycastsBed, marchesMirror = stats.plan.raycastsMirror;
    WaterPass::Inputs inputs{.bed = {},
                             .afloat = marchesMirror ? &heights.afloat() : nullptr,
                             .refraction = refracts && stats.plan.targetsBed ? &refraction.target() : nullptr,
                             .refractionView = &refractionView,
                             .reflection = reflects && stats.plan.targetsMirror ? &reflection.target() : nullptr,
                             .reflectionView = &reflectionView,
                             .skyMap = gpuScene.skyMap(),
                             .ior = water.ior,
                             .normalMap = normalMapInputs(water, gpuScene.waterNormals(), input.time),
                             .underwater = isBelow,
                             .view = input.view};
    if (marchesBed) inputs.bed.emplace(WaterPass::Bed{heights.bed(), painter.sunMaps(), lit});
    if (isCrossing) inputs.waterline = sideOfPixels;
    FrameStats::Pass& pass = beginPass(PassId::water, main, drawnSize);
    waterPass.draw(frame, waterGrid, options, inputs, pass);
    if (isCrossing) {
        inputs.bed.reset();
        inputs.afloat = nullptr;
        if (refracts) inputs.refraction = &refractionBelow.target();
        inputs.refractionView = &refractionViewBelow;
        if (reflects) inputs.reflection = &reflectionBelow.target();
        inputs.reflectionView = &reflectionViewBelow;
        inputs.underwater = true;
        waterPass.draw(frame, waterGrid, options, inputs, pass);
    }
    if (!wantsRawValues(input.view)) check(PassId::water, frame);
}

void Renderer::State::drawGlow(const FrameInput& input)
{
    if (wantsRawValues(input.view)) return;
    gl::PassScope scope(profiler, passName(PassId::glow));
    frame.resolve(); // for its depth
    const ivec2 size = stats.plan[PassId::glow].size;
    FrameStats::Pass& pass = beginPass(PassId::glow, main, size);
    glow = &glowPass.draw(waterGrid, options, {.sceneDepth = frame.depth(),
                           .size = size,
                           .normalMap = normalMapInputs(water, gpuScene.waterNormals(), input.time)},
                          pass);
    check(PassId::glow, *glow);
}

/// What is presented: the frame, or in a debug view the target that it shows.
const gl::Target& Renderer::State::selectShown(const FrameInput& input)
{
    const ivec2 size = input.size;
    // With raycast the target, if there is one, is that of what is seen from below.
    const bool refracts = stats.plan[PassId::refraction].wanted && stats.plan.targetsBed;
    const bool reflects = stats.plan[PassId::reflection].wanted && stats.plan.targetsMirror;
    switch (input.view) {
    case DebugView::sceneDepth: return debugCopy.depth(frame.depth(), size, main.nearPlane, main.farPlane);
    case DebugView::refractionColour:
        return refracts ? debugCopy.colour(refraction.target().colour(), size) : debugCopy.nothing(size);
    case DebugView::refractionDepth:
        return refracts ? debugCopy.depth(refraction.target().depth(), size, refractionView.nearPlane,
                                          refractionView.farPlane)
                        : debugCopy.nothing(size);
    case DebugView::reflection:
        return reflects ? debugCopy.colour(reflection.target().colour(), size)
                                                     : debugCopy.nothing(size);
    case DebugView::caustics:
        return stats.plan[PassId::caustics].wanted ? debugCopy.colour(causticsPass.target().colour(), size)
                                                   : debugCopy.nothing(size);
    default: return downsample.draw(frame, size);
    }
}

void Renderer::State::present(const FrameInput& input)
{
    gl::PassScope scope(profiler, passName(PassId::present));
    frame.resolve();
    shown = &selectShown(input);
    presentPass.draw(shown->colour(), glow ? &glow->colour() : nullptr, options.frame, input.view);
    check(PassId::present, presentPass.target());
}

void Renderer::presentToWindow(ivec2 windowSize) const
{
    const gl::Framebuffer window = gl::Framebuffer::window(windowSize);
    state_->displayed().framebuffer().blitTo(window, {.filter = gl::Filter::linear});
    window.bind();
}

Image Renderer::readDisplay() const { return readBytes(state_->displayed().framebuffer()); }

Image Renderer::readLinear() const
{
    const State& s = *state_;
    if (!s.shown) throw Error("no frame has been rendered yet");
    if (s.anaglyph)
        throw Error("an anaglyph is made of what a display shows and has no radiance; stereo.output = side_by_side or "
                    "pair has");
    return readFloats(s.shown->framebuffer());
}

const HeightField* Renderer::heightField() const
{
    return state_->stats.plan.raycastsBed && !state_->stats.plan.targetsBed ? &state_->heights.bed().field() : nullptr;
}

std::optional<HeightMapPicture> Renderer::readMap(MapKind kind) const
{
    const FramePlan& plan = state_->stats.plan;
    if (!(kind == MapKind::bed ? plan.raycastsBed : plan.raycastsMirror)) return std::nullopt;
    return state_->heights.picture(kind);
}

std::size_t Renderer::geometryBytes() const { return state_->gpuScene.geometryBytes(); }

const View& Renderer::refractionView() const { return state_->refractionView; }

std::optional<CausticsMap> Renderer::readCaustics() const
{
    const State& s = *state_;
    if (!s.shown || !s.stats.plan[PassId::caustics].wanted) return std::nullopt;
    const gl::Texture& texture = s.causticsPass.target().colour();
    CausticsMap map{.region = s.region,
                    .edge = texture.size().x,
                    .light = {},
                    .water = {s.water.centre, 0.5f * s.water.extent},
                    .level = s.water.level,
                    .toSun = s.light.sunDirectionBelow};
    const std::vector<float> texels = texture.readBack();
    const auto channels = static_cast<std::size_t>(gl::channelCount(texture.format()));
    for (std::size_t i = 0; i + channels <= texels.size(); i += channels)
        map.light.emplace_back(texels[i], texels[i + 1], texels[i + 2]);
    return map;
}

} // namespace tarn
