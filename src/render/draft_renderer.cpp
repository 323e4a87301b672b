#include "render/draft_renderer.h"

#include "gl/context.h"
#include "gl/fence.h"
#include "gl/state.h"
#include "render/bindings.h"
#include "render/frame_light.h"
#include "render/renderer.h"
#include "render/view.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace tarn {

namespace {

/// A processor that draws needs what it has for building programs, too.
constexpr float softwareScale = 0.5f, leastScale = 0.2f;
constexpr float longestMilliseconds = 120.0f;

gl::Texture whiteTexel()
{
    gl::Texture texture({.format = gl::Format::rgba8, .wrap = gl::Wrap::repeat}, "white");
    const std::vector<std::uint8_t> texel(4, 255);
    texture.upload(std::span<const std::uint8_t>(texel), 4);
    return texture;
}

gl::Texture blackSky()
{
    gl::Texture texture({.kind = gl::TextureKind::cube, .format = gl::Format::rgba16f}, "no sky yet");
    const std::vector<float> texel(3, 0.0f);
    for (int face = 0; face < 6; ++face) texture.upload(std::span<const float>(texel), 3, face);
    return texture;
}

} // namespace

DraftScene::DraftScene(const GpuScene& s) : scene(s.scene()), sky(s.sky()), skyMap(s.skyMap()), instances(s.instances())
{
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) meshes.push_back(s.buffers(static_cast<int>(i)));
    const Chunks& all = s.chunks();
    chunks.all.assign(all.all.begin(), all.all.begin() + static_cast<std::ptrdiff_t>(all.full));
    chunks.full = all.full;
    using MapUse = GpuScene::MapUse;
    for (const Material& material : scene.materials) {
        const int diffuse = material.diffuseMap, alpha = material.alphaMap;
        diffuseMaps.push_back(diffuse != noImage ? &s.texture(diffuse, MapUse::colour) : nullptr);
        alphaMaps.push_back(alpha != noImage ? &s.texture(alpha, MapUse::data) : nullptr);
    }
}

DraftRenderer::DraftRenderer()
    : shaders_(makeShaderLibrary()), opaque_(shaders_->program("draft", "passes/draft.vert", "passes/draft.frag")),
      cutOut_(shaders_->program("draft cut-out", "passes/draft.vert", "passes/draft.frag", {{"ALPHA_TEST", "1"}})),
      frameBlock_(static_cast<int>(BlockIndex::frame), "draft frame block"),
      viewBlock_(static_cast<int>(BlockIndex::view), "draft view block"),
      wavesBlock_(static_cast<int>(BlockIndex::waves), "draft waves block"), white_(whiteTexel()), present_(*shaders_),
      scale_(gl::capabilities().llvmpipe ? softwareScale : 1.0f)
{
    warmUp();
}

gl::Program& DraftRenderer::skyProgram(bool underwater)
{
    auto& program = sky_[underwater];
    const gl::Defines defines = underwater ? gl::Defines{{"UNDERWATER", "1"}} : gl::Defines{};
    if (!program) program = shaders_->program("draft sky", "passes/sky.vert", "passes/sky.frag", defines);
    return *program;
}

gl::Program& DraftRenderer::waterProgram(bool underwater)
{
    auto& program = water_[underwater];
    const gl::Defines defines = underwater ? gl::Defines{{"UNDERWATER", "1"}} : gl::Defines{};
    if (!program)
        program = shaders_->program("draft water", "passes/draft_water.vert", "passes/draft_water.frag", defines);
    return *program;
}

/// Draws nothing with every program that a view from the air needs, in the states that it will be used in.
void DraftRenderer::warmUp()
{
    const ivec2 size(16, 12);
    const Camera camera;
    frameBlock_.update({});
    wavesBlock_.update({});
    viewBlock_.update(viewBlock(mainView(camera, 1.0f), size));
    frame_.ensure({.size = size, .colours = {gl::Format::rgba16f}, .depth = gl::Format::depth24});
    frame_.bind();
    frame_.drawFramebuffer().clearColour(vec4(0.0f));
    frame_.drawFramebuffer().clearDepth();
    // Vertices in the layout of a mesh: the code that fetches them is built for it.
    const MeshBuffers buffers{std::make_shared<gl::Buffer>("draft warm-up"),
                              std::make_shared<gl::Buffer>("draft warm-up")};
    const std::vector<Vertex> corners(3);
    const std::vector<std::uint32_t> order{0, 1, 2};
    buffers.vertices->upload(std::span(corners));
    buffers.indices->upload(std::span(order));
    const gl::VertexArray triangle = meshVertexArray("draft warm-up", buffers);
    for (gl::Program* program : {opaque_.get(), cutOut_.get()}) {
        program->use();
        program->texture("diffuseMap", white_);
        if (program == cutOut_.get()) program->texture("alphaMap", white_);
        for (const gl::Cull cull : {gl::Cull::back, gl::Cull::none}) {
            gl::apply({.cull = cull});
            triangle.drawIndexed(gl::Primitive::triangles, 0, 3);
        }
    }
    const gl::Texture noSky = blackSky();
    drawSky(noSky, false);
    drawWater(noSky, false);
    FrameOptions options;
    present_.draw(frame_.colour(), nullptr, options, DebugView::final);
}

