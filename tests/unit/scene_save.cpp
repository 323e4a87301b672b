// Saving a scene and loading it again gives the same scene.
#include "base/files.h"
#include "base/log.h"
#include "scene/scene_file.h"
#include "temp_folder.h"

namespace tarn::test {
namespace {

const char* const everything = R"(
name = "All \"of\" it"
[options]
frame.exposure = 0.1
refraction.method = "planar"
a.vector = [1, 2, 3]
[sun]
elevation = 35
azimuth = 120
irradiance = [100, 90, 80]
[sky]
kind = "daylight"
turbidity = 2.5
ground_albedo = 0.3
lighting = 0.9
[water]
level = 0.25
centre = [1, -2]
extent = [30, 40]
ior = 1.34
absorption = [0.4, 0.1, 0.05]
colour = [0.01, 0.2, 0.1]
normal_map = "pictures/ripples.png"
normal_map_tile = 1.7
normal_map_bump = 0.4
[[water.normal_layers]]
velocity = [0.1, -0.2]
[[water.normal_layers]]
velocity = [0.3, 0]
[[water.normal_layers]]
velocity = [0, 0]
[[water.normal_layers]]
velocity = [-5, 1]
[[water.waves]]
amplitude = 0.1
wavelength = 3.3
direction = 77
phase = 45
period = 1.5
[[materials]]
name = "check"
diffuse = [0.3, 0.2, 0.1]
specular = 0.1
transmission = [0.5, 0.6, 0.1]
shininess = 77
emissive = [1, 2, 3]
alpha = 0.9
diffuse_map = "pictures/a b.png"
bump_map = "pictures/a b.png"
bump_scale = 2
two_sided = true
alpha_cutoff = 0.3
[[models]]
name = "tri"
file = "models/tri.obj"
material = "check"
[[primitives]]
name = "bed"
kind = "plane"
size = [10, 1, 12]
segments = 4
uv_scale = [5, 6]
material = "check"
[[primitives]]
name = "ball"
kind = "sphere"
[[elements]]
name = "group"
translation = [1, 2, 3]
rotation = [10, 20, 30]
scale = [1, 2, 1]
[[elements.children]]
shape = "bed"
[[elements.children.children]]
shape = "tri"
visible = false
[[elements]]
shape = "ball"
[[point_lights]]
name = "lamp"
position = [1, 2, 3]
intensity = [4, 5, 6]
[[spot_lights]]
name = "torch"
position = [1, 2, 3]
direction = [0, 0, -1]
intensity = 7
inner_angle = 15
outer_angle = 25
[[cameras]]
name = "pier"
eye = [1, 2, 3]
target = [4, 5, 6]
up = [0, 0, 1]
fov = 40
near = 0.2
far = 500
)";

void expectSame(const Scene& a, const Scene& b);

class RoundTripTest : public ::testing::Test {
protected:
    TempFolder folder;
    log::Capture log;

    Scene load(const std::string& text) { return loadScene(folder.file("test.toml", text)); }

