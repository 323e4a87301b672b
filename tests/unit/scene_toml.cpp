// Scene files: what each table becomes. Bad ones: scene_toml_bad.cpp; saving: scene_save.cpp.
#include "base/log.h"
#include "scene/scene_file.h"
#include "temp_folder.h"

#include <cmath>

namespace tarn::test {
namespace {

const std::string bed = "[[primitives]]\nname = 'bed'\nkind = 'plane'\n";

class TomlTest : public ::testing::Test {
protected:
    TempFolder folder;
    log::Capture log;

    Scene load(const std::string& text) { return loadScene(folder.file("test.toml", text)); }
};

TEST_F(TomlTest, OnePlaneIsAScene)
{
    const Scene scene = load(bed);
    EXPECT_EQ(scene.name, "test");
    EXPECT_EQ(flatten(scene).size(), 1u);
    EXPECT_FALSE(scene.sun);
    EXPECT_EQ(scene.sky.kind, Sky::Kind::daylight);
    EXPECT_FALSE(scene.water.present);
    EXPECT_EQ(scene.cameras.size(), 3u);
    EXPECT_TRUE(log.messages().empty());
}

TEST_F(TomlTest, Sun)
{
    const auto sun = [&](const std::string& keys) { return load(bed + "[sun]\n" + keys).sun.value(); };
    const Sun low = sun("elevation = 30\nazimuth = 90.0\n");
    EXPECT_LT(glm::distance(low.direction, vec3(0.0f, 0.5f, std::sqrt(0.75f))), 1e-6f);
    EXPECT_TRUE(low.automatic);
    EXPECT_LT(glm::distance(sun("direction = [0, 2, 0]").direction, vec3(0, 1, 0)), 1e-6f);
    EXPECT_TRUE(sun("irradiance = 'auto'").automatic);
    EXPECT_EQ(sun("irradiance = 5").irradiance, vec3(5.0f));
    EXPECT_FALSE(sun("irradiance = [1, 2.5, 3]").automatic);
    EXPECT_EQ(sun("irradiance = [1, 2.5, 3]").irradiance, vec3(1.0f, 2.5f, 3.0f));
}

TEST_F(TomlTest, WaterAndWaves)
{
    const WaterBody water = load(bed + R"(
        [water]
        level = -0.5
        centre = [1, 2]
        extent = 30
        ior = 1.31
        absorption = [0.4, 0.1, 0.05]
        colour = 0.25
        [[water.waves]]
        amplitude = 0.1
        wavelength = 3
        direction = 90
        phase = 180
        period = 2
        [[water.waves]]
    )")
                                .water;
    EXPECT_TRUE(water.present);
    EXPECT_EQ(water.level, -0.5f);
    EXPECT_EQ(water.centre, vec2(1.0f, 2.0f));
    EXPECT_EQ(water.extent, vec2(30.0f));
    EXPECT_EQ(water.ior, 1.31f);
    EXPECT_EQ(water.absorption, vec3(0.4f, 0.1f, 0.05f));
    EXPECT_EQ(water.colour, vec3(0.25f));
    ASSERT_EQ(water.waves.size(), 2u);
    EXPECT_FLOAT_EQ(water.waves[0].direction, pi / 2.0f);
    EXPECT_FLOAT_EQ(water.waves[0].phase, pi);
    EXPECT_EQ(water.waves[0].period, 2.0f);
    EXPECT_EQ(water.waves[1].wavelength, Wave().wavelength);
}

TEST_F(TomlTest, OptionsAreFlattened)
{
    const Scene scene = load(bed + R"(
        [options]
        frame.exposure = 0.1
        refraction = { steps = 3, method = "planar" }
        "water.enabled" = true
        a.b = [1, 2.5, 3]
    )");
    std::map<std::string, std::string> options;
    for (const auto& option : scene.options) options[option.key] = option.value;
    EXPECT_EQ(options, (std::map<std::string, std::string>{{"frame.exposure", "0.1"},
                                                           {"refraction.steps", "3"},
                                                           {"refraction.method", "planar"},
                                                           {"water.enabled", "true"},
                                                           {"a.b", "1,2.5,3"}}));
    for (const auto& option : scene.options) {
        if (option.key == "frame.exposure") {
            EXPECT_CONTAINS(option.origin, "test.toml:6");
        }
    }
}

TEST_F(TomlTest, MaterialsAndOverrides)
{
    folder.file("x.mtl", "newmtl own\nKd 1 0 0\n");
    folder.file("x.obj", "mtllib x.mtl\nusemtl own\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Scene scene = load(R"(
        [[materials]]
        name = "gold"
        diffuse = [1, 0.8, 0.1]
        specular = 0.5
        shininess = 200
        emissive = [0, 0, 2]
        two_sided = true
        [[models]]
        name = "as it is"
        file = "x.obj"
        [[models]]
        name = "gilded"
        file = "x.obj"
        material = "gold"
        [[primitives]]
        name = "ball"
        kind = "sphere"
        material = "gold"
    )");
    const auto materialOf = [&](int mesh) {
        return scene.materials[static_cast<std::size_t>(scene.meshes[static_cast<std::size_t>(mesh)].parts[0].material)]
            .name;
    };
    ASSERT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(materialOf(scene.models[0].mesh), "own");
    EXPECT_EQ(materialOf(scene.models[1].mesh), "gold");
    EXPECT_EQ(materialOf(scene.primitives[0].mesh), "gold");
    EXPECT_EQ(scene.materials[0].specular, vec3(0.5f));
    EXPECT_EQ(scene.materials[0].emissive, vec3(0.0f, 0.0f, 2.0f));
    EXPECT_TRUE(scene.materials[0].twoSided);
}

TEST_F(TomlTest, ModelsShareTheirLibrary)
{
    folder.file("x.mtl", "newmtl a\nKd nan 0 0\nnewmtl b\n");
    folder.file("x.obj", "mtllib x.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder.file("y.obj", "mtllib ./x.mtl\nusemtl b\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Scene scene = load("[[models]]\nname = 'x'\nfile = 'x.obj'\n[[models]]\nname = 'y'\nfile = 'y.obj'\n");
    EXPECT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.meshes[1].parts[0].material, 1);
    EXPECT_EQ(log.messages().size(), 1u) << "and warns once";
}

TEST_F(TomlTest, ElementsNest)
{
    const Scene scene = load(bed + R"(
        [[elements]]
        name = "group"
        translation = [1, 0, 0]
        [[elements.children]]
        shape = "bed"
        scale = 2
        [[elements.children]]
        shape = "bed"
        rotation = [0, 90, 0]
        visible = false
    )");
    ASSERT_EQ(scene.elements.size(), 1u);
    ASSERT_EQ(scene.elements[0].children.size(), 2u);
    EXPECT_FLOAT_EQ(scene.elements[0].children[1].rotation.y, pi / 2.0f);
    ASSERT_EQ(flatten(scene).size(), 1u);
    EXPECT_FLOAT_EQ(worldBounds(scene).upper.x, 2.0f);
}

TEST_F(TomlTest, AMissingModelAmongOthersIsAWarning)
{
    const Scene scene = load(bed + "[[models]]\nname = 'trees'\nfile = 'none.obj'\n");
    EXPECT_EQ(flatten(scene).size(), 1u);
    EXPECT_TRUE(log.contains("none.obj: no such file; check the path; drawn without the model 'trees'"));
}

TEST_F(TomlTest, AMissingSkyPictureIsAWarning)
{
    const Scene scene = load(bed + "[sky]\nkind = 'picture'\nfile = 'none.exr'\n");
    EXPECT_EQ(scene.sky.kind, Sky::Kind::daylight);
    EXPECT_TRUE(log.contains("test.toml:6"));
}

TEST_F(TomlTest, SkyPictureOfAWrongShapeIsAWarning)
{
    Image image;
    image.width = 5;
    image.height = 3;
    image.channels = 3;
    image.bytes.resize(image.size());
    writeImage(folder.path() / "sky.png", image);
    load(bed + "[sky]\nkind = 'picture'\nfile = 'sky.png'\n");
    EXPECT_TRUE(log.contains("5x3 pixels is neither"));
}

TEST_F(TomlTest, WindowsTextWithByteOrderMark)
{
    EXPECT_EQ(load("\xef\xbb\xbf[[primitives]]\r\nname = 'b'\r\nkind = 'box'\r\n").primitives.size(), 1u);
}

// ---- primitives

float surfaceArea(const Mesh& mesh)
{
    float sum = 0.0f;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vertex &a = mesh.vertices[mesh.indices[i]], &b = mesh.vertices[mesh.indices[i + 1]],
                     &c = mesh.vertices[mesh.indices[i + 2]];
        const vec3 normal = glm::cross(b.position - a.position, c.position - a.position);
        EXPECT_GT(glm::dot(normal, a.normal), 0.0f) << "counter-clockwise from where the normals point";
        sum += 0.5f * glm::length(normal);
    }
    return sum;
}

TEST_F(TomlTest, PlaneBoxAndSphere)
{
    const Scene scene = load(R"(
        [[primitives]]
        name = "plane"
        kind = "plane"
        size = [4, 1, 6]
        segments = 3
        uv_scale = [2, 3]
        [[primitives]]
        name = "box"
        kind = "box"
        size = [1, 2, 3]
        [[primitives]]
        name = "sphere"
        kind = "sphere"
        size = [2, 2, 2]
    )");
    const Mesh& plane = scene.meshes[0];
    EXPECT_NEAR(surfaceArea(plane), 24.0f, 1e-4f);
    EXPECT_EQ(plane.indices.size(), 3u * 18);
    for (const Vertex& v : plane.vertices) {
        EXPECT_EQ(v.normal, vec3(0, 1, 0));
        EXPECT_LT(glm::distance(vec3(v.tangent), vec3(1, 0, 0)), 1e-6f);
        EXPECT_NEAR(v.uv.x, 2.0f * (v.position.x / 4.0f + 0.5f), 1e-5f);
        EXPECT_NEAR(v.uv.y, 3.0f * (0.5f - v.position.z / 6.0f), 1e-5f);
        const vec3 bitangent = v.tangent.w * glm::cross(v.normal, vec3(v.tangent));
        EXPECT_LT(glm::distance(bitangent, vec3(0, 0, -1)), 1e-6f);
    }
    const Mesh& box = scene.meshes[1];
    EXPECT_NEAR(surfaceArea(box), 22.0f, 1e-4f);
    EXPECT_EQ(box.vertices.size(), 24u);
    EXPECT_EQ(box.bounds.upper, vec3(0.5f, 1.0f, 1.5f));
    for (const Vertex& v : box.vertices) EXPECT_GT(glm::dot(v.normal, v.position), 0.0f);

    const Mesh& sphere = scene.meshes[2];
    EXPECT_NEAR(surfaceArea(sphere), 4.0f * pi, 0.05f);
    for (const Vertex& v : sphere.vertices) {
        EXPECT_NEAR(glm::length(v.position), 1.0f, 1e-5f);
        EXPECT_LT(glm::distance(v.position, v.normal), 1e-5f);
        EXPECT_NEAR(glm::dot(v.normal, vec3(v.tangent)), 0.0f, 1e-5f);
    }
}

} // namespace
} // namespace tarn::test
