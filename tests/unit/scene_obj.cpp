// What a sound OBJ file becomes. Bad ones: scene_obj_bad.cpp.
#include "base/log.h"
#include "scene/scene_file.h"
#include "temp_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace tarn::test {
namespace {

const char* const quad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

class ObjTest : public ::testing::Test {
protected:
    TempFolder folder;
    log::Capture log;

    Scene load(std::string_view text) { return loadScene(folder.file("test.obj", text)); }
    Mesh mesh(std::string_view text) { return load(text).meshes.at(0); }
    void expectNoWarnings() const { EXPECT_TRUE(log.messages().empty()) << log.messages().front().text; }
};

float area(const Mesh& mesh)
{
    float sum = 0.0f;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const vec3& a = mesh.vertices[mesh.indices[i]].position;
        sum += 0.5f * glm::length(glm::cross(mesh.vertices[mesh.indices[i + 1]].position - a,
                                             mesh.vertices[mesh.indices[i + 2]].position - a));
    }
    return sum;
}

vec3 normalAt(const Mesh& mesh, const vec3& position)
{
    for (const Vertex& vertex : mesh.vertices)
        if (glm::distance(vertex.position, position) < 1e-6f) return vertex.normal;
    ADD_FAILURE() << "no vertex there";
    return vec3(0.0f);
}

std::size_t verticesAt(const Mesh& mesh, const vec3& position)
{
    return static_cast<std::size_t>(std::count_if(mesh.vertices.begin(), mesh.vertices.end(), [&](const Vertex& v) {
        return glm::distance(v.position, position) < 1e-6f;
    }));
}

TEST_F(ObjTest, QuadBecomesTwoTriangles)
{
    const Mesh m = mesh(std::string(quad) + "f 1 2 3 4\n");
    EXPECT_EQ(m.indices.size(), 6u);
    EXPECT_EQ(m.vertices.size(), 4u);
    EXPECT_FLOAT_EQ(area(m), 1.0f);
    for (const Vertex& v : m.vertices) EXPECT_EQ(v.normal, vec3(0.0f, 0.0f, 1.0f));
    EXPECT_EQ(m.bounds.upper, vec3(1.0f, 1.0f, 0.0f));
    expectNoWarnings();
}

TEST_F(ObjTest, RelativeIndicesCountBackFromTheirLine)
{
    const Mesh m = mesh(std::string(quad) + "f -4 -3 -2\nv 5 5 5\nf -5 -3 -2\n");
    EXPECT_FLOAT_EQ(area(m), 1.0f);
    EXPECT_EQ(verticesAt(m, {5, 5, 5}), 0u);
    expectNoWarnings();
}

TEST_F(ObjTest, FacesMayPointForward)
{
    EXPECT_FLOAT_EQ(area(mesh(std::string("f 1 2 3 4\n") + quad)), 1.0f);
    expectNoWarnings();
}

TEST_F(ObjTest, ConcavePolygonsKeepTheirShape)
{
    // An arrow head (concave quad) of area 1 and an L of area 3, both ways round and tilted.
    EXPECT_NEAR(area(mesh("v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\nf 1 2 3 4\n")), 1.0f, 1e-6f);
    const std::string l = "v 0 0 0\nv 2 0 2\nv 2 1 2\nv 1 1 1\nv 1 2 1\nv 0 2 0\n";
    EXPECT_NEAR(area(mesh(l + "f 1 2 3 4 5 6\n")), 3.0f * std::sqrt(2.0f), 1e-5f);
    EXPECT_NEAR(area(mesh(l + "f 6 5 4 3 2 1\n")), 3.0f * std::sqrt(2.0f), 1e-5f);
    expectNoWarnings();
}

TEST_F(ObjTest, PolygonsOfManyCornersAreWhole)
{
    std::string text, face = "f";
    constexpr int corners = 700; // more than a byte counts
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * 3.14159265358979 * i / corners;
        text += fmt::format("v {} {} 0\n", std::cos(angle), std::sin(angle));
        face += fmt::format(" {}", i + 1);
    }
    const Mesh m = mesh(text + face + "\n");
    EXPECT_EQ(m.indices.size(), 3u * (corners - 2));
    EXPECT_NEAR(area(m), pi, 1e-3f);
}

TEST_F(ObjTest, WindingIsKept)
{
    const Mesh m = mesh(std::string(quad) + "f 4 3 2 1\n");
    for (const Vertex& v : m.vertices) EXPECT_EQ(v.normal, vec3(0.0f, 0.0f, -1.0f));
    const vec3& a = m.vertices[m.indices[0]].position;
    EXPECT_LT(glm::cross(m.vertices[m.indices[1]].position - a, m.vertices[m.indices[2]].position - a).z, 0.0f);
}

