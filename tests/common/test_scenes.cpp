#include "test_scenes.h"

#include <array>

namespace tarn::test {

namespace {

void addMesh(Scene& scene, Mesh mesh, int material)
{
    for (const Vertex& vertex : mesh.vertices) mesh.bounds.add(vertex.position);
    mesh.parts = {{material, 0, static_cast<std::uint32_t>(mesh.indices.size()), mesh.bounds}};
    addModel(scene, std::move(mesh));
}

void addQuad(Mesh& mesh, const std::array<vec3, 4>& corners, const vec3& normal)
{
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const vec3& corner : corners)
        mesh.vertices.push_back({corner, normal, vec4(1.0f, 0.0f, 0.0f, 1.0f), vec2(corner.x, corner.z), 0xffffffffu});
    for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + i);
}

} // namespace

int addMaterial(Scene& scene, const vec3& diffuse)
{
    Material material;
    material.name = "material " + std::to_string(scene.materials.size());
    material.diffuse = diffuse;
    scene.materials.push_back(material);
    return static_cast<int>(scene.materials.size()) - 1;
}

void addFloor(Scene& scene, float height, float edge, int material, int tiles)
{
    Mesh mesh;
    const float tile = edge / static_cast<float>(tiles);
    for (int j = 0; j < tiles; ++j) {
        for (int i = 0; i < tiles; ++i) {
            const float x = tile * static_cast<float>(i) - 0.5f * edge, z = tile * static_cast<float>(j) - 0.5f * edge;
            addQuad(mesh,
                    {vec3(x, height, z + tile), vec3(x + tile, height, z + tile), vec3(x + tile, height, z),
                     vec3(x, height, z)},
                    vec3(0.0f, 1.0f, 0.0f));
        }
    }
    addMesh(scene, std::move(mesh), material);
}

void addBox(Scene& scene, const vec3& lower, const vec3& upper, int material)
{
    Mesh mesh;
    const vec3 centre = 0.5f * (lower + upper);
    const vec3 half = 0.5f * (upper - lower);
    for (int axis = 0; axis < 3; ++axis) {
        for (const float sign : {-1.0f, 1.0f}) {
            vec3 n(0.0f), u(0.0f), v(0.0f);
            n[axis] = sign;
            u[(axis + 1) % 3] = 1.0f;
            v[(axis + 2) % 3] = sign; // u × v = n: counter-clockwise from outside
            addQuad(mesh,
                    {centre + half * (n - u - v), centre + half * (n + u - v), centre + half * (n + u + v),
                     centre + half * (n - u + v)},
                    n);
        }
    }
    addMesh(scene, std::move(mesh), material);
}

Scene rippledLake()
{
    Scene scene = flatLake(1.5f);
    Wave wave;
    wave.amplitude = 0.03f;
    wave.wavelength = 0.4f;
    wave.direction = 20.0f;
    scene.water.waves = {wave};
    scene.sun = Sun{normalize(vec3(1.0f, 1.0f, 0.5f)), vec3(8.0f), false};
    return scene;
}

Camera lookAcross()
{
    Camera camera;
    camera.eye = vec3(0.0f, 1.5f, 4.0f);
    camera.target = vec3(0.3f, -0.5f, -1.0f);
    return camera;
}

void addNormalMap(Scene& scene, int edge, const std::function<vec2(const vec2& uv)>& slope)
{
    Image image;
    image.name = "normal map";
    image.width = image.height = edge;
    image.channels = 3;
    for (int row = 0; row < edge; ++row)
        for (int column = 0; column < edge; ++column) {
            const vec2 uv((static_cast<float>(column) + 0.5f) / static_cast<float>(edge),
                          1.0f - (static_cast<float>(row) + 0.5f) / static_cast<float>(edge));
            const vec2 s = slope(uv);
            const vec3 n = glm::normalize(vec3(-s.x, 1.0f, -s.y));
            for (int c = 0; c < 3; ++c) image.floats.push_back(0.5f * n[c] + 0.5f);
        }
    scene.water.normalMap.image = static_cast<int>(scene.images.size());
    scene.images.push_back(std::move(image));
}

Mesh groundMesh(const std::function<float(float, float)>& height, int cells, float spacing, int strips)
{
    Mesh mesh;
    for (int j = 0; j <= cells; ++j) {
        for (int i = 0; i <= cells; ++i) {
            const float x = spacing * static_cast<float>(i), z = spacing * static_cast<float>(j),
                        step = 0.01f * spacing;
            const vec3 normal(height(x - step, z) - height(x + step, z), 2.0f * step,
                              height(x, z - step) - height(x, z + step));
            mesh.vertices.push_back({{x, height(x, z), z}, glm::normalize(normal), {1, 0, 0, 1}, {x, -z}});
            mesh.bounds.add(mesh.vertices.back().position);
        }
    }
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (cells + 1) + i); };
    for (int strip = 0; strip < strips; ++strip) {
        MeshPart part{0, static_cast<std::uint32_t>(mesh.indices.size()), 0, {}};
        for (int j = strip * cells / strips; j < (strip + 1) * cells / strips; ++j) {
            for (int i = 0; i < cells; ++i) {
                for (const std::uint32_t v :
                     {at(i, j), at(i, j + 1), at(i + 1, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)}) {
                    mesh.indices.push_back(v);
                    part.bounds.add(mesh.vertices[v].position);
                }
            }
        }
        part.indexCount = static_cast<std::uint32_t>(mesh.indices.size()) - part.firstIndex;
        mesh.parts.push_back(part);
    }
    return mesh;
}

void addModel(Scene& scene, Mesh mesh)
{
    Primitive primitive;
    primitive.name = mesh.name = "shape " + std::to_string(scene.meshes.size());
    primitive.material = mesh.parts.front().material;
    primitive.mesh = static_cast<int>(scene.meshes.size());
    scene.meshes.push_back(std::move(mesh));
    scene.primitives.push_back(primitive);
    Element element;
    element.name = element.shape = primitive.name;
    scene.elements.push_back(element);
}

Scene flatLake(float depth, float edge, float bedEdge)
{
    Scene scene;
    scene.name = "flat lake";
    scene.sky.kind = Sky::Kind::constant;
    scene.sky.radiance = vec3(1.0f);
    scene.water.present = true;
    scene.water.extent = vec2(edge);
    scene.water.absorption = vec3(0.0f);
    scene.water.colour = vec3(0.0f);
    addFloor(scene, -depth, bedEdge > 0.0f ? bedEdge : edge, addMaterial(scene, vec3(0.5f)));
    scene.cameras.emplace_back();
    return scene;
}

} // namespace tarn::test
