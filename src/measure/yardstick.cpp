#include "measure/yardstick.h"

#include "base/error.h"
#include "base/files.h"
#include "gl/api.h"
#include "gl/state.h"
#include "scene/scene.h"
#include "scene/scene_file.h"

#include <chrono>

namespace tarn {

namespace {

constexpr ivec2 size{1024, 768};
constexpr std::size_t triangleCount = 100352;

struct PlainVertex {
    vec3 position;
    vec2 uv;
};

/// From straight above, x to the right and z downward, so that the bounds fill the picture.
mat4 mapProjection(const Bounds& bounds)
{
    // Nearer than the near plane by a rounding would be cut off.
    const vec3 scale = vec3(2.0f, 1.99f, 2.0f) / bounds.extent();
    mat4 clipFromWorld(0.0f);
    clipFromWorld[0][0] = scale.x;
    clipFromWorld[2][1] = -scale.z;
    clipFromWorld[1][2] = -scale.y;
    clipFromWorld[3] =
        vec4(-scale.x * bounds.centre().x, scale.z * bounds.centre().z, scale.y * bounds.centre().y, 1.0f);
    return clipFromWorld;
}

std::filesystem::path terrainFile() { return projectRoot() / "assets" / "bench" / "terrain.toml"; }

} // namespace

Yardstick::Yardstick(gl::ShaderLibrary& shaders)
    : program_(shaders.program("yardstick", "passes/yardstick.vert", "passes/yardstick.frag")),
      vertices_("yardstick vertices"), indices_("yardstick indices"), mesh_("yardstick")
{
    const Scene scene = loadScene(terrainFile());
    if (scene.meshes.size() != 1 || scene.meshes.front().indices.size() != 3 * triangleCount ||
        scene.images.size() != 1)
        throw Error("{}: the yardstick is one mesh of {} triangles with one picture; make it anew with "
                    "make_terrain --out "
                    "assets/bench",
                    terrainFile().string(), triangleCount);
    uploadMesh(scene);
    uploadPicture(scene);
    program_->set("clipFromWorld", mapProjection(scene.meshes.front().bounds));
    target_.ensure({.size = size, .colours = {gl::Format::rgba8}, .depth = gl::Format::depth24});
}

void Yardstick::uploadMesh(const Scene& scene)
{
    const Mesh& mesh = scene.meshes.front();
    std::vector<PlainVertex> plain;
    plain.reserve(mesh.vertices.size());
    for (const Vertex& vertex : mesh.vertices) plain.push_back({vertex.position, vertex.uv});
    vertices_.upload(std::span<const PlainVertex>(plain));
    indices_.upload(std::span<const std::uint32_t>(mesh.indices));
    mesh_.attributes(vertices_, sizeof(PlainVertex),
                     {{0, 3, offsetof(PlainVertex, position)}, {1, 2, offsetof(PlainVertex, uv)}});
    mesh_.indices(indices_);
    indexCount_ = static_cast<int>(mesh.indices.size());
}

void Yardstick::uploadPicture(const Scene& scene)
{
    const Image& image = scene.images.front();
    const std::size_t row = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
    std::vector<std::uint8_t> upward; // OpenGL's rows go from bottom to top
    for (int y = image.height - 1; y >= 0; --y) {
        const auto first = image.bytes.begin() + static_cast<std::ptrdiff_t>(row) * y;
        upward.insert(upward.end(), first, first + static_cast<std::ptrdiff_t>(row));
    }
    picture_ = gl::Texture(
        {.format = gl::Format::rgba8, .size = {image.width, image.height}, .mipmaps = true, .wrap = gl::Wrap::repeat},
        "yardstick picture");
    picture_.upload(std::span<const std::uint8_t>(upward), image.channels);
    picture_.generateMipmaps();
}

void Yardstick::draw(int /*index*/)
{
    target_.bind();
    gl::apply({});
    target_.drawFramebuffer().clearColour(vec4(0.0f, 0.0f, 0.0f, 1.0f));
    target_.drawFramebuffer().clearDepth();
    program_->use();
    program_->texture("picture", picture_);
    mesh_.drawIndexed(gl::Primitive::triangles, 0, indexCount_);
    glFinish();
}

std::vector<BenchPass> Yardstick::drawPasses(int index)
{
    using Clock = std::chrono::steady_clock;
    const double cpuStart = processCpuSeconds();
    const Clock::time_point start = Clock::now();
    draw(index);
    const double wallMs = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    return {{"terrain", wallMs, 1e3 * (processCpuSeconds() - cpuStart), triangleCount}};
}

} // namespace tarn