// A roof: two quads that meet at right angles along the ridge.
const std::string roof = "v -1 0 0\nv -1 0 1\nv 0 1 1\nv 0 1 0\nv 1 0 0\nv 1 0 1\n";

TEST_F(ObjTest, SmoothingGroupsShareNormals)
{
    const Mesh m = mesh(roof + "s 1\nf 1 2 3 4\nf 4 3 6 5\n");
    EXPECT_EQ(m.vertices.size(), 6u);
    EXPECT_LT(glm::distance(normalAt(m, {0, 1, 0}), vec3(0, 1, 0)), 1e-6f);
}

TEST_F(ObjTest, SmoothingOffAndDifferentGroupsAreCreased)
{
    for (const char* faces : {"f 1 2 3 4\nf 4 3 6 5\n", "s 1\ns off\nf 1 2 3 4\nf 4 3 6 5\n",
                              "s 1\nf 1 2 3 4\ns 2\nf 4 3 6 5\n", "s 1\nf 1 2 3 4\ns 0\nf 4 3 6 5\n"}) {
        const Mesh m = mesh(roof + faces);
        EXPECT_EQ(m.vertices.size(), 8u) << faces;
        EXPECT_EQ(verticesAt(m, {0, 1, 0}), 2u) << faces;
        EXPECT_NEAR(std::abs(normalAt(m, {0, 1, 0}).x), std::sqrt(0.5f), 1e-6f) << faces;
    }
}

TEST_F(ObjTest, NormalsInTheFileWin)
{
    const Mesh m = mesh(std::string(quad) + "vn 0 3 4\ns 1\nf 1//1 2//1 3//1 4//1\n");
    EXPECT_LT(glm::distance(m.vertices[0].normal, vec3(0, 0.6f, 0.8f)), 1e-6f);
}

TEST_F(ObjTest, NormalsWithoutDirectionAreComputed)
{
    const Mesh m = mesh(std::string(quad) + "vn 0 0 0\nf 1//1 2//1 3//1 4//1\n");
    for (const Vertex& v : m.vertices) EXPECT_EQ(v.normal, vec3(0.0f, 0.0f, 1.0f));
}

TEST_F(ObjTest, TangentsFollowU)
{
    const Mesh m = mesh(std::string(quad) + "vt 0 0\nvt 2 0\nvt 2 2\nvt 0 2\nf 1/1 2/2 3/3 4/4\n");
    for (const Vertex& v : m.vertices) {
        EXPECT_LT(glm::distance(vec3(v.tangent), vec3(1, 0, 0)), 1e-6f);
        EXPECT_EQ(v.tangent.w, 1.0f);
    }
    const Mesh mirrored = mesh(std::string(quad) + "vt 2 0\nvt 0 0\nvt 0 2\nvt 2 2\nf 1/1 2/2 3/3 4/4\n");
    for (const Vertex& v : mirrored.vertices) {
        EXPECT_LT(glm::distance(vec3(v.tangent), vec3(-1, 0, 0)), 1e-6f);
        EXPECT_EQ(v.tangent.w, -1.0f); // bitangent = -cross((0,0,1), (-1,0,0)) = +y
    }
}

TEST_F(ObjTest, VertexColoursAreKept)
{
    const Mesh m = mesh("v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 0.5\nv 0 0 1\nf 1 2 3\nf 1 2 4\n");
    for (const Vertex& v : m.vertices) {
        if (v.position.x == 1.0f) {
            EXPECT_EQ(v.colour, 0xff00ff00u);
        } else if (v.position.y == 1.0f) {
            EXPECT_EQ(v.colour, 0xff800000u);
        } else if (v.position.z == 1.0f) {
            EXPECT_EQ(v.colour, 0xffffffffu) << "no colour is white";
        } else {
            EXPECT_EQ(v.colour, 0xff0000ffu);
        }
    }
    expectNoWarnings();
}

TEST_F(ObjTest, RepeatedRecordsAreMerged)
{
    std::string text;
    for (int face = 0; face < 4; ++face) text += "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf -3//-1 -2//-1 -1//-1\n";
    EXPECT_EQ(mesh(text).vertices.size(), 3u);
}

TEST_F(ObjTest, LineEndingsByteOrderMarkAndContinuations)
{
    const auto same = [&](const std::string& text) {
        const Mesh m = mesh(text);
        EXPECT_EQ(m.indices.size(), 6u);
        EXPECT_FLOAT_EQ(area(m), 1.0f);
    };
    const std::string unix = std::string("# comment\n") + quad + "f 1 2 3 4";
    std::string dos, mac;
    for (const char c : unix) {
        if (c == '\n') dos += '\r';
        dos += c;
        mac += c == '\n' ? '\r' : c;
    }
    same(unix);
    same(dos + "\r\n");
    same(mac);
    same("\xef\xbb\xbf" + std::string(quad) + "f 1 2 3 4\n");
    same(std::string(quad) + "f 1 2 \\\n3 4\n");
    same(std::string(quad) + "f 1 2 \\\r\n 3 4 # a face\n");
    same("\n\n  \t\n" + std::string(quad) + "\tf\t1 2  3 4 \n");
    expectNoWarnings();
}

