// Materials and their pictures.
#include "base/files.h"
#include "base/log.h"
#include "scene/scene_file.h"
#include "temp_folder.h"

#include <fmt/format.h>

#include <cmath>

namespace tarn::test {
namespace {

class MtlTest : public ::testing::Test {
protected:
    TempFolder folder;
    log::Capture log;

    Scene load(const std::string& mtl)
    {
        folder.file("test.mtl", mtl);
        return loadScene(folder.file("test.obj", "mtllib test.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl m\nf 1 2 3\n"));
    }
    Material material(const std::string& mtl) { return load(mtl).materials.at(0); }

    void picture(const std::string& name, int channels, std::vector<std::uint8_t> bytes, int width = 1)
    {
        Image image;
        image.width = width;
        image.channels = channels;
        image.height = static_cast<int>(bytes.size()) / width / channels;
        image.bytes = std::move(bytes);
        writeImage(folder.path() / name, image);
    }
    void expectNoWarnings() const { EXPECT_TRUE(log.messages().empty()) << log.messages().front().text; }
};

TEST_F(MtlTest, Constants)
{
    const Material m = material(
        "newmtl m\nKa 1 1 1\nKd 0.1 0.2 0.3\nKs 0.4 0.5 0.6\nNs 99\nKe 7 8 9\nTf 0.6 0.5 0.4\nd 0.75\nillum 2\n");
    EXPECT_EQ(m.diffuse, vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(m.specular, vec3(0.4f, 0.5f, 0.6f));
    EXPECT_EQ(m.transmission, vec3(0.6f, 0.5f, 0.4f));
    EXPECT_EQ(m.shininess, 99.0f);
    EXPECT_EQ(m.emissive, vec3(7.0f, 8.0f, 9.0f));
    EXPECT_EQ(m.alpha, 0.75f);
    EXPECT_TRUE(m.fromModel);
    EXPECT_FLOAT_EQ(material("newmtl m\nTr 0.25\n").alpha, 0.75f);
    EXPECT_EQ(material("newmtl m\n").diffuse, vec3(0.8f)) << "without Kd, a visible grey";
    expectNoWarnings();
}

TEST_F(MtlTest, WindowsTextWithByteOrderMark)
{
    EXPECT_EQ(material("\xef\xbb\xbfnewmtl m\r\nKd 0.5 0.25 0\r\n").diffuse, vec3(0.5f, 0.25f, 0.0f));
    expectNoWarnings();
}

TEST_F(MtlTest, BadNumbersAreLeftOut)
{
    const Material m = material("newmtl m\nKd nan 0 0\nKs 1\nNs inf\nd\n");
    EXPECT_EQ(m.diffuse, vec3(0.8f));
    EXPECT_TRUE(log.contains("test.mtl:2: Kd needs 3 finite numbers"));
    EXPECT_TRUE(log.contains("test.mtl:3: Ks needs 3 finite numbers"));
    EXPECT_TRUE(log.contains("test.mtl:4: Ns needs 1 finite number"));
    EXPECT_TRUE(log.contains("test.mtl:5: d needs 1 finite number"));
    const Material clamped = material("newmtl m\nKd -1 2 0.5\nd 7\n");
    EXPECT_EQ(clamped.diffuse, vec3(0.0f, 1.0f, 0.5f));
    EXPECT_EQ(clamped.alpha, 1.0f);
}

TEST_F(MtlTest, JunkIsNotAMaterialFile)
{
    EXPECT_EQ(load("hello\n").meshes.size(), 1u);
    EXPECT_TRUE(log.contains("test.mtl:1: no material in this file"));
    EXPECT_EQ(load("").meshes.size(), 1u);
    EXPECT_EQ(load(std::string("newmtl m\nKd \0\xff\n", 14)).meshes.size(), 1u);
}

TEST_F(MtlTest, MapsWithOptionsAndSpaces)
{
    picture("old wall.png", 3, {10, 20, 30});
    for (const char* line : {"map_Kd old wall.png", "map_Kd -s 2 2 2 old wall.png", "map_Kd -s 2 2 -o 0.5 old wall.png",
                             "map_Kd -clamp on -blendu off -mm 0 1 old wall.png", "map_Kd .\\old wall.png  "}) {
        SCOPED_TRACE(line);
        const Scene scene = load(std::string("newmtl m\n") + line + "\n");
        ASSERT_EQ(scene.images.size(), 1u);
        EXPECT_EQ(scene.images[0].bytes, (std::vector<std::uint8_t>{10, 20, 30}));
        EXPECT_EQ(scene.materials[0].diffuseMap, 0);
        EXPECT_EQ(scene.materials[0].diffuse, vec3(1.0f)) << "without Kd the map is taken as it is";
        EXPECT_FALSE(scene.materials[0].alphaTested);
    }
    expectNoWarnings();
}

TEST_F(MtlTest, MissingOrCorruptPicturesAreWarnings)
{
    folder.file("junk.png", "no picture at all");
    folder.file("empty.png", "");
    for (const char* name : {"none.png", "junk.png", "empty.png"}) {
        const Scene scene = load(std::string("newmtl m\nKd 0.5 0.25 0.125\nmap_Kd ") + name + "\n");
        EXPECT_TRUE(scene.images.empty());
        EXPECT_EQ(scene.materials[0].diffuseMap, noImage);
        EXPECT_EQ(scene.materials[0].diffuse, vec3(0.5f, 0.25f, 0.125f));
        EXPECT_TRUE(log.contains("test.mtl:3: ")) << name;
        EXPECT_TRUE(log.contains(name));
    }
    EXPECT_EQ(material("newmtl m\nKd 0 0 0\nmap_Kd none.png\n").diffuse, vec3(0.5f)) << "not black";
    EXPECT_EQ(load("newmtl m\nmap_Kd\n").images.size(), 0u);
    EXPECT_TRUE(log.contains("map_Kd names no picture"));
}

TEST_F(MtlTest, AlphaOfTheDiffuseMap)
{
    picture("leaf.png", 4, {1, 2, 3, 0, 1, 2, 3, 255});
    const Material leaf = material("newmtl m\nmap_Kd leaf.png\n");
    EXPECT_TRUE(leaf.alphaTested);
    EXPECT_TRUE(leaf.twoSided);
    picture("solid.png", 4, {1, 2, 3, 255});
    EXPECT_FALSE(material("newmtl m\nmap_Kd solid.png\n").alphaTested) << "an alpha channel that hides nothing";
}

TEST_F(MtlTest, AlphaMapBecomesOneChannel)
{
    picture("leaf.png", 4, {1, 2, 3, 77});
    picture("grey.png", 3, {10, 20, 30});
    const Scene fromAlpha = load("newmtl m\nmap_Kd leaf.png\nmap_d leaf.png\n");
    ASSERT_EQ(fromAlpha.images.size(), 2u);
    EXPECT_EQ(fromAlpha.images[1].channels, 1);
    EXPECT_EQ(fromAlpha.images[1].bytes[0], 77);
    EXPECT_TRUE(fromAlpha.materials[0].alphaTested);
    EXPECT_EQ(load("newmtl m\nmap_d grey.png\n").images[0].bytes[0], 20) << "brightness where there is no alpha";
}

TEST_F(MtlTest, BumpBecomesNormals)
{
    // A ramp along +u: normals lean to -u. In v: rows run down, v up.
    std::vector<std::uint8_t> ramp;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) ramp.push_back(static_cast<std::uint8_t>(16 * x));
    picture("ramp.png", 1, ramp, 16);
    const Scene scene = load("newmtl m\nmap_Bump -bm 5 ramp.png\n");
    ASSERT_EQ(scene.materials[0].normalMap, 0);
    EXPECT_EQ(scene.materials[0].bumpScale, 5.0f);
    const Image& normals = scene.images[0];
    ASSERT_EQ(normals.channels, 3);
    const std::size_t middle = 3 * (8 * 16 + 8);
    // Slope: 16/255 a texel, times 16 texels · 2 % · 5.
    const float slope = 16.0f / 255.0f * 16.0f * 0.02f * 5.0f;
    EXPECT_NEAR(normals.bytes[middle], 127.5f * (1.0f - slope / std::sqrt(1.0f + slope * slope)), 1.0f);
    EXPECT_NEAR(normals.bytes[middle + 1], 128, 1);
    EXPECT_NEAR(normals.bytes[middle + 2], 127.5f * (1.0f + 1.0f / std::sqrt(1.0f + slope * slope)), 1.0f);

    std::vector<std::uint8_t> upward;
    for (int y = 0; y < 16; ++y) upward.insert(upward.end(), 16, static_cast<std::uint8_t>(240 - 16 * y));
    picture("up.png", 1, upward, 16);
    const Scene rising = load("newmtl m\nbump -bm 5 up.png\n");
    EXPECT_LT(rising.images[0].bytes[middle + 1], 127 - 5) << "a slope that rises with v leans to -v";
}

TEST_F(MtlTest, NormAndEmissiveMaps)
{
    picture("n.png", 3, {128, 128, 255});
    picture("e.png", 3, {255, 0, 0});
    const Scene scene = load("newmtl m\nnorm n.png\nmap_Ke e.png\nbump e.png\n");
    EXPECT_EQ(scene.images.size(), 2u) << "norm wins over bump";
    EXPECT_NE(scene.materials[0].normalMap, noImage);
    EXPECT_EQ(scene.materials[0].bumpScale, 0.0f);
    EXPECT_EQ(scene.materials[0].emissive, vec3(1.0f)) << "without Ke the map is taken as it is";
    expectNoWarnings();
}

TEST_F(MtlTest, OnePictureIsReadOnce)
{
    picture("a.png", 3, {1, 2, 3});
    const Scene scene = load("newmtl m\nmap_Kd a.png\nnewmtl n\nmap_Kd ./a.png\n");
    EXPECT_EQ(scene.images.size(), 1u);
    EXPECT_EQ(scene.materials[1].diffuseMap, 0);
}

TEST_F(MtlTest, ManyPicturesInParallelKeepTheirOrder)
{
    std::string mtl;
    for (int i = 0; i < 40; ++i) {
        picture(fmt::format("p{}.png", i), 3, {static_cast<std::uint8_t>(i), 0, 0});
        mtl += fmt::format("newmtl {}\nmap_Kd p{}.png\n", i == 0 ? "m" : std::to_string(i), i);
    }
    const Scene scene = load(mtl);
    for (int i = 0; i < 40; ++i) {
        const Material& m = scene.materials.at(static_cast<std::size_t>(i));
        EXPECT_EQ(scene.images.at(static_cast<std::size_t>(m.diffuseMap)).bytes[0], i);
    }
}

} // namespace
} // namespace tarn::test
