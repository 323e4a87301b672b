#include "render/renderer.h"

#include "base/error.h"
#include "base/files.h"
#include "base/log.h"
#include "gl/workarounds.h"
#include "plan/reduce.h"
#include "plan/refinement.h"
#include "render/bed_detail.h"
#include "render/bindings.h"
#include "render/frame_context.h"
#include "render/frame_light.h"
#include "render/gather_visibility.h"
#include "render/height_maps.h"
#include "render/passes/accumulate.h"
#include "render/passes/debug_copy.h"
#include "render/passes/downsample.h"
#include "render/passes/fxaa.h"
#include "render/passes/glow.h"
#include "render/passes/occlusion.h"
#include "render/passes/present.h"
#include "render/passes/scene_pass.h"
#include "render/passes/stereo.h"
#include "render/passes/upscale.h"
#include "render/passes/water.h"
#include "render/passes/waterline.h"
#include "render/read_back.h"
#include "render/sun_passes.h"
#include "render/unrolled.h"
#include "render/water_targets.h"

#include <fmt/format.h>

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
float anisotropyFor(const FrameOptions& options) { return gl::avoidsAnisotropy() ? 1.0f : options.anisotropy; }

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

/// Levels of detail leave something out, and approximately.
bool allowsDetail(const Options& options) { return options.plan.enabled && !options.plan.exact; }

} // namespace

std::shared_ptr<GpuScene> uploadScene(const Scene& scene, const Options& options, Progress* progress)
{
    return std::make_shared<GpuScene>(scene, anisotropyFor(options.frame), progress);
}

struct Renderer::State {
    State(std::shared_ptr<GpuScene> uploaded, const Options& o, gl::ShaderLibrary& library, gl::Profiler& p)
        : scene(uploaded->scene()), options(o), water(scene.water), shaders(library),
          uploadedScene(std::move(uploaded)), sceneRenderer(gpuScene, shaders), context(p, sceneRenderer), sun(shaders),
          waterPass(shaders), waterline(shaders), occlusionPass(shaders), glowPass(shaders), downsample(shaders),
          accumulate(shaders), presentPass(shaders), fxaa(shaders), upscale(shaders), debugCopy(shaders),
          stereo(shaders)
    {}

    const Scene& scene;
    Options options;
    WaterBody water;
    gl::ShaderLibrary& shaders;
    std::shared_ptr<GpuScene> uploadedScene;
    GpuScene& gpuScene = *uploadedScene;
    SceneRenderer sceneRenderer;
    FrameContext context;
    Bounds bounds; ///< of the scene, world space
    std::vector<SceneBox> boxes = listBoxes(scene);
    float bedEdge = 0.0f;                      ///< m; of the triangles under water
    std::optional<DepthComplexity> complexity; ///< once a method is auto
    bool saidCoarse = false;                   ///< that they are too large for refraction.camera = flat

    gl::UniformBuffer<blocks::FrameBlock> frameBlock =
        uniformBuffer<blocks::FrameBlock>(BlockIndex::frame, "frame block");
    gl::UniformBuffer<blocks::WavesBlock> wavesBlock =
        uniformBuffer<blocks::WavesBlock>(BlockIndex::waves, "waves block");

    gl::Target frame{"frame"};
    SunPasses sun;
    HeightMaps heights;
    WaterTargets targets;
    ScenePass scenePass;
    WaterGrid waterGrid;
    WaterPass waterPass;
    WaterlinePass waterline;
    OcclusionPass occlusionPass;
    HiddenParts hiddenBlocks; ///< of the water
    gl::VisibilityQuery slab; ///< whether the box that the surface moves in is seen
    GlowPass glowPass;
    DownsamplePass downsample;
    AccumulatePass accumulate;
    PresentPass presentPass;
    FxaaPass fxaa;
    UpscalePass upscale;
    DebugCopyPass debugCopy;
    StereoPass stereo;

    const gl::Target* glow = nullptr;          ///< of this frame, or null
    const gl::Texture* sideOfPixels = nullptr; ///< of a frame that shows both sides of the surface, or null
    const gl::Target* shown = nullptr;         ///< what the last frame presented, before tone curve and upscaling
    const gl::Target* display = nullptr;       ///< the same as it is shown, of the picture's size
    ivec2 presented{1};                        ///< the last frame's size, both eyes' beside each other
    const gl::Target* beside = nullptr;        ///< both eyes' displayed halves, or null for one eye
    const gl::Target* anaglyph = nullptr;      ///< made of them, or null

