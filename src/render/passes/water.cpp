#include "render/passes/water.h"

#include "gl/state.h"

#include <vector>

namespace tarn {

void WaterPass::ensureGrid(int size)
{
    if (size == gridSize_) return;
    std::vector<vec2> vertices;
    vertices.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    for (int z = 0; z < size; ++z)
        for (int x = 0; x < size; ++x)
            vertices.emplace_back(2.0f * static_cast<float>(x) / static_cast<float>(size - 1) - 1.0f,
                                  2.0f * static_cast<float>(z) / static_cast<float>(size - 1) - 1.0f);
    std::vector<std::uint32_t> indices;
    indices.reserve(static_cast<std::size_t>(size - 1) * static_cast<std::size_t>(size - 1) * 6);
    for (int z = 0; z + 1 < size; ++z) {
        for (int x = 0; x + 1 < size; ++x) {
            const auto corner = static_cast<std::uint32_t>(z * size + x);
            const auto below = corner + static_cast<std::uint32_t>(size);
            for (const std::uint32_t index : {corner, below, corner + 1, corner + 1, below, below + 1})
                indices.push_back(index);
        }
    }
    vertices_ = gl::Buffer("water grid vertices");
    vertices_.upload(std::span<const vec2>(vertices));
    indices_ = gl::Buffer("water grid indices");
    indices_.upload(std::span<const std::uint32_t>(indices));
    grid_ = gl::VertexArray("water grid");
    grid_.attributes(vertices_, sizeof(vec2), {{0, 2, 0}});
    grid_.indices(indices_);
    gridSize_ = size;
    indexCount_ = static_cast<int>(indices.size());
}

namespace {

/// The number that water.frag's DEBUG_VIEW knows a view by; 0 is the picture itself.
int debugCode(DebugView view)
{
    switch (view) {
    case DebugView::fresnel: return 1;
    case DebugView::pathLength: return 2;
    case DebugView::positionW: return 3;
    case DebugView::normals: return 4;
    default: return 0;
    }
}

} // namespace

gl::Program& WaterPass::program(const Options& options, const Inputs& inputs)
{
    gl::Defines defines{{"DEBUG_VIEW", std::to_string(debugCode(inputs.view))}};
    if (inputs.underwater) defines.emplace_back("UNDERWATER", "1");
    if (inputs.refraction) defines.emplace_back("REFRACTION", "1");
    if (inputs.reflection) defines.emplace_back("REFLECTION", "1");
    if (options.refraction.method == RefractionOptions::Method::iterative) defines.emplace_back("ITERATIVE", "1");
    if (options.water.filterWaves) defines.emplace_back("FILTER_WAVES", "1");
    if (options.water.normals == WaterOptions::Normals::vertex) defines.emplace_back("VERTEX_NORMALS", "1");
    auto& program = programs_[defines];
    if (!program) program = shaders_.program("water", "passes/water.vert", "passes/water.frag", defines);
    return *program;
}

void WaterPass::draw(const gl::Target& frame, const Options& options, const Inputs& inputs,
                     FrameStats::Pass& stats)
{
    ensureGrid(options.water.gridSize);
    gl::apply({});
    frame.bind();
    gl::Program& p = program(options, inputs);
    p.use();
    p.texture("skyMap", inputs.skyMap);
    p.set("schlickExponent", options.water.schlickExponent);
    if (inputs.refraction) {
        const View& view = *inputs.refractionView;
        p.texture("refractionColour", inputs.refraction->colour());
        p.set("refractionViewFromWorld", view.viewFromWorld);
        p.set("refractionClipFromView", view.clipFromView);
        if (inputs.underwater) {
            p.set("refractionDistance", options.underwater.distance);
        } else {
            p.texture("refractionDepth", inputs.refraction->depth());
            p.set("worldFromRefractionView", glm::inverse(view.viewFromWorld));
            p.set("refractionNearFar", vec2(view.nearPlane, view.farPlane));
            p.set("refractionSteps", options.refraction.steps);
        }
    }
    if (inputs.reflection) {
        p.texture("reflectionColour", inputs.reflection->colour());
        p.set("reflectionClipFromWorld", inputs.reflectionView->clipFromWorld());
        p.set("reflectionDistance", inputs.underwater ? options.underwater.distance : options.reflection.distance);
    }
    grid_.drawIndexed(gl::Primitive::triangles, 0, indexCount_);
    stats.triangles += static_cast<std::size_t>(indexCount_) / 3;
    ++stats.drawCalls;
}

} // namespace tarn