    void SetUp() override
    {
        std::filesystem::create_directories(folder.path() / "models");
        std::filesystem::create_directories(folder.path() / "pictures");
        std::filesystem::create_directories(folder.path() / "elsewhere");
        folder.file("models/tri.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        Image image;
        image.width = image.height = 2;
        image.channels = 3;
        image.bytes.resize(image.size(), 50);
        writeImage(folder.path() / "pictures" / "a b.png", image);
        image.bytes.assign(image.size(), 200);
        writeImage(folder.path() / "pictures" / "ripples.png", image);
    }
};

TEST_F(RoundTripTest, SavedIsLoaded)
{
    const Scene scene = load(everything);
    EXPECT_TRUE(log.messages().empty()) << log.messages()[0].text;
    EXPECT_TRUE(scene.water.normalMap.isSeen());
    EXPECT_EQ(scene.water.normalMap.layers[3].velocity, vec2(-5.0f, 1.0f));
    saveScene(scene, folder.path() / "saved.toml");
    expectSame(scene, loadScene(folder.path() / "saved.toml"));
}

TEST_F(RoundTripTest, PathsFollowTheFileToAnotherFolder)
{
    const Scene scene = load(everything);
    saveScene(scene, folder.path() / "elsewhere" / "saved.toml");
    const Scene again = loadScene(folder.path() / "elsewhere" / "saved.toml");
    EXPECT_TRUE(log.messages().empty()) << log.messages()[0].text;
    EXPECT_EQ(again.models[0].file, std::filesystem::path("../models/tri.obj"));
    EXPECT_EQ(again.images.size(), scene.images.size());
    expectSame(scene, again);
}

TEST_F(RoundTripTest, SavingAgainChangesNothing)
{
    saveScene(load(everything), folder.path() / "first.toml");
    saveScene(loadScene(folder.path() / "first.toml"), folder.path() / "second.toml");
    EXPECT_EQ(readFile(folder.path() / "first.toml"), readFile(folder.path() / "second.toml"));
}

TEST_F(RoundTripTest, ABareObjCanBeSaved)
{
    const Scene scene = loadScene(folder.path() / "models" / "tri.obj", {0.5f, nullptr});
    saveScene(scene, folder.path() / "saved.toml");
    const Scene again = loadScene(folder.path() / "saved.toml");
    expectSame(scene, again);
    EXPECT_TRUE(again.water.present);
    EXPECT_TRUE(again.sun->automatic);
}

void expectNear(const vec3& a, const vec3& b) { EXPECT_LE(glm::distance(a, b), 1e-6f * (1.0f + glm::length(a))); }

void expectSame(const Element& a, const Element& b)
{
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.shape, b.shape);
    EXPECT_EQ(a.visible, b.visible);
    expectNear(a.translation, b.translation);
    expectNear(a.rotation, b.rotation);
    expectNear(a.scale, b.scale);
    ASSERT_EQ(a.children.size(), b.children.size());
    for (std::size_t i = 0; i < a.children.size(); ++i) expectSame(a.children[i], b.children[i]);
}

void expectSame(const Material& a, const Material& b)
{
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.diffuse, b.diffuse);
    EXPECT_EQ(a.specular, b.specular);
    EXPECT_EQ(a.transmission, b.transmission);
    EXPECT_EQ(a.emissive, b.emissive);
    EXPECT_EQ(a.shininess, b.shininess);
    EXPECT_EQ(a.alpha, b.alpha);
    EXPECT_EQ(a.twoSided, b.twoSided);
    EXPECT_EQ(a.alphaTested, b.alphaTested);
    EXPECT_EQ(a.alphaCutoff, b.alphaCutoff);
    EXPECT_EQ(a.bumpScale, b.bumpScale);
    EXPECT_EQ(a.diffuseMap, b.diffuseMap);
    EXPECT_EQ(a.normalMap, b.normalMap);
    EXPECT_EQ(a.fromModel, b.fromModel);
}

void expectSame(const WaterNormalMap& a, const WaterNormalMap& b)
{
    EXPECT_EQ(a.file.filename(), b.file.filename());
    EXPECT_EQ(a.image, b.image);
    EXPECT_EQ(a.tile, b.tile);
    EXPECT_EQ(a.bump, b.bump);
    for (std::size_t i = 0; i < a.layers.size(); ++i) EXPECT_EQ(a.layers[i].velocity, b.layers[i].velocity);
}

