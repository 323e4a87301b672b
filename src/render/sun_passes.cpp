#include "render/sun_passes.h"

#include "optics/optics.h"
#include "render/bindings.h"
#include "render/unrolled.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tarn {

namespace {

/// Whether waves move the place where the sun's light enters by more than a quarter of a photon's cell.
bool movesSideways(const WaterBody& water, const vec3& toSun, float cellEdge)
{
    const float shear = std::sqrt(toSun.x * toSun.x + toSun.z * toSun.z) / toSun.y;
    return totalAmplitude(water) * shear > 0.25f * cellEdge;
}

/// What a lattice of cells of this edge (m) can carry of each wave; shorter ones fade, as they do in the picture.
std::vector<float> waveWeights(const blocks::WavesBlock& waves, int count, float cellEdge)
{
    std::vector<float> weights;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
        weights.push_back(optics::waveFilter(waves.waves[i], cellEdge));
    return weights;
}

} // namespace

SunPasses::SunPasses(gl::ShaderLibrary& shaders)
    : block_(static_cast<int>(BlockIndex::sun), "sun block"), caustics_(shaders)
{}

void SunPasses::begin(const EyeFrame& eye, const FrameCache& cache)
{
    const Options& options = eye.options;
    toSunBelow_ = eye.light.sunDirectionBelow;
    volume_ = sunVolume(eye.water, eye.sceneBounds, eye.light.sunDirection, options.sunlight);
    if (eye.drawsLookups && !std::exchange(isPlaced_, true)) {
        usesCausticsAgain_ =
            eye.plan[PassId::caustics].wanted && cache.mayReuse(PassId::caustics, eye.head, WaterSide::above);
        if (!usesCausticsAgain_) region_ = causticsRegion(eye.water, eye.head, options.caustics);
    }
    block_.update(sunBlock(volume_, region_, options));
    lit_ = SceneVariant{};
    lit_.dithersCutOuts = dithersCutOuts(options.frame);
    lit_.shadows = eye.plan[PassId::sunlight].wanted && options.sunlight.shadows;
    lit_.caustics = eye.plan[PassId::caustics].wanted;
    lit_.depthFirst = options.frame.depthPrepass;
}

void SunPasses::draw(const EyeFrame& eye, FrameContext& context)
{
    if (eye.plan[PassId::sunlight].wanted) drawSunlight(eye, context);
    if (!eye.plan[PassId::caustics].wanted) return;
    const CausticsKey key{sunlightInputs(eye), region_, eye.light, eye.waves};
    if (std::exchange(hasCaustics_, true)) {
        // They are the other eye's, too.
    } else if (usesCausticsAgain_) {
        context.cache.noteReuse(PassId::caustics, eye.head, WaterSide::above);
        context.report.noteReused(PassId::caustics);
    } else if (eye.options.plan.allows(RuleId::keepMaps) && context.cache.holdsCaustics(key)) {
        context.noteKept(PassId::caustics);
    } else {
        drawCaustics(eye, key, context);
    }
    context.sceneRenderer.setSunMaps({&sunlight_.depth(), &caustics_.target().colour(), eye.options.sunlight.taps});
}

SunlightPass::Inputs SunPasses::sunlightInputs(const EyeFrame& eye) const
{
    return {volume_,
            eye.light.sunDirection,
            eye.light.sunDirectionBelow,
            eye.water.level,
            lit_.dithersCutOuts,
            eye.light.hasWater > 0.5f,
            eye.options.detail.pixels};
}

void SunPasses::drawSunlight(const EyeFrame& eye, FrameContext& context)
{
    gl::PassScope scope(context.profiler, passName(PassId::sunlight));
    FrameReport::Pass& pass = context.report.of(passName(PassId::sunlight));
    const SunlightOptions& options = eye.options.sunlight;
    const SunlightPass::Inputs inputs = sunlightInputs(eye);
    const bool isThere = std::exchange(hasSunlight_, true);
    if (!isThere && eye.options.plan.allows(RuleId::keepMaps) && !sunlight_.isStale(inputs, options)) {
        context.noteKept(PassId::sunlight);
    } else if (!isThere) {
        const bool cull = eye.options.plan.allows(RuleId::cullChunks);
        const auto draw = [&](SunLayer layer, std::size_t cascade, const vec3& toSun) {
            View view = sunView(volume_, layer, cascade, toSun, eye.water, inputs.hasWater);
            // What clears a surface by the bias must still clear it.
            view.geometryError = std::min(geometryErrorOf(view, ivec2(options.mapSize), inputs.detail),
                                          0.5f * shadowBias(volume_, cascade, options));
            context.viewBlock.update(viewBlock(view, ivec2(options.mapSize)));
            sunlight_.draw(layer, cascade, view, context.sceneRenderer, inputs, options, cull, pass);
        };
        for (std::size_t cascade = 0; cascade < volume_.cascades.size(); ++cascade)
            draw(SunLayer::aboveWater, cascade, inputs.toSun);
        draw(SunLayer::submerged, 0, inputs.toSunBelow);
        sunlight_.keep(inputs, options);
    }
    context.sceneRenderer.setSunMaps({&sunlight_.depth(), nullptr, options.taps});
}

void SunPasses::drawCaustics(const EyeFrame& eye, const CausticsKey& key, FrameContext& context)
{
    gl::PassScope scope(context.profiler, passName(PassId::caustics));
    const CausticsOptions& options = eye.options.caustics;
    const float cell = 2.0f * region_.rect.halfExtent.x / static_cast<float>(options.photons);
    const gl::Target& drawn =
        caustics_.draw(options,
                       {.sunDepth = sunlight_.depth(),
                        .shadows = eye.options.sunlight.shadows,
                        .absorption = eye.water.absorption,
                        .surfaceMovesSideways = movesSideways(eye.water, eye.light.sunDirection, cell),
                        .waveWeights = waveWeights(eye.waves, drawnWaveCount(eye.water), cell)},
                       context.report.of(passName(PassId::caustics)));
    context.cache.causticsWereDrawn(key);
    context.check(PassId::caustics, drawn);
}

CausticsMap SunPasses::readCaustics(const WaterBody& water) const
{
    const gl::Texture& texture = caustics_.target().colour();
    CausticsMap map{.region = region_,
                    .resolution = texture.size().x,
                    .light = {},
                    .water = {water.centre, 0.5f * water.extent},
                    .level = water.level,
                    .toSun = toSunBelow_};
    const std::vector<float> texels = texture.readBack();
    const auto channels = static_cast<std::size_t>(gl::channelCount(texture.format()));
    for (std::size_t i = 0; i + channels <= texels.size(); i += channels)
        map.light.emplace_back(texels[i], texels[i + 1], texels[i + 2]);
    return map;
}

} // namespace tarn
