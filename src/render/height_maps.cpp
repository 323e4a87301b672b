#include "render/height_maps.h"

#include "base/log.h"
#include "render/frame_light.h"

#include <algorithm>

namespace tarn {

namespace {

HeightsPass::Inputs bedInputs(const HeightMaps::Inputs& frame)
{
    const WaterBody& water = frame.eye.water;
    HeightsPass::Inputs inputs;
    inputs.rect = {water.centre, 0.5f * water.extent + vec2(frame.eye.options.heights.border)};
    inputs.lowest = frame.volume.lowest;
    inputs.highest = water.level + std::max(frame.eye.options.refraction.clipOffset, totalAmplitude(water));
    inputs.light = lastingLight(frame.eye.light);
    inputs.cull = frame.eye.options.plan.allows(RuleId::cullChunks);
    return inputs;
}

AboveWaterHeightsPass::Inputs aboveWaterInputs(const HeightMaps::Inputs& frame)
{
    const WaterBody& water = frame.eye.water;
    AboveWaterHeightsPass::Inputs inputs;
    const vec2 half = 0.5f * water.extent;
    const vec2 low = glm::min(vec2(frame.eye.sceneBounds.lower.x, frame.eye.sceneBounds.lower.z), water.centre - half);
    const vec2 high = glm::max(vec2(frame.eye.sceneBounds.upper.x, frame.eye.sceneBounds.upper.z), water.centre + half);
    inputs.rect = {0.5f * (low + high), 0.5f * (high - low)};
    inputs.lowest = water.level - std::max(frame.eye.options.reflection.clipOffset, totalAmplitude(water));
    inputs.highest = frame.volume.highest;
    inputs.light = lastingLight(frame.eye.light);
    inputs.lit = frame.lit;
    inputs.cull = frame.eye.options.plan.allows(RuleId::cullChunks);
    return inputs;
}

MapLight mapLight(const blocks::FrameBlock& light)
{
    return {light.sunDirection, light.sunIrradiance, vec3(light.skyIrradiance[0]),
            light.waterLevel,   light.ior,           light.absorption};
}

/// What its colours hold cannot follow: the sun's direction in the bed's response, all light in what stands over the
/// water. Returns whether there was something to say.
bool sayOtherLight(const HeightMapPicture& map, const MapLight& now)
{
    if (!map.light) return false;
    const std::string others = map.light->difference(now);
    if (others.empty()) return false;
    log::warning("{}: {} changed since this map was made, and it shows the light of then; make it anew with tarn maps",
                 map.file.string(), others);
    return true;
}

} // namespace

void HeightMaps::draw(const Inputs& frame, SceneRenderer& sceneRenderer,
                      gl::UniformBuffer<blocks::ViewBlock>& viewBlock, FrameReport::Pass& stats)
{
    light_ = mapLight(frame.eye.light);
    const auto take = [this](auto& pass, const HeightMapPicture& picture) {
        if (!pass.isGiven()) pass.take(picture);
        if (!saidOther_.contains(picture.kind) && sayOtherLight(picture, light_)) saidOther_.insert(picture.kind);
    };
    if (frame.eye.plan.raycastsMirror) {
        if (const auto& given = frame.given.aboveWater.picture)
            take(aboveWater_, *given);
        else
            drawAboveWater(frame, sceneRenderer, viewBlock, stats);
    }
    if (frame.eye.plan.raycastsBed) {
        if (const auto& given = frame.given.bed.picture)
            take(bed_, *given);
        else
            drawBed(frame, sceneRenderer, viewBlock, stats);
    }
}

void HeightMaps::drawAboveWater(const Inputs& frame, SceneRenderer& sceneRenderer,
                                gl::UniformBuffer<blocks::ViewBlock>& viewBlock, FrameReport::Pass& stats)
{
    using From = AboveWaterHeightsPass::From;
    const HeightsOptions& options = frame.eye.options.heights;
    const AboveWaterHeightsPass::Inputs inputs = aboveWaterInputs(frame);
    if (frame.eye.options.plan.allows(RuleId::keepMaps) && !aboveWater_.isStale(inputs, options)) return;
    for (const From from : {From::above, From::below}) {
        const View view = AboveWaterHeightsPass::view(inputs, from);
        viewBlock.update(tarn::viewBlock(view, ivec2(powerOfTwo(options.mapSize))));
        aboveWater_.draw(from, view, sceneRenderer, inputs, options, stats);
    }
    aboveWater_.readHeights(inputs);
}

void HeightMaps::drawBed(const Inputs& frame, SceneRenderer& sceneRenderer,
                         gl::UniformBuffer<blocks::ViewBlock>& viewBlock, FrameReport::Pass& stats)
{
    const HeightsOptions& options = frame.eye.options.heights;
    const ivec2 size(powerOfTwo(options.mapSize));
    const HeightsPass::Inputs inputs = bedInputs(frame);
    if (frame.eye.options.plan.allows(RuleId::keepMaps) && !bed_.isStale(inputs, options)) return;
    const View bed = HeightsPass::view(inputs, HeightsPass::Part::bed);
    viewBlock.update(tarn::viewBlock(bed, size));
    bed_.drawBed(bed, sceneRenderer, inputs, options, stats);
    const View over = HeightsPass::view(inputs, HeightsPass::Part::over);
    viewBlock.update(tarn::viewBlock(over, size));
    bed_.countSolid(over, sceneRenderer, options, stats);
    bed_.readHeights(inputs);
}

HeightMapPicture HeightMaps::picture(MapKind kind) const
{
    HeightMapPicture picture = kind == MapKind::bed ? bed_.picture() : aboveWater_.picture();
    picture.light = light_;
    return picture;
}

} // namespace tarn
