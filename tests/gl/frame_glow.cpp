// The glow's filter, and that glow lies where the sun's highlight is.
#include "gl_test.h"
#include "test_scenes.h"

#include "gl/profiler.h"
#include "optics/optics.h"
#include "render/passes/glow.h"
#include "render/renderer.h"

#include <gtest/gtest.h>

#include <vector>

namespace tarn::test {

// Mihálik 2008, section 9.3: one bright cell becomes the 13 cells of the two diagonals, a thirteenth each.
TEST(Glow, OneBrightPixelBecomesTheDiagonalsOfASquare)
{
    const ivec2 size(21, 17);
    const ivec2 bright(9, 8);
    std::vector<float> pixels(static_cast<std::size_t>(size.x * size.y) * 4, 0.0f);
    for (int c = 0; c < 4; ++c) pixels[static_cast<std::size_t>((bright.y * size.x + bright.x) * 4 + c)] = 13.0f;
    gl::TextureDesc desc;
    desc.format = gl::Format::rgba32f;
    desc.size = size;
    gl::Texture source(desc, "one bright pixel");
    source.upload(std::span<const float>(pixels));

    const auto shaders = makeShaderLibrary();
    GlowPass glow(*shaders);
    const std::vector<float> blurred = glow.blur(source).framebuffer().readFloats();
    int lit = 0;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const int dx = std::abs(x - bright.x);
            const int dy = std::abs(y - bright.y);
            const float expected = dx == dy && dx <= 3 ? 1.0f : 0.0f;
            if (expected > 0.0f) ++lit;
            EXPECT_FLOAT_EQ(blurred[static_cast<std::size_t>((y * size.x + x) * 4)], expected) << x << ", " << y;
        }
    }
    EXPECT_EQ(lit, 13);
}

TEST(Glow, WeightsSumToOne)
{
    double sum = 0.0;
    for (int y = -5; y <= 5; ++y)
        for (int x = -5; x <= 5; ++x) sum += optics64::glowWeight(x, y);
    EXPECT_NEAR(sum, 1.0, 1.0e-15);
}

// Still water: the highlight lies where the mirror sends the sun to the eye, and nowhere else.
TEST(Glow, BrightensThePictureAtTheSunsReflection)
{
    Scene scene = flatLake(3.0f);
    scene.sky.radiance = vec3(0.01f);
    scene.sun = Sun{normalize(vec3(0.0f, 1.0f, -1.0f)), vec3(0.0f), false}; // gives no light: only its glow is seen
    Camera camera;
    camera.eye = vec3(0.0f, 2.0f, 0.0f);
    camera.target = vec3(0.0f, 0.0f, -2.0f);
    camera.verticalFov = glm::radians(60.0f);
    const ivec2 size(160, 120);
    const auto picture = [&](bool enabled) {
        Options options;
        options.glow.enabled = enabled;
        options.glow.divisor = 2;
        const auto shaders = makeShaderLibrary();
        gl::Profiler profiler;
        Renderer renderer(scene, options, *shaders, profiler);
        renderer.render({camera, 0.0, size, DebugView::final});
        return renderer.readDisplay();
    };
    const Image with = picture(true);
    const Image without = picture(false);
    const auto difference = [&](int x, int y) {
        const auto i = static_cast<std::size_t>((y * size.x + x) * 3);
        return static_cast<int>(with.bytes[i]) - static_cast<int>(without.bytes[i]);
    };
    EXPECT_GT(difference(80, 60), 100);
    EXPECT_EQ(difference(5, 5), 0);
    EXPECT_EQ(difference(155, 115), 0);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) EXPECT_GE(difference(x, y), 0);
}

} // namespace tarn::test
