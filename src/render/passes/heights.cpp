#include "render/passes/heights.h"

#include "gl/state.h"
#include "render/frame_light.h"
#include "render/map_texture.h"

namespace tarn {

bool HeightsPass::isStale(const Inputs& inputs, const HeightsOptions& options) const
{
    return !drawn_ || !(drawn_->rect == inputs.rect) || drawn_->lowest != inputs.lowest ||
           drawn_->highest != inputs.highest || field_.resolution != powerOfTwo(options.mapSize) ||
           !sameLight(drawn_->light, inputs.light);
}

View HeightsPass::view(const Inputs& inputs, Part part)
{
    View view = parallelView(inputs.rect, inputs.lowest, inputs.highest, vec2(0.0f), inputs.highest);
    view.eye = vec3(inputs.rect.centre.x, inputs.highest + 1000.0f, inputs.rect.centre.y);
    view.clipPlane =
        part == Part::bed ? vec4(0.0f, -1.0f, 0.0f, inputs.highest) : vec4(0.0f, 1.0f, 0.0f, -inputs.highest);
    return view;
}

void HeightsPass::drawBed(const View& view, SceneRenderer& sceneRenderer, const Inputs& inputs,
                          const HeightsOptions& options, FrameReport::Pass& stats)
{
    const int resolution = powerOfTwo(options.mapSize);
    map_.ensure({.size = ivec2(resolution),
                 .colours = {gl::Format::rgba16f, gl::Format::rgba16f},
                 .depth = gl::Format::depth32f,
                 .mipmaps = true});
    gl::apply({});
    map_.bind();
    map_.drawFramebuffer().clearColour(vec4(inputs.light.deepRadiance, 1.0f));
    map_.drawFramebuffer().clearColour(vec4(0.0f), 1);
    map_.drawFramebuffer().clearDepth();
    SceneVariant variant;
    variant.forMap = true;
    variant.sky = false;
    sceneRenderer.draw(view, variant, WaterCover{}, inputs.cull, stats);
    for (const int colour : {0, 1}) map_.colour(colour).generateMipmaps();
}

void HeightsPass::countSolid(const View& view, SceneRenderer& sceneRenderer, const HeightsOptions& options,
                             FrameReport::Pass& stats)
{
    solid_.ensure(
        {.size = ivec2(powerOfTwo(options.mapSize)), .colours = {gl::Format::r16f}, .filter = gl::Filter::nearest});
    solid_.bind();
    solid_.drawFramebuffer().clearColour(vec4(0.0f));
    SceneVariant count;
    count.countsFaces = true;
    count.sky = false;
    sceneRenderer.draw(view, count, WaterCover{}, false, stats);
}

void HeightsPass::readHeights(const Inputs& inputs)
{
    field_ = {inputs.rect, map_.size().x, {}, inputs.lowest};
    const std::vector<float> depths = map_.depth().readBack(), faces = solid_.colour().readBack();
    for (std::size_t i = 0; i < depths.size(); ++i)
        field_.heights.push_back(faces[i] > 0.5f ? inputs.highest : glm::mix(inputs.highest, inputs.lowest, depths[i]));
    uploadHeights();
    drawn_ = inputs;
}

void HeightsPass::uploadHeights()
{
    heights_ = gl::Texture(
        {.format = gl::Format::r32f, .size = ivec2(field_.resolution), .mipmaps = true, .filter = gl::Filter::nearest},
        "heights");
    heights_.upload(field_.heights);
    const std::vector<std::vector<float>> levels = largestHeights(field_);
    for (std::size_t i = 0; i < levels.size(); ++i) heights_.upload(levels[i], 0, 0, static_cast<int>(i) + 1);
}

void HeightsPass::take(const HeightMapPicture& picture)
{
    field_ = {{picture.centre, 0.5f * picture.extent}, picture.resolution, picture.heights, picture.lowest};
    uploadHeights();
    given_ = Given{mapColour(picture, 0, "heights radiance"), mapColour(picture, 1, "heights response")};
}

HeightMapPicture HeightsPass::picture() const
{
    HeightMapPicture picture;
    picture.kind = MapKind::bed;
    picture.resolution = field_.resolution;
    picture.centre = field_.rect.centre;
    picture.extent = 2.0f * field_.rect.halfExtent;
    picture.lowest = field_.lowest;
    picture.heights = field_.heights;
    picture.colours = {readMapColour(radiance()), readMapColour(response())};
    return picture;
}

} // namespace tarn