    // Of this frame, or of the eye that is being drawn.
    ivec2 drawnSize{1}; ///< of the frame, pixels
    View main;
    VisibilityFacts visibility;
    bool looksUpAnew = true; ///< maps and targets are not as the last frame left them
    bool isBelow = false;    ///< all of the picture begins under water
    bool isCrossing = false; ///< some of it does
    blocks::FrameBlock light{};
    blocks::WavesBlock waves{};

    void takeOptions(const Options& wanted, const WaterBody& body);
    void drawEye(const FrameInput& input, const Camera& head);
    void drawBothEyes(const FrameInput& input);
    const gl::Target& displayed() const;
    const gl::Target& linear();
    void beginEye(const FrameInput& input, const Camera& head);
    const FramePlan& plan() const { return context.plan(); }
    void drawMaps(const Camera& head);
    SunPasses::Inputs sunInputs(const Camera& head) const;
    WaterTargets::Inputs targetInputs(const FrameInput& input) const;
    void drawWaterIfSeen(const FrameInput& input);
    void tellHidden(const Occlusion& occlusion);
    void drawHeights();
    void drawScene(const FrameInput& input);
    void drawWater(const FrameInput& input);
    void drawGlow(const FrameInput& input);
    const gl::Target& selectShown(const FrameInput& input);
    void present(const FrameInput& input);
};

Renderer::Renderer(const Scene& scene, const Options& options, gl::ShaderLibrary& shaders, gl::Profiler& profiler,
                   Progress* progress)
    : Renderer(uploadScene(scene, options, progress), options, shaders, profiler, progress)
{}

Renderer::Renderer(std::shared_ptr<GpuScene> uploaded, const Options& options, gl::ShaderLibrary& shaders,
                   gl::Profiler& profiler, Progress* progress)
    : state_(std::make_unique<State>(std::move(uploaded), options, shaders, profiler))
{
    const Scene& scene = state_->scene;
    if (scene.pointLights.size() + scene.spotLights.size() > static_cast<std::size_t>(blocks::maxLights))
        log::warning("{}: {} point and spot lights, but only the first {} are drawn", scene.file.string(),
                     scene.pointLights.size() + scene.spotLights.size(), blocks::maxLights);
    state_->bounds = worldBounds(scene);
    // Programs that the first frame would otherwise wait for: the variants of a sunlit scene, where there is a sun.
    const bool sunlit = scene.sun && scene.sun->direction.y > 0.0f;
    const bool watery = scene.water.present && options.water.enabled;
    if (options.detail.pixels > 0.0f && allowsDetail(options)) state_->gpuScene.ensureDetail(progress);
    state_->sceneRenderer.setWater(watery ? &scene.water : nullptr);
    SceneVariant lit;
    lit.shadows = sunlit && options.sunlight.shadows;
    SunMaps maps;
    maps.taps = options.sunlight.taps;
    state_->sceneRenderer.setSunMaps(maps);
    lit.caustics = sunlit && watery && options.caustics.enabled;
    lit.dithersCutOuts = dithersCutOuts(options.frame);
    SceneVariant main = lit;
    main.sunDisc = true;
    main.alphaToCoverage = options.frame.samples() > 1 && !lit.dithersCutOuts;
    state_->sceneRenderer.prepare(main);
    if (watery) state_->sceneRenderer.prepare(lit);
    state_->occlusionPass.prepare();
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
    if (dithersCutOuts(options.frame)) gpuScene.ensureCoverage();
    if (options.detail.pixels > 0.0f && gpuScene.ensureDetail(nullptr))
        sceneRenderer.setWater(water.present ? &water : nullptr);
    if (options.refraction.camera != RefractionOptions::CameraMode::flat || bedEdge <= longestBedEdge) return;
    options.refraction.camera = RefractionOptions::CameraMode::snell;
    if (!std::exchange(saidCoarse, true))
        log::info("refraction.camera = flat needs triangles under water of at most {} m, and they are up to {:.1f} m: "
                  "the camera turned by Snell's law takes its place",
                  longestBedEdge, bedEdge);
}

gl::ShaderLibrary& Renderer::shaders() { return state_->shaders; }

const Options& Renderer::options() const { return state_->options; }

void Renderer::setChecking(bool checking) { state_->context.checking = checking; }

void Renderer::setWarmingUp(bool warmingUp) { state_->sceneRenderer.setWarmingUp(warmingUp); }

const std::vector<BadPixels>& Renderer::badPixels() const { return state_->context.bad; }

