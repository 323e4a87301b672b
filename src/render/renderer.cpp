#include "render/renderer.h"

#include "base/error.h"
#include "base/files.h"
#include "base/log.h"
#include "gl/workarounds.h"
#include "plan/refinement.h"
#include "render/bed_detail.h"
#include "render/bindings.h"
#include "render/eye_frame.h"
#include "render/frame_context.h"
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

/// The anisotropy of the scene's textures: the option's, where the driver can bear it.
float anisotropyFor(const FrameOptions& options) { return gl::avoidsAnisotropy() ? 1.0f : options.anisotropy; }

} // namespace

std::unique_ptr<gl::ShaderLibrary> makeShaderLibrary()
{
    return std::make_unique<gl::ShaderLibrary>(projectRoot() / "shaders", shaderBindings());
}

namespace {

PassInterface heightsInterface(const FramePlan& plan)
{
    const PassInterface bed = HeightsPass::interface(plan), above = AboveWaterHeightsPass::interface(plan);
    return {bed.reads | above.reads, bed.writes | above.writes};
}

/// Levels of detail leave something out, and approximately.
bool allowsDetail(const Options& options) { return options.plan.enabled && !options.plan.exact; }

} // namespace

PassInterface interfaceOf(PassId pass, const FramePlan& plan)
{
    switch (pass) {
    case PassId::sunlight: return SunlightPass::interface(plan);
    case PassId::caustics: return CausticsPass::interface(plan);
    case PassId::heights: return heightsInterface(plan);
    case PassId::refraction: return RefractionPass::interface(plan);
    case PassId::reflection: return ReflectionPass::interface(plan);
    case PassId::scene: return ScenePass::interface(plan);
    case PassId::water: return WaterPass::interface(plan);
    case PassId::glow: return GlowPass::interface(plan);
    case PassId::present: return PresentPass::interface(plan);
    }
    return {};
}

std::shared_ptr<GpuScene> uploadScene(const Scene& scene, const Options& options, Progress* progress)
{
    return std::make_shared<GpuScene>(scene, anisotropyFor(options.frame), progress);
}

struct Renderer::State {
    State(std::shared_ptr<GpuScene> uploaded, const Options& o, gl::ShaderLibrary& library, gl::Profiler& p)
        : scene(uploaded->scene()), options(o), water(scene.water), shaders(library),
          uploadedScene(std::move(uploaded)), sceneRenderer(gpuScene, shaders), context(p, sceneRenderer), sun(shaders),
          waterPass(shaders), waterlinePass(shaders), occlusionPass(shaders), glowPass(shaders), downsample(shaders),
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
    WaterlinePass waterlinePass;
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

    /// What the last frame presented.
    struct Shown {
        const gl::Target* linear = nullptr;   ///< before tone curve and upscaling
        const gl::Target* display = nullptr;  ///< the same as it is shown, of the picture's size
        const gl::Target* beside = nullptr;   ///< both eyes' displayed halves, or null for one eye
        const gl::Target* anaglyph = nullptr; ///< made of them, or null
        ivec2 size{1};                        ///< both eyes' beside each other, pixels
    };
    Shown shown;

