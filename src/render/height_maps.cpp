#include "render/height_maps.h"

#include "render/frame_light.h"

#include <algorithm>

namespace tarn {

namespace {

HeightsPass::Inputs bedInputs(const HeightMaps::Inputs& frame)
{
    const WaterBody& water = frame.water;
    HeightsPass::Inputs inputs;
    inputs.rect = {water.centre, 0.5f * water.extent + vec2(frame.options.heights.border)};
    inputs.lowest = frame.volume.lowest;
    inputs.highest = water.level + std::max(frame.options.refraction.clipOffset, totalAmplitude(water));
    inputs.light = lastingLight(frame.light);
    inputs.cull = frame.options.plan.allows(RuleId::cullChunks);
    return inputs;
}

AfloatHeightsPass::Inputs afloatInputs(const HeightMaps::Inputs& frame)
{
    const WaterBody& water = frame.water;
    AfloatHeightsPass::Inputs inputs;
    const vec2 half = 0.5f * water.extent;
    const vec2 low = glm::min(vec2(frame.bounds.lower.x, frame.bounds.lower.z), water.centre - half);
    const vec2 high = glm::max(vec2(frame.bounds.upper.x, frame.bounds.upper.z), water.centre + half);
    inputs.rect = {0.5f * (low + high), 0.5f * (high - low)};
    inputs.lowest = water.level - std::max(frame.options.reflection.clipOffset, totalAmplitude(water));
    inputs.highest = frame.volume.highest;
    inputs.light = lastingLight(frame.light);
    inputs.lit = frame.lit;
    inputs.cull = frame.options.plan.allows(RuleId::cullChunks);
    return inputs;
}

} // namespace

void HeightMaps::draw(const Inputs& frame, ScenePainter& painter, gl::UniformBuffer<blocks::ViewBlock>& viewBlock,
                      FrameStats::Pass& stats)
{
    const HeightsOptions& options = frame.options.heights;
    const ivec2 size(powerOfTwo(options.mapSize));
    const bool keeps = frame.options.plan.allows(RuleId::keepMaps);
    if (frame.plan.raycastsMirror) {
        using From = AfloatHeightsPass::From;
        const AfloatHeightsPass::Inputs inputs = afloatInputs(frame);
        if (!keeps || afloat_.isStale(inputs, options)) {
            for (const From from : {From::above, From::below}) {
                const View view = AfloatHeightsPass::view(inputs, from);
                viewBlock.update(tarn::viewBlock(view, size));
                afloat_.draw(from, view, painter, inputs, options, stats);
            }
            afloat_.readHeights(inputs);
        }
    }
    if (frame.plan.raycastsBed) {
        const HeightsPass::Inputs inputs = bedInputs(frame);
        if (!keeps || bed_.isStale(inputs, options)) {
            const View bed = HeightsPass::view(inputs, HeightsPass::Part::bed);
            viewBlock.update(tarn::viewBlock(bed, size));
            bed_.drawBed(bed, painter, inputs, options, stats);
            const View over = HeightsPass::view(inputs, HeightsPass::Part::over);
            viewBlock.update(tarn::viewBlock(over, size));
            bed_.countSolid(over, painter, options, stats);
            bed_.readHeights(inputs);
        }
    }
}

} // namespace tarn