const FrameStats& Renderer::render(const FrameInput& input)
{
    if (input.size.x < 1 || input.size.y < 1)
        throw Error("a picture of {}x{} pixels cannot be rendered", input.size.x, input.size.y);
    State& s = *state_;
    s.context.profiler.beginFrame();
    s.context.stats.passes.clear();
    s.context.bad.clear();
    const FrameKey moment = frameKeyOf(input, s.options, s.water, s.shaders.rebuilt());
    if (s.context.cache.beginFrame(moment, s.options.plan, !s.context.checking)) {
        s.context.stats.plan.rule(RuleId::keepFrame) = {true, "nothing changed since the last frame"};
        s.context.profiler.endFrame();
        return s.context.stats;
    }
    s.beside = s.anaglyph = nullptr;
    s.sun.beginFrame();
    try {
        if (s.options.stereo.isOn())
            s.drawBothEyes(input);
        else
            s.drawEye(input, input.camera);
    } catch (...) {
        s.context.cache.forget();
        throw;
    }
    s.context.cache.endFrame();
    s.context.profiler.endFrame();
    return s.context.stats;
}

/// @param head what does not depend on the eye is drawn for this camera
void Renderer::State::drawEye(const FrameInput& input, const Camera& head)
{
    const auto goOn = [&] {
        if (input.abandoned && *input.abandoned) throw FrameAbandoned{};
    };
    beginEye(input, head);
    if (looksUpAnew) drawMaps(head);
    goOn();
    drawScene(input);
    goOn();
    drawWaterIfSeen(input);
    goOn();
    if (plan()[PassId::glow].wanted) drawGlow(input);
    present(input);
}

void Renderer::State::drawBothEyes(const FrameInput& input)
{
    for (const Eye eye : bothEyes) {
        const Camera camera = eyeCamera(input.camera, options.stereo, eye);
        drawEye({camera, input.time, input.size, input.view}, input.camera);
        gl::PassScope scope(context.profiler, passName(PassId::present));
        stereo.take(eye, *shown, *display);
    }
    shown = &stereo.linear();
    beside = &stereo.display();
    if (options.stereo.output != StereoOptions::Output::anaglyph) return;
    gl::PassScope scope(context.profiler, passName(PassId::present));
    anaglyph = &stereo.drawAnaglyph();
}

void Renderer::State::beginEye(const FrameInput& input, const Camera& head)
{
    const float aspect = static_cast<float>(input.size.x) / static_cast<float>(input.size.y);
    light = tarn::frameBlock(scene, water, gpuScene.sky(), options);
    Options allowed = options;
    if (wantsRawValues(input.view)) allowed.plan = planForRawValues(options.plan);
    const int sample = options.stereo.isOn() || wantsRawValues(input.view) ? 0 : input.sample;
    // The samples of an edge's pixels look things up half a pixel beyond what is bounded for their middles.
    if (sample > 0) allowed.plan.rules[static_cast<std::size_t>(RuleId::targetBounds)] = false;
    visibility = gatherVisibility(boxes, scene, water, input.camera, input.size, allowed, light);
    hiddenBlocks.takeAnswers();
    visibility.waterWasHidden = hiddenBlocks.wereAllHidden() &&
                                OcclusionPass::canAsk(waterBounds(water), input.camera.eye) && !context.checking &&
                                !input.sameMoment;
    const FramePlan before = std::move(context.stats.plan);
    context.stats.plan = planFrame(scene, water, input.camera, allowed, input.size, input.time,
                                   complexity ? &*complexity : nullptr, &visibility);
    // What the last frame left out, a debug view of the same moment may want to show.
    looksUpAnew = !input.sameMoment || wantsMore(context.stats.plan, before);
    glow = nullptr;
    sideOfPixels = nullptr;
    isBelow = plan().side == WaterSide::below;
    isCrossing = plan().side == WaterSide::crossing;
    main = mainView(input.camera, aspect);
    if (sample > 0)
        main.clipFromView = glm::translate(mat4(1.0f), vec3(2.0f * jitterOf(sample) /
                                                                vec2(glm::min(input.size, plan()[PassId::scene].size)),
                                                            0.0f)) *
                            main.clipFromView;
    // How far off geometry may be. The maps of heights hold full detail: what marches through them goes closer.
    main.geometryError = geometryErrorOf(main, plan()[PassId::scene].size, options.detail.pixels);
    targets.begin(targetInputs(input), plan());
    for (std::size_t axis = 0; axis < 2; ++axis) light.waterGrid[axis] = narrowed(context.stats.plan.waterGrid[axis]);
    frameBlock.update(light);
    waves = tarn::wavesBlock(water, input.time);
    wavesBlock.update(waves);
    sceneRenderer.setWater(light.hasWater > 0.5f ? &water : nullptr);
    sun.begin(sunInputs(head), context.cache, looksUpAnew);
}

