#include "measure/water_quantities.h"

#include "base/error.h"
#include "render/view.h"

#include <algorithm>

namespace tarn {

namespace {

/// Calls a function with each pixel of a debug view that shows water.
template <typename Store> void readView(Renderer& renderer, const FrameInput& frame, DebugView view, const Store& store)
{
    FrameInput input = frame;
    input.view = view;
    renderer.render(input);
    const Image image = renderer.readLinear();
    for (std::size_t pixel = 0; 4 * pixel < image.floats.size(); ++pixel) {
        const float* value = &image.floats[4 * pixel];
        if (value[3] > 0.0f) store(pixel, vec4(value[0], value[1], value[2], value[3]));
    }
}

TexelFootprint footprintOf(const Renderer& renderer, const Options& options)
{
    if (const HeightField* field = renderer.heightField())
        return {vec3(0.0f), 0.0, static_cast<double>(field->texel())};
    const View& view = renderer.refractionView();
    // clipFromView[0][0] and [1][1] are 1 / tan of half the field of view, across and up: the lesser spans more.
    const float wider = std::min(view.clipFromView[0][0], view.clipFromView[1][1]);
    return {view.eye, 2.0 / (static_cast<double>(wider) * options.refraction.targetSize), 0.0};
}

} // namespace

double TexelFootprint::at(const vec3& point) const
{
    return edge + edgePerMetre * static_cast<double>(glm::distance(eye, point));
}

WaterQuantities::WaterQuantities(ivec2 pictureSize) : size(pictureSize)
{
    const auto count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    for (auto* flags : {&isWater, &hasSample, &mirrorsSky}) flags->assign(count, 0);
    for (auto* vectors : {&surface, &position, &picture, &mirrored}) vectors->assign(count, vec3(0.0f));
    for (auto* scalars : {&fresnel, &waterPath}) scalars->assign(count, 0.0f);
}

WaterQuantities readQuantities(Renderer& renderer, const Camera& camera, double time, ivec2 size)
{
    if (renderer.options().stereo.isOn()) throw Error("quantities are read for one eye; set stereo.output=off");
    WaterQuantities q(size);
    q.eye = camera.eye;
    q.reflects = renderer.options().water.reflects;
    FrameInput frame{camera, time, size};
    renderer.render(frame);
    q.display = renderer.readDisplay();
    q.linear = renderer.readLinear();
    q.caustics = renderer.readCaustics();
    frame.sameMoment = true;
    readView(renderer, frame, DebugView::positionU, [&](std::size_t pixel, const vec4& value) {
        q.isWater[pixel] = 1;
        q.surface[pixel] = vec3(value);
    });
    readView(renderer, frame, DebugView::positionW,
             [&](std::size_t pixel, const vec4& value) { q.position[pixel] = vec3(value); });
    readView(renderer, frame, DebugView::positionA, [&](std::size_t pixel, const vec4& value) {
        q.picture[pixel] = vec3(value);
        q.hasSample[pixel] = value.w > 0.75f;
    });
    readView(renderer, frame, DebugView::reflectionHit, [&](std::size_t pixel, const vec4& value) {
        q.mirrored[pixel] = vec3(value);
        q.mirrorsSky[pixel] = value.w > 1.5f;
    });
    readView(renderer, frame, DebugView::fresnel,
             [&](std::size_t pixel, const vec4& value) { q.fresnel[pixel] = value.x; });
    readView(renderer, frame, DebugView::pathLength,
             [&](std::size_t pixel, const vec4& value) { q.waterPath[pixel] = value.x; });
    if (const HeightField* field = renderer.heightField()) q.heights = *field;
    q.footprint = footprintOf(renderer, renderer.options());
    return q;
}

} // namespace tarn
