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

void SunPasses::begin(const Inputs& inputs, FrameCache& kept, bool draws)
{
    const Options& options = inputs.options;
    volume_ = sunVolume(inputs.water, inputs.bounds, inputs.light.sunDirection, options.sunlight);
    if (draws && !std::exchange(isPlaced_, true)) {
        usesCausticsAgain_ = inputs.plan[PassId::caustics].wanted && kept.areCausticsUsedAgain();
        if (!usesCausticsAgain_) region_ = causticsRegion(inputs.water, inputs.head, options.caustics);
    }
    block_.update(sunBlock(volume_, region_, options));
    lit_ = SceneVariant{};
    lit_.dithersCutOuts = dithersCutOuts(options.frame);
    lit_.shadows = inputs.plan[PassId::sunlight].wanted && options.sunlight.shadows;
    lit_.caustics = inputs.plan[PassId::caustics].wanted;
    lit_.depthFirst = options.frame.depthPrepass;
}

void SunPasses::draw(const Inputs& inputs, FrameContext& context)
{
    if (inputs.plan[PassId::sunlight].wanted) drawSunlight(inputs, context);
    if (!inputs.plan[PassId::caustics].wanted) return;
    const bool isThere = std::exchange(hasCaustics_, true);
    if (!isThere && usesCausticsAgain_)
        context.stats.plan[PassId::caustics].reason += " (caustics.interval: an earlier frame's)";
    else if (!isThere && !context.cache.caustics({sunlightInputs(inputs), region_, inputs.light, inputs.waves}))
        drawCaustics(inputs, context);
    context.sceneRenderer.setSunMaps({&sunlight_.depth(), &caustics_.target().colour(), inputs.options.sunlight.taps});
}

SunlightPass::Inputs SunPasses::sunlightInputs(const Inputs& inputs) const
{
    return {volume_,
            inputs.light.sunDirection,
            inputs.light.sunDirectionBelow,
            inputs.water.level,
            lit_.dithersCutOuts,
            inputs.light.hasWater > 0.5f,
            inputs.options.detail.pixels};
}

void SunPasses::drawSunlight(const Inputs& frame, FrameContext& context)
{
    gl::PassScope scope(context.profiler, passName(PassId::sunlight));
    FrameStats::Pass& pass = context.stats.of(passName(PassId::sunlight));
    const SunlightOptions& options = frame.options.sunlight;
    const SunlightPass::Inputs inputs = sunlightInputs(frame);
    const bool holds = !sunlight_.isStale(inputs, options);
    if (!std::exchange(hasSunlight_, true) && !context.cache.map(PassId::sunlight, holds)) {
        const bool cull = frame.options.plan.allows(RuleId::cullChunks);
        const auto draw = [&](SunLayer layer, std::size_t cascade, const vec3& toSun) {
            View view = sunView(volume_, layer, cascade, toSun, frame.water, inputs.hasWater);
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

void SunPasses::drawCaustics(const Inputs& inputs, FrameContext& context)
{
    gl::PassScope scope(context.profiler, passName(PassId::caustics));
    const CausticsOptions& options = inputs.options.caustics;
    const float cell = 2.0f * region_.rect.halfExtent.x / static_cast<float>(options.photons);
    const gl::Target& drawn =
        caustics_.draw(options,
                       {.sunDepth = sunlight_.depth(),
                        .shadows = inputs.options.sunlight.shadows,
                        .absorption = inputs.water.absorption,
                        .surfaceMovesSideways = movesSideways(inputs.water, inputs.light.sunDirection, cell),
                        .waveWeights = waveWeights(inputs.waves, drawnWaveCount(inputs.water), cell)},
                       context.stats.of(passName(PassId::caustics)));
    context.cache.causticsWereDrawn();
    context.check(PassId::caustics, drawn);
}

CausticsMap SunPasses::readCaustics(const WaterBody& water, const vec3& toSunBelow) const
{
    const gl::Texture& texture = caustics_.target().colour();
    CausticsMap map{.region = region_,
                    .resolution = texture.size().x,
                    .light = {},
                    .water = {water.centre, 0.5f * water.extent},
                    .level = water.level,
                    .toSun = toSunBelow};
    const std::vector<float> texels = texture.readBack();
    const auto channels = static_cast<std::size_t>(gl::channelCount(texture.format()));
    for (std::size_t i = 0; i + channels <= texels.size(); i += channels)
        map.light.emplace_back(texels[i], texels[i + 1], texels[i + 2]);
    return map;
}

} // namespace tarn