SunPasses::Inputs Renderer::State::sunInputs(const Camera& head) const
{
    return {plan(), options, water, bounds, head, light, waves};
}

WaterTargets::Inputs Renderer::State::targetInputs(const FrameInput& input) const
{
    const float aspect = static_cast<float>(input.size.x) / static_cast<float>(input.size.y);
    return {options, water, input.camera, aspect, sun.lit(), light.deepRadiance};
}

/// What the scene and the water look up that does not depend on the eye, or little.
void Renderer::State::drawMaps(const Camera& head)
{
    sun.draw(sunInputs(head), context);
    if (plan()[PassId::heights].wanted) drawHeights();
    context.cache.tell(context.stats.plan, RuleId::keepMaps);
}

/// In a frame that may hide the water, its own depth decides, on the GPU, whether anything is drawn here.
void Renderer::State::drawWaterIfSeen(const FrameInput& input)
{
    const bool isAsked = context.stats.plan.rule(RuleId::waterHidden).applies;
    if (isAsked) {
        gl::PassScope scope(context.profiler, passName(PassId::water));
        context.viewBlock.update(tarn::viewBlock(main, drawnSize));
        frame.bind();
        occlusionPass.ask(slab, waterBounds(water), main.eye);
    }
    std::optional<gl::VisibilityQuery::Condition> ifSeen;
    if (isAsked) ifSeen.emplace(slab);
    if (looksUpAnew) targets.draw(targetInputs(input), visibility, context);
    if (plan()[PassId::water].wanted) drawWater(input);
    if (isAsked) context.cache.forgetTargets(); // the GPU alone knows whether they were drawn
}

/// Tells the plan what was left out by the frame's own depth, or might have been.
void Renderer::State::tellHidden(const Occlusion& occlusion)
{
    RuleState& rule = context.stats.plan.rule(RuleId::cullHidden);
    rule.applies = occlusion.asked > 0;
    rule.why = rule.applies
                   ? fmt::format("{} of {} blocks in view were hidden in the last frame: drawn only if this one's "
                                 "depth shows some of their boxes",
                                 occlusion.asked, occlusion.drawn)
                   : "no block in view was hidden in the last frame";
}

void Renderer::State::drawHeights()
{
    gl::PassScope scope(context.profiler, passName(PassId::heights));
    FrameStats::Pass& pass = context.stats.of(passName(PassId::heights));
    const HeightMaps::Inputs inputs{context.stats.plan, options, water,     bounds,
                                    sun.volume(),       light,   sun.lit(), scene.maps};
    heights.draw(inputs, sceneRenderer, context.viewBlock, pass);
}

void Renderer::State::drawScene(const FrameInput& input)
{
    gl::PassScope scope(context.profiler, passName(PassId::scene));
    const bool raw = wantsRawValues(input.view);
    // A mean of raw values is none: a position between two others, a normal that is no longer of unit length.
    drawnSize = raw ? input.size : plan()[PassId::scene].size;
    frame.ensure({.size = drawnSize,
                  .colours = {raw ? gl::Format::rgba32f : gl::Format::rgba16f},
                  .depth = gl::Format::depth24,
                  .samples = raw ? 1 : options.frame.samples()});

    ScenePass::Inputs inputs{
        .view = main, .variant = sun.lit(), .cover = {}, .cull = options.plan.allows(RuleId::cullChunks)};
    if (isWaterView(input.view)) { // what hides the water is all that they need
        inputs.variant = SceneVariant{};
        inputs.variant.depthOnly = true;
    }
    inputs.variant.underwaterEye = isBelow;
    inputs.variant.sunDisc = !isBelow;
    if (raw) inputs.variant.dithersCutOuts = false; // no mean is taken
    inputs.variant.alphaToCoverage = frame.isMultisampled() && !inputs.variant.dithersCutOuts;
    inputs.variant.depthFirst &= !frame.isMultisampled();
    inputs.variant.debugNormals = input.view == DebugView::normals;
    inputs.variant.sky = !raw;
    if (plan()[PassId::water].wanted && plan().side == WaterSide::above && input.view != DebugView::sceneDepth)
        inputs.cover = waterCover(water);
    FrameStats::Pass& pass = context.beginPass(PassId::scene, main, drawnSize);
    if (isCrossing) sideOfPixels = &waterline.draw(main, drawnSize);
    if (!inputs.variant.depthOnly) inputs.variant.waterline = sideOfPixels;
    scenePass.draw(sceneRenderer, frame, inputs, pass);
    if (isWaterView(input.view)) frame.drawFramebuffer().clearColour(vec4(0.0f));
    if (!raw) context.check(PassId::scene, frame);
}