TEST_F(ObjTest, SpacesInNames)
{
    folder.file("two words.mtl", "newmtl old wood  \nKd 0.25 0.5 1\nnewmtl old stone\nKd 1 0 0\n");
    const Scene scene =
        loadScene(folder.file("a lake.obj", "mtllib two words.mtl\no my house\ng front door\n" + std::string(quad) +
                                                "usemtl old wood\nf 1 2 3\nusemtl old stone\nf 1 3 4\n"));
    ASSERT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.materials[0].name, "old wood");
    EXPECT_EQ(scene.materials[0].diffuse, vec3(0.25f, 0.5f, 1.0f));
    ASSERT_EQ(scene.meshes[0].parts.size(), 2u);
    EXPECT_EQ(scene.meshes[0].parts[1].material, 1);
    EXPECT_EQ(scene.name, "a lake");
    expectNoWarnings();
}

TEST_F(ObjTest, SeveralLibrariesInALine)
{
    folder.file("a.mtl", "newmtl a\nKd 1 0 0\n");
    folder.file("b.mtl", "newmtl b\nKd 0 1 0\n");
    const Scene scene = load("mtllib a.mtl b.mtl\n" + std::string(quad) + "usemtl b\nf 1 2 3\nusemtl a\nf 1 3 4\n");
    EXPECT_EQ(scene.materials.size(), 2u);
    expectNoWarnings();
}

/// A grid of n×n quads, two materials in stripes.
std::string gridText(int n)
{
    std::string text;
    char line[96];
    for (int z = 0; z <= n; ++z)
        for (int x = 0; x <= n; ++x) {
            std::snprintf(line, sizeof line, "v %d %.4f %d\n", x, 0.1 * std::sin(x * 0.1) * std::cos(z * 0.1), z);
            text += line;
        }
    text += "s 1\n";
    for (int z = 0; z < n; ++z) {
        text += z % 2 ? "usemtl a\n" : "usemtl b\n";
        for (int x = 0; x < n; ++x) {
            const int i = z * (n + 1) + x + 1;
            std::snprintf(line, sizeof line, "f %d %d %d %d\n", i, i + n + 1, i + n + 2, i + 1);
            text += line;
        }
    }
    return text;
}

TEST_F(ObjTest, ChunksAreCompactAndComplete)
{
    folder.file("ab.mtl", "newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 1 0\n");
    const Mesh m = mesh("mtllib ab.mtl\n" + gridText(200));
    ASSERT_EQ(m.indices.size(), 200u * 200 * 6);
    EXPECT_EQ(m.vertices.size(), 201u * 201);

    std::uint32_t next = 0;
    std::set<int> seen;
    for (std::size_t i = 0; i < m.parts.size(); ++i) {
        const MeshPart& part = m.parts[i];
        EXPECT_EQ(part.firstIndex, next) << "parts cover the indices without gaps";
        next += part.indexCount;
        EXPECT_LE(part.indexCount, 3u * 4096);
        if (i == 0 || m.parts[i - 1].material != part.material) {
            EXPECT_TRUE(seen.insert(part.material).second) << "a material's parts stand together";
        }
        Bounds bounds;
        for (std::uint32_t k = part.firstIndex; k < next; ++k) bounds.add(m.vertices[m.indices[k]].position);
        EXPECT_EQ(bounds.lower, part.bounds.lower);
        EXPECT_EQ(bounds.upper, part.bounds.upper);
        EXPECT_LE(part.bounds.extent().x, 101.0f) << "compact";
        EXPECT_LE(part.bounds.extent().z, 101.0f) << "compact";
    }
    EXPECT_EQ(next, m.indices.size());
    EXPECT_GE(m.parts.size(), 20u);
    for (const Vertex& v : m.vertices) EXPECT_GT(v.normal.y, 0.99f);
}

TEST_F(ObjTest, VertexOrderSuitsTheCache)
{
    const Mesh m = mesh(gridText(100));
    // A 16-entry FIFO, as meshoptimizer's analysis: a grid needs 0.5 transforms a triangle at best, 3 at
    // worst; row by row it would be about 1.
    std::vector<std::uint32_t> fifo;
    std::size_t misses = 0;
    for (const std::uint32_t index : m.indices) {
        if (std::find(fifo.begin(), fifo.end(), index) != fifo.end()) continue;
        ++misses;
        fifo.push_back(index);
        if (fifo.size() > 16) fifo.erase(fifo.begin());
    }
    EXPECT_LT(static_cast<double>(misses) / static_cast<double>(m.indices.size() / 3), 0.8);
}

