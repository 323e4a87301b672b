#include "render/passes/heights_above_water.h"

#include "gl/state.h"
#include "render/frame_light.h"
#include "render/map_texture.h"

#include <algorithm>
#include <span>
#include <utility>

namespace tarn {

/// A texel of the heights.
struct AboveWaterHeightsPass::Column {
    float underside = nothingAboveWater, top = -nothingAboveWater, seenFromBelow = -nothingAboveWater, spare = 0.0f;
};

bool AboveWaterHeightsPass::isStale(const Inputs& inputs, const HeightsOptions& options) const
{
    return !drawn_ || !(drawn_->rect == inputs.rect) || drawn_->lowest != inputs.lowest ||
           drawn_->highest != inputs.highest || drawn_->lit.shadows != inputs.lit.shadows ||
           heights_.size().x != powerOfTwo(options.mapSize) || !sameLight(drawn_->light, inputs.light);
}

View AboveWaterHeightsPass::view(const Inputs& inputs, From from)
{
    View view = parallelView(inputs.rect, inputs.lowest, inputs.highest, vec2(0.0f), inputs.lowest);
    const float away = 1000.0f;
    view.eye = vec3(inputs.rect.centre.x, inputs.highest + away, inputs.rect.centre.y);
    view.clipPlane = vec4(0.0f, 1.0f, 0.0f, -inputs.lowest);
    if (from == From::above) return view;
    // Depth the other way round, and with it what is in front and which way triangles turn.
    view.eye.y = inputs.lowest - away;
    view.clipFromView = glm::scale(mat4(1.0f), vec3(1.0f, 1.0f, -1.0f)) * view.clipFromView;
    view.mirrored = false;
    return view;
}

void AboveWaterHeightsPass::draw(From from, const View& view, SceneRenderer& sceneRenderer, const Inputs& inputs,
                                 const HeightsOptions& options, FrameReport::Pass& stats)
{
    gl::Target& target = from == From::above ? above_ : below_;
    target.ensure({.size = ivec2(powerOfTwo(options.mapSize)),
                   .colours = {gl::Format::rgba16f, gl::Format::rgba16f},
                   .depth = gl::Format::depth32f,
                   .mipmaps = true});
    gl::apply({});
    target.bind();
    for (const int colour : {0, 1}) target.drawFramebuffer().clearColour(vec4(0.0f), colour);
    target.drawFramebuffer().clearDepth();
    SceneVariant variant = inputs.lit;
    variant.depthFirst = false; // the map must know cut-outs from solids
    variant.caustics = false;
    variant.forMap = true;
    variant.bothSides = true; // a bank is seen from below through the ground
    variant.sky = false;
    sceneRenderer.draw(view, variant, WaterCover{}, inputs.cull, stats);
    target.colour().generateMipmaps();
}

void AboveWaterHeightsPass::readHeights(const Inputs& inputs)
{
    const std::vector<float> depthsAbove = above_.depth().readBack(), depthsBelow = below_.depth().readBack();
    const std::vector<float> sides = below_.colour(1).readBack();
    std::vector<Column> columns(depthsAbove.size());
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const float side = sides[4 * i + 3]; // scene.frag: 1 a face's front, 1/2 its back, 0 nothing
        if (side < 0.25f) continue;
        columns[i].top = glm::mix(inputs.highest, inputs.lowest, depthsAbove[i]);
        columns[i].seenFromBelow = glm::mix(inputs.lowest, inputs.highest, depthsBelow[i]);
        columns[i].underside = side > 0.75f ? columns[i].seenFromBelow : -nothingAboveWater;
    }
    uploadHeights(std::move(columns), above_.size().x);
    rect_ = inputs.rect;
    highest_ = inputs.highest;
    drawn_ = inputs;
}

void AboveWaterHeightsPass::uploadHeights(std::vector<Column> columns, int resolution)
{
    const auto floatsOf = [](const std::vector<Column>& level) {
        static_assert(sizeof(Column) == 4 * sizeof(float));
        return std::span<const float>{&level.front().underside, 4 * level.size()};
    };
    const auto widen = [](Column& range, const Column& one) {
        range.underside = std::min(range.underside, one.underside);
        range.top = std::max(range.top, one.top);
    };
    heights_ = gl::Texture(
        {.format = gl::Format::rgba32f, .size = ivec2(resolution), .mipmaps = true, .filter = gl::Filter::nearest},
        "heights above water");
    heights_.upload(floatsOf(columns));
    for (int level = 1; level < heights_.levels(); ++level) {
        columns = coarserLevel(columns, resolution >> (level - 1), level == 1, Column{}, widen);
        heights_.upload(floatsOf(columns), 0, 0, level);
    }
}

const gl::Texture& AboveWaterHeightsPass::radiance(From from) const
{
    if (given_) return from == From::above ? given_->above : given_->below;
    return (from == From::above ? above_ : below_).colour(0);
}

void AboveWaterHeightsPass::take(const HeightMapPicture& picture)
{
    std::vector<Column> columns;
    highest_ = -nothingAboveWater;
    for (std::size_t i = 0; i < picture.heights.size(); i += 3) {
        columns.push_back({picture.heights[i], picture.heights[i + 1], picture.heights[i + 2]});
        highest_ = std::max(highest_, std::max(columns.back().top, columns.back().seenFromBelow));
    }
    uploadHeights(std::move(columns), picture.resolution);
    rect_ = {picture.centre, 0.5f * picture.extent};
    given_ = Given{mapColour(picture, 0, "heights from above"), mapColour(picture, 1, "heights from below")};
}

HeightMapPicture AboveWaterHeightsPass::picture() const
{
    HeightMapPicture picture;
    picture.kind = MapKind::aboveWater;
    picture.resolution = heights_.size().x;
    picture.centre = rect_.centre;
    picture.extent = 2.0f * rect_.halfExtent;
    const std::vector<float> columns = heights_.readBack();
    for (std::size_t i = 0; i < columns.size(); i += 4)
        picture.heights.insert(picture.heights.end(), &columns[i], &columns[i] + 3);
    picture.colours = {readMapColour(radiance(From::above)), readMapColour(radiance(From::below))};
    return picture;
}

} // namespace tarn