void Renderer::State::drawWater(const FrameInput& input)
{
    gl::PassScope scope(context.profiler, passName(PassId::water));
    const bool refracts = plan()[PassId::refraction].wanted;
    const bool reflects = plan()[PassId::reflection].wanted;
    const bool marchesBed = plan().raycastsBed, marchesMirror = plan().raycastsMirror;
    const WaterTargets::Side& side = targets.first();
    WaterPass::Inputs inputs{.bed = {},
                             .aboveWater = marchesMirror ? &heights.aboveWater() : nullptr,
                             .refraction = refracts && plan().targetsBed ? &side.refraction.target() : nullptr,
                             .refractionView = &side.refractionView,
                             .reflection = reflects && plan().targetsMirror ? &side.reflection.target() : nullptr,
                             .reflectionView = &side.reflectionView,
                             .skyMap = gpuScene.skyMap(),
                             .ior = water.ior,
                             .waveCount = drawnWaveCount(water),
                             .footprint = footprintOf(input.sample),
                             .normalMap = normalMapInputs(water, gpuScene.waterNormals(), input.time),
                             .underwater = isBelow,
                             .view = input.view};
    if (marchesBed) inputs.bed.emplace(WaterPass::Bed{heights.bed(), sceneRenderer.sunMaps(), sun.lit()});
    if (isCrossing) inputs.waterline = sideOfPixels;
    const Bounds slabBounds = waterBounds(water);
    Occlusion occlusion{occlusionPass, hiddenBlocks};
    const bool mayAsk = options.plan.allows(RuleId::cullHidden);
    occlusion.asks = mayAsk && !plan().rule(RuleId::waterHidden).applies; // that asks for all of them already
    const bool counts = (mayAsk || options.plan.allows(RuleId::waterHidden)) && !wantsRawValues(input.view);
    const bool culls = options.plan.allows(RuleId::cullChunks);
    if (!isCrossing && (culls || counts)) // a frame that shows both sides draws the surface twice, as it is
        inputs.culling.emplace(
            WaterGrid::Culling{main, plan().waterGrid, slabBounds, culls, counts ? &occlusion : nullptr});
    FrameStats::Pass& pass = context.beginPass(PassId::water, main, drawnSize);
    waterPass.draw(frame, waterGrid, options, inputs, pass);
    if (isCrossing) {
        inputs.bed.reset();
        inputs.aboveWater = nullptr;
        const WaterTargets::Side& below = targets.below();
        if (refracts) inputs.refraction = &below.refraction.target();
        inputs.refractionView = &below.refractionView;
        if (reflects) inputs.reflection = &below.reflection.target();
        inputs.reflectionView = &below.reflectionView;
        inputs.underwater = true;
        waterPass.draw(frame, waterGrid, options, inputs, pass);
    }
    if (mayAsk && counts) tellHidden(occlusion);
    if (!wantsRawValues(input.view)) context.check(PassId::water, frame);
}

void Renderer::State::drawGlow(const FrameInput& input)
{
    if (wantsRawValues(input.view)) return;
    gl::PassScope scope(context.profiler, passName(PassId::glow));
    frame.resolveDepth();
    const ivec2 size = plan()[PassId::glow].size;
    FrameStats::Pass& pass = context.beginPass(PassId::glow, main, size);
    glow = &glowPass.draw(waterGrid, options,
                          {.sceneDepth = frame.depth(),
                           .size = size,
                           .waveCount = drawnWaveCount(water),
                           .normalMap = normalMapInputs(water, gpuScene.waterNormals(), input.time),
                           .ifSeen = plan().rule(RuleId::waterHidden).applies ? &slab : nullptr},
                          pass);
    context.check(PassId::glow, *glow);
}

