#include "gl/texture.h"

#include "base/error.h"
#include "gl/api.h"
#include "gl/context.h"
#include "gl/framebuffer.h"

#include <gtest/gtest.h>

#include <functional>
#include <numeric>

namespace tarn::gl {
namespace {

std::string messageOf(const std::function<void()>& action)
{
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(GlTexture, FloatsComeBackAsTheyWent)
{
    for (const Format format : {Format::r32f, Format::rg32f, Format::rgba32f}) {
        const int channels = channelCount(format);
        Texture texture({.format = format, .size = {5, 3}}, "floats");
        std::vector<float> values(static_cast<std::size_t>(15 * channels));
        std::iota(values.begin(), values.end(), -7.25f);
        texture.upload(values);
        EXPECT_EQ(texture.readBack(), values) << formatName(format);
    }
}

TEST(GlTexture, HalvesAndBytesComeBackRounded)
{
    Texture half({.format = Format::rgba16f, .size = {1, 1}}, "half");
    half.upload(std::vector<float>{0.1f, -2.0f, 1000.5f, 0.0f});
    const std::vector<float> halves = half.readBack();
    EXPECT_NEAR(halves[0], 0.1f, 5e-5f);
    EXPECT_EQ(halves[1], -2.0f);
    EXPECT_EQ(halves[2], 1000.5f);

    // 3 channels and an odd width: rows are not padded to four bytes.
    Texture bytes({.format = Format::rgba8, .size = {3, 2}}, "bytes");
    std::vector<std::uint8_t> rgb(18);
    std::iota(rgb.begin(), rgb.end(), std::uint8_t{0});
    bytes.upload(rgb, 3);
    const std::vector<float> values = bytes.readBack();
    for (std::size_t texel = 0; texel < 6; ++texel) {
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(values[4 * texel + c] * 255.0f, static_cast<float>(3 * texel + c), 1e-3f);
        }
        EXPECT_EQ(values[4 * texel + 3], 1.0f) << "alpha that is not given is opaque";
    }
}

TEST(GlTexture, DepthComesBack)
{
    for (const Format format : {Format::depth16, Format::depth24, Format::depth32f}) {
        Texture depth({.format = format, .size = {2, 1}, .filter = Filter::nearest}, "depth");
        depth.upload(std::vector<float>{0.25f, 1.0f});
        const std::vector<float> values = depth.readBack();
        EXPECT_NEAR(values[0], 0.25f, 1e-4f) << formatName(format);
        EXPECT_EQ(values[1], 1.0f) << formatName(format);
    }
}

TEST(GlTexture, MipmapsAverage)
{
    Texture texture({.format = Format::r32f, .size = {4, 2}, .mipmaps = true, .anisotropy = 64.0f}, "mipmapped");
    texture.upload(std::vector<float>{1, 3, 5, 7, 1, 3, 5, 7});
    texture.generateMipmaps();
    EXPECT_EQ(texture.levels(), 3);
    EXPECT_EQ(texture.levelSize(1), ivec2(2, 1));
    EXPECT_EQ(texture.readBack(0, 1), (std::vector<float>{2, 6}));
    EXPECT_EQ(texture.readBack(0, 2), (std::vector<float>{4}));
}

TEST(GlTexture, CubeFacesAreSeparate)
{
    Texture cube({.kind = TextureKind::cube, .format = Format::r32f, .size = {2, 2}}, "cube");
    for (int face = 0; face < 6; ++face) cube.upload(std::vector<float>(4, static_cast<float>(face)), 0, face);
    for (int face = 0; face < 6; ++face) {
        EXPECT_EQ(cube.readBack(face), std::vector<float>(4, static_cast<float>(face)));
    }
}

TEST(GlTexture, LayersAreSeparate)
{
    Texture array({.kind = TextureKind::array, .format = Format::r32f, .size = {2, 2}, .layers = 3}, "array");
    EXPECT_EQ(array.faces(), 3);
    for (int layer = 0; layer < 3; ++layer) array.upload(std::vector<float>(4, static_cast<float>(layer)), 0, layer);
    for (const int layer : {2, 0}) {
        const Framebuffer target("layer", {{array, 0, layer}});
        target.clearColour(vec4(10.0f + static_cast<float>(layer)));
    }
    EXPECT_EQ(array.readBack(0), std::vector<float>(4, 10.0f));
    EXPECT_EQ(array.readBack(1), std::vector<float>(4, 1.0f)) << "drawn into by nobody";
    EXPECT_EQ(array.readBack(2), std::vector<float>(4, 12.0f));
    EXPECT_NE(messageOf([&] { array.readBack(3); }).find("face 3"), std::string::npos);
}

TEST(GlTexture, ImpossibleOnesAreNamed)
{
    EXPECT_EQ(messageOf([] { Texture({.size = {0, 4}}, "bark"); }), "texture \"bark\" (rgba8 0x4): it has no pixels");
    EXPECT_EQ(messageOf([] {
                  Texture({.kind = TextureKind::cube, .size = {4, 2}}, "sky");
              }),
              "texture \"sky\" (rgba8 4x2): the faces of a cube must be square");
    EXPECT_NE(messageOf([] { Texture({.size = {1 << 28, 1}}, "wide"); }).find("at most"), std::string::npos);
    EXPECT_NE(messageOf([] { Texture({.size = {1, 1}, .layers = 2}, "deep"); }).find("2 layers"), std::string::npos);
    EXPECT_NE(messageOf([] {
                  Texture({.size = {1, 1}, .samples = 1000}, "fine");
              }).find("1000 samples"),
              std::string::npos);
    EXPECT_NE(messageOf([] { Texture({.size = {1, 1}, .compare = true}, "c"); }).find("only depth"), std::string::npos);
}

TEST(GlTexture, UploadsMustFit)
{
    Texture texture({.format = Format::rg8, .size = {2, 2}}, "stones");
    EXPECT_EQ(messageOf([&] { texture.upload(std::vector<std::uint8_t>(7)); }),
              "texture \"stones\": 7 values for 2x2 texels with 2 channels, 8 expected");
    EXPECT_NE(messageOf([&] { texture.upload(std::vector<std::uint8_t>(8), 0, 1); }).find("face 1"), std::string::npos);
}

TEST(GlTexture, UploadsLeaveTheBindingsOfAPassAlone)
{
    Texture first({.format = Format::r32f, .size = {1, 1}}, "first");
    first.bind(0);
    Texture second({.format = Format::r32f, .size = {1, 1}}, "second");
    second.upload(std::vector<float>{1.0f});
    GLint bound = 0;
    glActiveTexture(GL_TEXTURE0);
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    EXPECT_EQ(static_cast<Name>(bound), first.name());
}

} // namespace
} // namespace tarn::gl