TEST_F(ObjTest, MillionVertices)
{
    const Mesh m = mesh(gridText(1000));
    EXPECT_EQ(m.vertices.size(), 1001u * 1001);
    EXPECT_EQ(m.indices.size(), 6'000'000u);
}

TEST_F(ObjTest, BareObjGetsCamerasSunAndWater)
{
    const Scene scene = load("v 0 0 0\nv 10 0 0\nv 10 8 10\nv 0 8 10\nf 1 2 3 4\n");
    ASSERT_GE(scene.cameras.size(), 2u);
    EXPECT_EQ(scene.cameras[0].name, "overview");
    ASSERT_TRUE(scene.sun);
    EXPECT_TRUE(scene.sun->automatic);
    EXPECT_TRUE(scene.water.present);
    EXPECT_FLOAT_EQ(scene.water.level, 2.0f);
    EXPECT_EQ(scene.water.centre, vec2(5.0f));
    EXPECT_EQ(scene.water.extent, vec2(10.0f));
    ASSERT_EQ(scene.options.size(), 1u);
    EXPECT_EQ(scene.options[0].key, "frame.exposure");

    // All of the box is in every camera's view.
    const Bounds bounds = worldBounds(scene);
    for (const Camera& camera : scene.cameras) {
        const mat4 clipFromWorld = clipFromView(camera, 1.0f) * viewFromWorld(camera);
        for (int corner = 0; corner < 8; ++corner) {
            const vec4 clip = clipFromWorld * vec4(corner & 1 ? bounds.upper.x : bounds.lower.x,
                                                   corner & 2 ? bounds.upper.y : bounds.lower.y,
                                                   corner & 4 ? bounds.upper.z : bounds.lower.z, 1.0f);
            for (int i = 0; i < 3; ++i) EXPECT_LE(std::abs(clip[i]), clip.w) << camera.name;
        }
    }
}

TEST_F(ObjTest, WaterLevelOverrides)
{
    const auto file = folder.file("x.obj", std::string(quad) + "f 1 2 3 4\n");
    EXPECT_FLOAT_EQ(loadScene(file, {0.75f, nullptr}).water.level, 0.75f);
    // A flat plate has no inside to fill, unless asked to.
    const auto flat = folder.file("flat.obj", "v 0 0 0\nv 1 0 0\nv 1 0 1\nf 1 2 3\n");
    EXPECT_FALSE(loadScene(flat).water.present);
    EXPECT_TRUE(loadScene(flat, {0.5f, nullptr}).water.present);
}

TEST_F(ObjTest, ProgressRunsToTheEnd)
{
    SharedProgress progress;
    loadScene(folder.file("x.obj", std::string(quad) + "f 1 2 3 4\n"), {std::nullopt, &progress});
    EXPECT_EQ(progress.state().fraction, 1.0);
}

// Files are read side by side: what comes of them stands in the order of the models, whichever is done first.
TEST_F(ObjTest, ManyModelsKeepTheirOrderAndTheirMaterials)
{
    folder.file("m.mtl", "newmtl red\nKd 1 0 0\n");
    std::string text;
    constexpr int count = 12;
    for (int i = 0; i < count; ++i) {
        // Every third is without materials, so grey; every fifth is not there.
        const std::string model = fmt::format("v 0 0 {0}\nv 1 0 {0}\nv 1 1 {0}\n", i) +
                                  (i % 3 == 0 ? "" : "mtllib m.mtl\nusemtl red\n") + "f 1 2 3\n";
        if (i % 5 != 4) folder.file(fmt::format("{}.obj", i), model);
        text += fmt::format("[[models]]\nname = 'm{0}'\nfile = '{0}.obj'\n", i);
    }
    const Scene scene = loadScene(folder.file("many.toml", text));
    std::size_t next = 0;
    for (int i = 0; i < count; ++i) {
        const Model& model = scene.models[static_cast<std::size_t>(i)];
        if (i % 5 == 4) {
            EXPECT_EQ(model.mesh, -1);
            EXPECT_TRUE(log.contains(fmt::format("drawn without the model 'm{}'", i)));
            continue;
        }
        ASSERT_EQ(model.mesh, static_cast<int>(next++));
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(model.mesh)];
        EXPECT_EQ(mesh.name, model.name);
        EXPECT_FLOAT_EQ(mesh.bounds.lower.z, static_cast<float>(i));
        ASSERT_EQ(mesh.parts.size(), 1u);
        ASSERT_LT(static_cast<std::size_t>(mesh.parts[0].material), scene.materials.size());
        EXPECT_EQ(scene.materials[static_cast<std::size_t>(mesh.parts[0].material)].name, i % 3 == 0 ? "grey" : "red");
    }
    EXPECT_EQ(scene.meshes.size(), next);
}

} // namespace
} // namespace tarn::test