/// What is presented: the frame, or in a debug view the target that it shows.
const gl::Target& Renderer::State::selectShown(const FrameInput& input)
{
    const ivec2 size = input.size;
    // With raycast the target, if there is one, is that of what is seen from below.
    const bool refracts = plan()[PassId::refraction].wanted && plan().targetsBed;
    const bool reflects = plan()[PassId::reflection].wanted && plan().targetsMirror;
    const WaterTargets::Side& side = targets.first();
    switch (input.view) {
    case DebugView::sceneDepth: return debugCopy.depth(frame.depth(), size, main.nearPlane, main.farPlane);
    case DebugView::refractionColour:
        return refracts ? debugCopy.colour(side.refraction.target().colour(), size) : debugCopy.nothing(size);
    case DebugView::refractionDepth:
        return refracts ? debugCopy.depth(side.refraction.target().depth(), size, side.refractionView.nearPlane,
                                          side.refractionView.farPlane)
                        : debugCopy.nothing(size);
    case DebugView::reflection:
        return reflects ? debugCopy.colour(side.reflection.target().colour(), size) : debugCopy.nothing(size);
    case DebugView::caustics:
        return plan()[PassId::caustics].wanted ? debugCopy.colour(sun.caustics().colour(), size)
                                               : debugCopy.nothing(size);
    default: break;
    }
    // What was drawn smaller is upscaled as it is shown, after the tone curve.
    const bool isSmaller = drawnSize.x < size.x || drawnSize.y < size.y;
    return isSmaller ? frame : downsample.draw(frame, size);
}

void Renderer::State::present(const FrameInput& input)
{
    gl::PassScope scope(context.profiler, passName(PassId::present));
    frame.resolveColour();
    if (input.view == DebugView::sceneDepth) frame.resolveDepth();
    shown = &selectShown(input);
    if (input.sample > 0 && !options.stereo.isOn() && !wantsRawValues(input.view))
        shown = &accumulate.add(*shown, input.sample);
    const bool smooths = options.frame.antialiasing == FrameOptions::Antialiasing::fxaa && !wantsRawValues(input.view);
    display = &presentPass.draw(shown->colour(), glow ? &glow->colour() : nullptr, options.frame, input.view, smooths);
    if (smooths) display = &fxaa.draw(display->colour());
    if (display->size() != input.size) display = &upscale.draw(display->colour(), input.size, options.frame.upscaler);
    presented = presentedSize(input.size, options.stereo.output);
    context.check(PassId::present, *display);
}

const gl::Target& Renderer::State::displayed() const
{
    if (!display) throw Error("no frame has been rendered yet");
    return anaglyph ? *anaglyph : beside ? *beside : *display;
}

/// The radiance of the last frame, of its picture's size. In an upscaled frame nobody else needs it: made when it is
/// read.
const gl::Target& Renderer::State::linear()
{
    if (shown->size() == presented) return *shown;
    return upscale.drawLinear(shown->colour(), presented, options.frame, beside ? 2 : 1);
}

void Renderer::presentToWindow(ivec2 windowSize) const
{
    const gl::Framebuffer window = gl::Framebuffer::window(windowSize);
    state_->displayed().framebuffer().blitTo(window, {.filter = gl::Filter::linear});
    window.bind();
}

const gl::Framebuffer& Renderer::display() const { return state_->displayed().framebuffer(); }

Image Renderer::readDisplay() const { return readBytes(state_->displayed().framebuffer()); }

Image Renderer::readLinear() const
{
    const State& s = *state_;
    if (!s.shown) throw Error("no frame has been rendered yet");
    if (s.anaglyph)
        throw Error("an anaglyph is made of what a display shows and has no radiance; stereo.output = side_by_side or "
                    "pair has");
    return readFloats(state_->linear().framebuffer());
}

const HeightField* Renderer::heightField() const
{
    return state_->plan().raycastsBed && !state_->plan().targetsBed ? &state_->heights.bed().field() : nullptr;
}

std::optional<HeightMapPicture> Renderer::readMap(MapKind kind) const
{
    const FramePlan& plan = state_->context.stats.plan;
    if (!(kind == MapKind::bed ? plan.raycastsBed : plan.raycastsMirror)) return std::nullopt;
    return state_->heights.picture(kind);
}

std::size_t Renderer::geometryBytes() const { return state_->gpuScene.geometryBytes(); }

const View& Renderer::refractionView() const { return state_->targets.first().refractionView; }

std::optional<CausticsMap> Renderer::readCaustics() const
{
    const State& s = *state_;
    if (!s.shown || !s.plan()[PassId::caustics].wanted) return std::nullopt;
    return s.sun.readCaustics(s.water, s.light.sunDirectionBelow);
}

} // namespace tarn