void expectSame(const WaterBody& a, const WaterBody& b)
{
    expectSame(a.normalMap, b.normalMap);
    EXPECT_EQ(a.present, b.present);
    EXPECT_EQ(a.level, b.level);
    EXPECT_EQ(a.centre, b.centre);
    EXPECT_EQ(a.extent, b.extent);
    EXPECT_EQ(a.ior, b.ior);
    EXPECT_EQ(a.absorption, b.absorption);
    EXPECT_EQ(a.colour, b.colour);
    ASSERT_EQ(a.waves.size(), b.waves.size());
    for (std::size_t i = 0; i < a.waves.size(); ++i) {
        EXPECT_EQ(a.waves[i].amplitude, b.waves[i].amplitude);
        EXPECT_EQ(a.waves[i].wavelength, b.waves[i].wavelength);
        EXPECT_EQ(a.waves[i].period, b.waves[i].period);
        EXPECT_NEAR(a.waves[i].direction, b.waves[i].direction, 1e-6f);
        EXPECT_NEAR(a.waves[i].phase, b.waves[i].phase, 1e-6f);
    }
}

void expectSame(const Camera& a, const Camera& b)
{
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.eye, b.eye);
    EXPECT_EQ(a.target, b.target);
    EXPECT_EQ(a.up, b.up);
    EXPECT_NEAR(a.verticalFov, b.verticalFov, 1e-6f);
    EXPECT_EQ(a.nearPlane, b.nearPlane);
    EXPECT_EQ(a.farPlane, b.farPlane);
}

template <typename T> void expectSameList(const std::vector<T>& a, const std::vector<T>& b)
{
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) expectSame(a[i], b[i]);
}

void expectSameLight(const Scene& a, const Scene& b)
{
    ASSERT_EQ(a.sun.has_value(), b.sun.has_value());
    expectNear(a.sun->direction, b.sun->direction);
    EXPECT_EQ(a.sun->irradiance, b.sun->irradiance);
    EXPECT_EQ(a.sun->automatic, b.sun->automatic);
    EXPECT_EQ(a.sky.kind, b.sky.kind);
    EXPECT_EQ(a.sky.turbidity, b.sky.turbidity);
    EXPECT_EQ(a.sky.groundAlbedo, b.sky.groundAlbedo);
    EXPECT_EQ(a.sky.lighting, b.sky.lighting);
    ASSERT_EQ(a.pointLights.size(), b.pointLights.size());
    for (std::size_t i = 0; i < a.pointLights.size(); ++i) {
        EXPECT_EQ(a.pointLights[i].name, b.pointLights[i].name);
        EXPECT_EQ(a.pointLights[i].position, b.pointLights[i].position);
        EXPECT_EQ(a.pointLights[i].intensity, b.pointLights[i].intensity);
    }
    ASSERT_EQ(a.spotLights.size(), b.spotLights.size());
    for (std::size_t i = 0; i < a.spotLights.size(); ++i) {
        EXPECT_EQ(a.spotLights[i].direction, b.spotLights[i].direction);
        EXPECT_NEAR(a.spotLights[i].innerAngle, b.spotLights[i].innerAngle, 1e-6f);
        EXPECT_NEAR(a.spotLights[i].outerAngle, b.spotLights[i].outerAngle, 1e-6f);
    }
}

void expectSame(const Scene& a, const Scene& b)
{
    EXPECT_EQ(a.name, b.name);
    expectSameList(a.materials, b.materials);
    expectSameList(a.elements, b.elements);
    expectSameList(a.cameras, b.cameras);
    expectSame(a.water, b.water);
    expectSameLight(a, b);
    ASSERT_EQ(a.options.size(), b.options.size());
    for (std::size_t i = 0; i < a.options.size(); ++i) {
        EXPECT_EQ(a.options[i].key, b.options[i].key);
        EXPECT_EQ(a.options[i].value, b.options[i].value);
    }
    const auto left = flatten(a), right = flatten(b);
    ASSERT_EQ(left.size(), right.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
        const Mesh& m = a.meshes[static_cast<std::size_t>(left[i].mesh)];
        const Mesh& n = b.meshes[static_cast<std::size_t>(right[i].mesh)];
        EXPECT_EQ(m.indices, n.indices);
        ASSERT_EQ(m.vertices.size(), n.vertices.size());
        for (std::size_t k = 0; k < m.vertices.size(); ++k) EXPECT_EQ(m.vertices[k].position, n.vertices[k].position);
    }
}

} // namespace
} // namespace tarn::test