void DraftRenderer::show(const DraftScene& scene)
{
    placed_ = std::make_unique<Placed>(Placed{scene, {}, {}});
    for (std::size_t i = 0; i < scene.scene.meshes.size(); ++i)
        placed_->meshes.push_back(meshVertexArray(scene.scene.meshes[i].name, scene.meshes[i]));
    for (const Instance& instance : scene.instances)
        placed_->worldFromModelNormal.push_back(glm::transpose(glm::inverse(mat3(instance.worldFromModel))));
}

ivec2 DraftRenderer::sizeFor(ivec2 asked) const { return glm::max(ivec2(glm::round(scale_ * vec2(asked))), ivec2(1)); }

bool DraftRenderer::draw(const FrameRequest& request)
{
    const auto start = std::chrono::steady_clock::now();
    const ivec2 size = sizeFor(request.size);
    const DraftScene& shown = placed_->snapshot;
    const View view = mainView(request.camera, static_cast<float>(request.size.x) / static_cast<float>(request.size.y));
    const blocks::FrameBlock light = frameBlock(shown.scene, request.water, shown.sky, request.options);
    frameBlock_.update(light);
    wavesBlock_.update(wavesBlock(request.water, request.time));
    viewBlock_.update(viewBlock(view, size));
    frame_.ensure({.size = size, .colours = {gl::Format::rgba16f}, .depth = gl::Format::depth24});
    frame_.bind();
    frame_.drawFramebuffer().clearColour(vec4(0.0f));
    frame_.drawFramebuffer().clearDepth();
    report_.passes.clear();
    const bool isWet = light.hasWater > 0.5f;
    const bool underwater = isWet && request.camera.eye.y < request.water.level;
    drawScene(request, view);
    drawSky(shown.skyMap, underwater);
    if (isWet) drawWater(shown.skyMap, underwater);
    present_.draw(frame_.colour(), nullptr, request.options.frame, DebugView::final);
    if (gl::capabilities().llvmpipe) { // there the time between is the frame's; a card has its draft at full size
        gl::Fence drawn;
        drawn.place();
        drawn.wait();
        const std::chrono::duration<float, std::milli> spent = std::chrono::steady_clock::now() - start;
        scale_ = std::clamp(scale_ * std::sqrt(longestMilliseconds / spent.count()), leastScale, softwareScale);
    }
    return true;
}

void DraftRenderer::drawScene(const FrameRequest& request, const View& view)
{
    const DraftScene& shown = placed_->snapshot;
    const std::vector<Material>& materials = shown.scene.materials;
    FrameReport::Pass& pass = report_.of("draft");
    int lastState = -1;
    for (const Chunk* chunk : visibleChunks(shown.chunks, materials, view, {}, true, &request.water)) {
        const Material& material = materials[static_cast<std::size_t>(chunk->material)];
        const int state = (material.alphaTested ? 1 : 0) | (material.twoSided ? 2 : 0);
        gl::Program& program = material.alphaTested ? *cutOut_ : *opaque_;
        if (state != lastState) {
            gl::apply({.cull = material.twoSided ? gl::Cull::none : gl::Cull::back});
            program.use();
            lastState = state;
        }
        drawChunk(*chunk, material, program);
        pass.triangles += chunk->indexCount / 3;
        ++pass.drawCalls;
    }
}

void DraftRenderer::drawChunk(const Chunk& chunk, const Material& material, gl::Program& program)
{
    const DraftScene& shown = placed_->snapshot;
    const auto instance = static_cast<std::size_t>(chunk.instance);
    const auto index = static_cast<std::size_t>(chunk.material);
    program.texture("diffuseMap", shown.diffuseMaps[index] ? *shown.diffuseMaps[index] : white_);
    program.set("diffuseReflectance", material.diffuse);
    program.set("emittedRadiance", material.emissiveMap == noImage ? material.emissive : vec3(0.0f));
    if (material.alphaTested) {
        program.texture("alphaMap", shown.alphaMaps[index] ? *shown.alphaMaps[index] : white_);
        program.set("alpha", material.alpha);
        program.set("alphaCutoff", material.alphaCutoff);
    }
    program.set("worldFromModel", shown.instances[instance].worldFromModel);
    program.set("worldFromModelNormal", placed_->worldFromModelNormal[instance]);
    placed_->meshes[static_cast<std::size_t>(chunk.mesh)].drawIndexed(
        gl::Primitive::triangles, static_cast<int>(chunk.firstIndex), static_cast<int>(chunk.indexCount));
}

void DraftRenderer::drawSky(const gl::Texture& skyMap, bool underwater)
{
    gl::apply({.depthTest = gl::DepthTest::lessEqual, .depthWrite = false});
    gl::Program& program = skyProgram(underwater);
    program.use();
    if (!underwater) program.texture("skyMap", skyMap);
    triangle_.draw();
}

void DraftRenderer::drawWater(const gl::Texture& skyMap, bool underwater)
{
    gl::apply({.depthWrite = false, .blend = gl::Blend::premultiplied});
    gl::Program& program = waterProgram(underwater);
    program.use();
    program.texture("skyMap", skyMap);
    rectangle_.draw(gl::Primitive::triangleStrip, 0, 4);
}

} // namespace tarn