    void takeOptions(const Options& wanted, const WaterBody& body);
    Shown drawEye(const FrameInput& input, const Camera& head);
    Shown drawBothEyes(const FrameInput& input);
    const gl::Target& displayed() const;
    const gl::Target& linear();
    EyeFrame beginEye(const FrameInput& input, const Camera& head);
    void drawMaps(const EyeFrame& eye);
    const gl::Texture* drawScene(const EyeFrame& eye);
    void drawWaterIfSeen(const EyeFrame& eye, const gl::Texture* waterline);
    void drawWater(const EyeFrame& eye, const gl::Texture* waterline);
    void reportHidden(const Occlusion& occlusion);
    const gl::Target* drawGlow(const EyeFrame& eye);
    const gl::Target& selectShown(const EyeFrame& eye);
    Shown present(const EyeFrame& eye, const gl::Target* glow);
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

const FrameReport& Renderer::render(const FrameInput& input)
{
    if (input.size.x < 1 || input.size.y < 1)
        throw Error("a picture of {}x{} pixels cannot be rendered", input.size.x, input.size.y);
    State& s = *state_;
    s.context.profiler.beginFrame();
    s.context.report.passes.clear();
    s.context.bad.clear();
    const FrameKey key = frameKeyOf(input, s.options, s.water, s.shaders.rebuilt());
    if (!s.context.checking && s.options.plan.allows(RuleId::keepFrame) && s.context.cache.holdsFrame(key)) {
        s.context.report.rule(RuleId::keepFrame) = {true, "nothing changed since the last frame"};
        s.context.profiler.endFrame();
        return s.context.report;
    }
    s.context.cache.beginFrame(key);
    s.sun.beginFrame();
    try {
        s.shown = s.options.stereo.isOn() ? s.drawBothEyes(input) : s.drawEye(input, input.camera);
    } catch (...) {
        s.context.cache.forget();
        throw;
    }
    s.context.cache.endFrame();
    s.context.profiler.endFrame();
    return s.context.report;
}

/// @param head what does not depend on the eye is drawn for this camera
Renderer::State::Shown Renderer::State::drawEye(const FrameInput& input, const Camera& head)
{
    const auto goOn = [&] {
        if (input.abandoned && *input.abandoned) throw FrameAbandoned{};
    };
    const EyeFrame eye = beginEye(input, head);
    if (eye.drawsLookups) drawMaps(eye);
    goOn();
    const gl::Texture* const waterline = drawScene(eye);
    goOn();
    drawWaterIfSeen(eye, waterline);
    goOn();
    const gl::Target* const glow = eye.plan[PassId::glow].wanted && !eye.showsRawValues ? drawGlow(eye) : nullptr;
    return present(eye, glow);
}

Renderer::State::Shown Renderer::State::drawBothEyes(const FrameInput& input)
{
    Shown both;
    for (const Eye eye : bothEyes) {
        const Camera camera = eyeCamera(input.camera, options.stereo, eye);
        both = drawEye({camera, input.time, input.size, input.view}, input.camera);
        gl::PassScope scope(context.profiler, passName(PassId::present));
        stereo.take(eye, *both.linear, *both.display);
    }
    both.linear = &stereo.linear();
    both.beside = &stereo.display();
    if (options.stereo.output == StereoOptions::Output::anaglyph) {
        gl::PassScope scope(context.profiler, passName(PassId::present));
        both.anaglyph = &stereo.drawAnaglyph();
    }
    return both;
}

EyeFrame Renderer::State::beginEye(const FrameInput& input, const Camera& head)
{
    hiddenBlocks.takeAnswers();
    const bool waterWasHidden = hiddenBlocks.wereAllHidden() &&
                                OcclusionPass::canAsk(waterBounds(water), input.camera.eye) && !context.checking &&
                                !input.sameMoment;
    EyeFrame eye = makeEyeFrame({scene, water, options, gpuScene.sky(), boxes, bounds,
                                 complexity ? &*complexity : nullptr, context.report.plan, waterWasHidden},
                                input, head);
    context.report.begin(eye.plan);
    targets.begin(eye);
    frameBlock.update(eye.light);
    wavesBlock.update(eye.waves);
    sceneRenderer.setWater(eye.light.hasWater > 0.5f ? &water : nullptr);
    sun.begin(eye, context.cache);
    return eye;
}

/// What the scene and the water look up that does not depend on the eye, or little.
void Renderer::State::drawMaps(const EyeFrame& eye)
{
    sun.draw(eye, context);
    if (eye.plan[PassId::heights].wanted) {
        gl::PassScope scope(context.profiler, passName(PassId::heights));
        heights.draw({eye, sun.volume(), sun.lit(), scene.maps}, sceneRenderer, context.viewBlock,
                     context.report.of(passName(PassId::heights)));
    }
    context.reportKept(RuleId::keepMaps, options.plan);
}

/// @returns which side of the surface each pixel is on, in a frame that shows both; else null
const gl::Texture* Renderer::State::drawScene(const EyeFrame& eye)
{
    gl::PassScope scope(context.profiler, passName(PassId::scene));
    const bool raw = eye.showsRawValues;
    const DebugView debugView = eye.input.view;
    frame.ensure({.size = eye.size,
                  .colours = {raw ? gl::Format::rgba32f : gl::Format::rgba16f},
                  .depth = gl::Format::depth24,
                  .samples = raw ? 1 : options.frame.samples()});

    ScenePass::Inputs inputs{
        .view = eye.view, .variant = sun.lit(), .cover = {}, .cull = options.plan.allows(RuleId::cullChunks)};
    if (isWaterView(debugView)) { // what hides the water is all that they need
        inputs.variant = SceneVariant{};
        inputs.variant.depthOnly = true;
    }
    inputs.variant.underwaterEye = eye.isBelow();
    inputs.variant.sunDisc = !eye.isBelow();
    if (raw) inputs.variant.dithersCutOuts = false; // no mean is taken
    inputs.variant.alphaToCoverage = frame.isMultisampled() && !inputs.variant.dithersCutOuts;
    inputs.variant.depthFirst &= !frame.isMultisampled();
    inputs.variant.debugNormals = debugView == DebugView::normals;
    inputs.variant.sky = !raw;
    if (eye.plan[PassId::water].wanted && eye.plan.side == WaterSide::above && debugView != DebugView::sceneDepth)
        inputs.cover = waterCover(water);
    FrameReport::Pass& pass = context.beginPass(PassId::scene, eye.view, eye.size);
    const gl::Texture* const waterline = eye.isCrossing() ? &waterlinePass.draw(eye.view, eye.size) : nullptr;
    if (!inputs.variant.depthOnly) inputs.variant.waterline = waterline;
    scenePass.draw(sceneRenderer, frame, inputs, pass);
    if (isWaterView(debugView)) frame.drawFramebuffer().clearColour(vec4(0.0f));
    if (!raw) context.check(PassId::scene, frame);
    return waterline;
}

/// In a frame that may hide the water, its own depth decides, on the GPU, whether anything is drawn here.
void Renderer::State::drawWaterIfSeen(const EyeFrame& eye, const gl::Texture* waterline)
{
    const bool isAsked = eye.plan.rule(RuleId::waterHidden).applies;
    if (isAsked) {
        gl::PassScope scope(context.profiler, passName(PassId::water));
        context.viewBlock.update(viewBlock(eye.view, eye.size));
        frame.bind();
        occlusionPass.ask(slab, waterBounds(water), eye.view.eye);
    }
    std::optional<gl::VisibilityQuery::Condition> ifSeen;
    if (isAsked) ifSeen.emplace(slab);
    if (eye.drawsLookups) targets.draw(eye, sun.lit(), context);
    if (eye.plan[PassId::water].wanted) drawWater(eye, waterline);
    if (isAsked) context.cache.forgetTargets(); // the GPU alone knows whether they were drawn
}

void Renderer::State::drawWater(const EyeFrame& eye, const gl::Texture* waterline)
{
    gl::PassScope scope(context.profiler, passName(PassId::water));
    const FramePlan& plan = eye.plan;
    const bool refracts = plan[PassId::refraction].wanted;
    const bool reflects = plan[PassId::reflection].wanted;
    const WaterTargets::Side& side = targets.first();
    WaterPass::Inputs inputs{.bed = {},
                             .aboveWater = plan.raycastsMirror ? &heights.aboveWater() : nullptr,
                             .refraction = refracts && plan.targetsBed ? &side.refraction.target() : nullptr,
                             .refractionView = &side.refractionView,
                             .reflection = reflects && plan.targetsMirror ? &side.reflection.target() : nullptr,
                             .reflectionView = &side.reflectionView,
                             .skyMap = gpuScene.skyMap(),
                             .ior = water.ior,
                             .waveCount = drawnWaveCount(water),
                             .footprint = footprintOf(eye.input.sample),
                             .normalMap = normalMapInputs(water, gpuScene.waterNormals(), eye.input.time),
                             .underwater = eye.isBelow(),
                             .view = eye.input.view};
    if (plan.raycastsBed) inputs.bed.emplace(WaterPass::Bed{heights.bed(), sceneRenderer.sunMaps(), sun.lit()});
    inputs.waterline = waterline;
    const Bounds slabBounds = waterBounds(water);
    Occlusion occlusion{occlusionPass, hiddenBlocks};
    const bool mayAsk = options.plan.allows(RuleId::cullHidden);
    occlusion.asks = mayAsk && !plan.rule(RuleId::waterHidden).applies; // that asks for all of them already
    const bool counts = (mayAsk || options.plan.allows(RuleId::waterHidden)) && !eye.showsRawValues;
    const bool culls = options.plan.allows(RuleId::cullChunks);
    if (!eye.isCrossing() && (culls || counts)) // a frame that shows both sides draws the surface twice, as it is
        inputs.culling.emplace(
            WaterGrid::Culling{eye.view, plan.waterGrid, slabBounds, culls, counts ? &occlusion : nullptr});
    FrameReport::Pass& pass = context.beginPass(PassId::water, eye.view, eye.size);
    waterPass.draw(frame, waterGrid, options, inputs, pass);
    if (eye.isCrossing()) {
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
    if (mayAsk && counts) reportHidden(occlusion);
    if (!eye.showsRawValues) context.check(PassId::water, frame);
}

/// Reports what was left out by the frame's own depth, or might have been.
void Renderer::State::reportHidden(const Occlusion& occlusion)
{
    RuleState& rule = context.report.rule(RuleId::cullHidden);
    rule.applies = occlusion.asked > 0;
    rule.why = rule.applies
                   ? fmt::format("{} of {} blocks in view were hidden in the last frame: drawn only if this one's "
                                 "depth shows some of their boxes",
                                 occlusion.asked, occlusion.drawn)
                   : "no block in view was hidden in the last frame";
}

const gl::Target* Renderer::State::drawGlow(const EyeFrame& eye)
{
    gl::PassScope scope(context.profiler, passName(PassId::glow));
    frame.resolveDepth();
    const ivec2 size = eye.plan[PassId::glow].size;
    FrameReport::Pass& pass = context.beginPass(PassId::glow, eye.view, size);
    const gl::Target& glow =
        glowPass.draw(waterGrid, options,
                      {.sceneDepth = frame.depth(),
                       .size = size,
                       .waveCount = drawnWaveCount(water),
                       .normalMap = normalMapInputs(water, gpuScene.waterNormals(), eye.input.time),
                       .ifSeen = eye.plan.rule(RuleId::waterHidden).applies ? &slab : nullptr},
                      pass);
    context.check(PassId::glow, glow);
    return &glow;
}

/// What is presented: the frame, or in a debug view the target that it shows.
const gl::Target& Renderer::State::selectShown(const EyeFrame& eye)
{
    const ivec2 size = eye.input.size;
    // With raycast the target, if there is one, is that of what is seen from below.
    const bool refracts = eye.plan[PassId::refraction].wanted && eye.plan.targetsBed;
    const bool reflects = eye.plan[PassId::reflection].wanted && eye.plan.targetsMirror;
    const WaterTargets::Side& side = targets.first();
    switch (eye.input.view) {
    case DebugView::sceneDepth: return debugCopy.depth(frame.depth(), size, eye.view.nearPlane, eye.view.farPlane);
    case DebugView::refractionColour:
        return refracts ? debugCopy.colour(side.refraction.target().colour(), size) : debugCopy.nothing(size);
    case DebugView::refractionDepth:
        return refracts ? debugCopy.depth(side.refraction.target().depth(), size, side.refractionView.nearPlane,
                                          side.refractionView.farPlane)
                        : debugCopy.nothing(size);
    case DebugView::reflection:
        return reflects ? debugCopy.colour(side.reflection.target().colour(), size) : debugCopy.nothing(size);
    case DebugView::caustics:
        return eye.plan[PassId::caustics].wanted ? debugCopy.colour(sun.caustics().colour(), size)
                                                 : debugCopy.nothing(size);
    case DebugView::final:
    case DebugView::fresnel:
    case DebugView::pathLength:
    case DebugView::positionW:
    case DebugView::normals:
    case DebugView::positionU:
    case DebugView::positionA:
    case DebugView::reflectionHit: break; // what scene and water have drawn
    }
    // What was drawn smaller is upscaled as it is shown, after the tone curve.
    const bool isSmaller = eye.size.x < size.x || eye.size.y < size.y;
    return isSmaller ? frame : downsample.draw(frame, size);
}

Renderer::State::Shown Renderer::State::present(const EyeFrame& eye, const gl::Target* glow)
{
    gl::PassScope scope(context.profiler, passName(PassId::present));
    const FrameInput& input = eye.input;
    frame.resolveColour();
    if (input.view == DebugView::sceneDepth) frame.resolveDepth();
    Shown result;
    result.linear = &selectShown(eye);
    if (input.sample > 0 && !options.stereo.isOn() && !eye.showsRawValues)
        result.linear = &accumulate.add(*result.linear, input.sample);
    const bool smooths = options.frame.antialiasing == FrameOptions::Antialiasing::fxaa && !eye.showsRawValues;
    result.display = &presentPass.draw(result.linear->colour(), glow ? &glow->colour() : nullptr, options.frame,
                                       input.view, smooths);
    if (smooths) result.display = &fxaa.draw(result.display->colour());
    if (result.display->size() != input.size)
        result.display = &upscale.draw(result.display->colour(), input.size, options.frame.upscaler);
    result.size = presentedSize(input.size, options.stereo.output);
    context.check(PassId::present, *result.display);
    return result;
}

const gl::Target& Renderer::State::displayed() const
{
    if (!shown.display) throw Error("no frame has been rendered yet");
    return shown.anaglyph ? *shown.anaglyph : shown.beside ? *shown.beside : *shown.display;
}

/// The radiance of the last frame, of its picture's size. In an upscaled frame nobody else needs it: made when it is
/// read.
const gl::Target& Renderer::State::linear()
{
    if (shown.linear->size() == shown.size) return *shown.linear;
    return upscale.drawLinear(shown.linear->colour(), shown.size, options.frame, shown.beside ? 2 : 1);
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
    if (!s.shown.linear) throw Error("no frame has been rendered yet");
    if (s.shown.anaglyph)
        throw Error("an anaglyph is made of what a display shows and has no radiance; stereo.output = side_by_side or "
                    "pair has");
    return readFloats(state_->linear().framebuffer());
}

const HeightField* Renderer::heightField() const
{
    const FramePlan& plan = state_->context.report.plan;
    return plan.raycastsBed && !plan.targetsBed ? &state_->heights.bed().field() : nullptr;
}

std::optional<HeightMapPicture> Renderer::readMap(MapKind kind) const
{
    const FramePlan& plan = state_->context.report.plan;
    if (!(kind == MapKind::bed ? plan.raycastsBed : plan.raycastsMirror)) return std::nullopt;
    return state_->heights.picture(kind);
}

std::size_t Renderer::geometryBytes() const { return state_->gpuScene.geometryBytes(); }

const View& Renderer::refractionView() const { return state_->targets.first().refractionView; }

std::optional<CausticsMap> Renderer::readCaustics() const
{
    const State& s = *state_;
    if (!s.shown.linear || !s.context.report.plan[PassId::caustics].wanted) return std::nullopt;
    return s.sun.readCaustics(s.water);
}

} // namespace tarn
