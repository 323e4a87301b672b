// frame.scale: a picture is made of one that is drawn larger or smaller, and has the size that was asked for.
#include "gl/shader_library.h"
#include "optics/filters.h"
#include "plan/stereo.h"
#include "render/passes/downsample.h"
#include "render/passes/upscale.h"
#include "test_renderer.h"
#include "test_scenes.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace tarn::test {
namespace {

using Colour = std::function<vec4(int x, int y)>;

/// A texture of a known colour in each texel, y upward.
gl::Texture textureOf(ivec2 size, gl::Format format, const Colour& colour)
{
    std::vector<float> texels;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const vec4 value = colour(x, y);
            for (int c = 0; c < 4; ++c) texels.push_back(value[c]);
        }
    gl::Texture texture({.format = format, .size = size}, "known");
    texture.upload(std::span<const float>(texels));
    return texture;
}

vec3 texel(const std::vector<float>& floats, ivec2 size, int x, int y)
{
    const float* const at = &floats[static_cast<std::size_t>(4 * (y * size.x + x))];
    return {at[0], at[1], at[2]};
}

/// Something with edges in all directions, and noise.
vec4 discs(int x, int y)
{
    const float distance = std::hypot(static_cast<float>(x) - 9.3f, static_cast<float>(y) - 7.1f);
    const float ring = std::fmod(distance, 6.0f) < 3.0f ? 0.8f : 0.1f;
    return {ring, 0.03f * static_cast<float>(x), static_cast<float>((x * 7 + y * 13) % 5) / 5.0f, 1.0f};
}

optics::UpscaleTexels texelsAt(ivec2 size, ivec2 base, const Colour& colour)
{
    const auto at = [&](int x, int y) {
        const ivec2 place = glm::clamp(base + ivec2(x, y), ivec2(0), size - 1);
        return vec3(colour(place.x, place.y));
    };
    optics::UpscaleTexels t;
    t.c00 = at(0, 0), t.c10 = at(1, 0), t.c01 = at(0, 1), t.c11 = at(1, 1);
    t.below0 = at(0, -1), t.below1 = at(1, -1), t.above0 = at(0, 2), t.above1 = at(1, 2);
    t.left0 = at(-1, 0), t.left1 = at(-1, 1), t.right0 = at(2, 0), t.right1 = at(2, 1);
    return t;
}

// The pass against the formulas, at its borders too.
TEST(FrameScale, UpscalingIsTheSharedFilter)
{
    const ivec2 source(20, 15), size(31, 30);
    const auto shaders = makeShaderLibrary();
    UpscalePass pass(*shaders);
    const gl::Texture texture = textureOf(source, gl::Format::rgba32f, discs);
    for (const auto upscaler : {FrameOptions::Upscaler::edge, FrameOptions::Upscaler::bilinear}) {
        const gl::Target& target = pass.draw(texture, size, upscaler);
        ASSERT_EQ(target.size(), size);
        const std::vector<float> floats = target.framebuffer().readFloats();
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const vec2 at = (vec2(x, y) + 0.5f) * vec2(source) / vec2(size) - 0.5f;
                const vec2 base = glm::floor(at);
                const optics::UpscaleTexels t = texelsAt(source, ivec2(base), discs);
                const vec3 expected = upscaler == FrameOptions::Upscaler::edge ? optics::edgeUpscaled(t, at - base)
                                                                               : optics::bilinearUpscaled(t, at - base);
                const vec3 is = texel(floats, size, x, y);
                for (int c = 0; c < 3; ++c) ASSERT_NEAR(is[c], expected[c], 1.5f / 255.0f) << x << ',' << y << ' ' << c;
            }
        }
    }
}

TEST(FrameScale, RadianceStaysBetweenItsNeighboursAndBesideItsSeam)
{
    const ivec2 source(24, 9), size(50, 20);
    const auto shaders = makeShaderLibrary();
    UpscalePass pass(*shaders);
    FrameOptions options;
    options.exposure = 0.5f;
    const gl::Texture even =
        textureOf(source, gl::Format::rgba32f, [](int, int) { return vec4(3.0f, 0.25f, 700.0f, 1.0f); });
    const std::vector<float> same = pass.drawLinear(even, size, options, 1).framebuffer().readFloats();
    for (int i = 0; i < size.x * size.y; ++i) {
        const vec3 is = texel(same, size, i % size.x, i / size.x);
        ASSERT_NEAR(is.x, 3.0f, 3e-3f);
        ASSERT_NEAR(is.y, 0.25f, 3e-3f);
        ASSERT_NEAR(is.z, 700.0f, 2.0f);
    }
    // Two pictures: nothing of one is in the other.
    const gl::Texture pair =
        textureOf(source, gl::Format::rgba32f, [&](int x, int) { return vec4(x < source.x / 2 ? 0.0f : 5.0f); });
    const std::vector<float> halves = pass.drawLinear(pair, size, options, 2).framebuffer().readFloats();
    const std::vector<float> mixed = pass.drawLinear(pair, size, options, 1).framebuffer().readFloats();
    EXPECT_GT(texel(mixed, size, size.x / 2 - 1, 5).x, 0.01f);
    for (int x = 0; x < size.x; ++x) ASSERT_NEAR(texel(halves, size, x, 5).x, x < size.x / 2 ? 0.0f : 5.0f, 5e-3f) << x;
}

TEST(FrameScale, TheMeanIsOverAnArea)
{
    const auto shaders = makeShaderLibrary();
    DownsamplePass pass(*shaders);
    for (const ivec2 drawn : {ivec2(40, 30), ivec2(31, 23), ivec2(47, 16)}) {
        const ivec2 size(16, 16);
        gl::Target source("drawn");
        source.ensure({.size = drawn, .colours = {gl::Format::rgba32f}});
        source.colour() = textureOf(drawn, gl::Format::rgba32f, discs);
        const std::vector<float> floats = pass.draw(source, size).framebuffer().readFloats();
        const vec2 perPixel = vec2(drawn) / vec2(size);
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                vec3 expected(0.0f);
                for (int j = 0; j < drawn.y; ++j)
                    for (int i = 0; i < drawn.x; ++i)
                        expected += optics::overlap(static_cast<float>(x) * perPixel.x,
                                                    static_cast<float>(x + 1) * perPixel.x, static_cast<float>(i)) *
                                    optics::overlap(static_cast<float>(y) * perPixel.y,
                                                    static_cast<float>(y + 1) * perPixel.y, static_cast<float>(j)) *
                                    vec3(discs(i, j));
                expected /= perPixel.x * perPixel.y;
                EXPECT_LT(glm::distance(texel(floats, size, x, y), expected), 2e-3f) << x << ',' << y;
            }
        }
    }
}

TEST(FrameScale, APixelIsTheMeanOfThoseDrawnForIt)
{
    const Scene scene = rippledLake();
    for (const int edge : {2, 3}) {
        Options options;
        options.frame.msaa = 1;
        options.glow.enabled = false;
        CheckedRenderer renderer(scene, options);
        const ivec2 size(40, 30);
        const Image large = renderer.linear(lookAcross(), edge * size, 0.7);
        options.frame.scale = static_cast<float>(edge);
        renderer.setOptions(options, scene.water);
        const Image mean = renderer.linear(lookAcross(), size, 0.7);
        ASSERT_EQ(ivec2(mean.width, mean.height), size);
        bool isAnyMixed = false;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                vec4 expected(0.0f);
                for (int j = 0; j < edge; ++j)
                    for (int i = 0; i < edge; ++i) expected += pixel(large, edge * x + i, edge * y + j);
                expected /= static_cast<float>(edge * edge);
                const vec4 is = pixel(mean, x, y);
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(is[c], expected[c], 1e-3f * expected[c] + 1e-5f) << x << "," << y;
                const vec4 one = pixel(large, edge * x, edge * y);
                isAnyMixed = isAnyMixed || std::abs(one.x - expected.x) > 0.05f * expected.x;
            }
        }
        EXPECT_TRUE(isAnyMixed); // else a copy of one of the pixels would pass
    }
}

// A mean of positions is none, nor is what is upscaled of them.
TEST(FrameScale, RawValuesAreThoseOfThePixelsCentre)
{
    const Scene scene = rippledLake();
    Options options;
    options.frame.antialiasing = FrameOptions::Antialiasing::fxaa;
    CheckedRenderer renderer(scene, options);
    const Image plain = renderer.linear(lookAcross(), {40, 30}, 0.7, DebugView::positionW);
    for (const float scale : {0.4f, 3.0f}) {
        options.frame.scale = scale;
        renderer.setOptions(options, scene.water);
        const Image same = renderer.linear(lookAcross(), {40, 30}, 0.7, DebugView::positionW);
        EXPECT_EQ(plain.floats, same.floats) << scale;
    }
}

TEST(FrameScale, EveryPictureHasItsSizeAndNoBadPixels)
{
    const Scene scene = rippledLake();
    const ivec2 size(45, 31);
    for (const float scale : {0.25f, 0.5f, 0.67f, 0.99f, 1.0f, 1.3f, 2.0f}) {
        for (const auto output :
             {StereoOptions::Output::off, StereoOptions::Output::sideBySide, StereoOptions::Output::anaglyph}) {
            Options options;
            options.frame.scale = scale;
            options.stereo.output = output;
            TestRenderer test(scene, options);
            test.renderer.setChecking(true);
            const ivec2 whole = presentedSize(size, output);
            for (const DebugView view :
                 {DebugView::final, DebugView::sceneDepth, DebugView::refractionColour, DebugView::fresnel}) {
                test.renderer.render({lookAcross(), 0.7, size, view});
                EXPECT_TRUE(test.renderer.badPixels().empty());
                const Image shown = test.renderer.readDisplay();
                EXPECT_EQ(ivec2(shown.width, shown.height), whole) << scale;
                if (output == StereoOptions::Output::anaglyph) continue;
                const Image linear = test.renderer.readLinear();
                EXPECT_EQ(ivec2(linear.width, linear.height), whole) << scale;
                EXPECT_TRUE(
                    std::all_of(linear.floats.begin(), linear.floats.end(), [](float f) { return std::isfinite(f); }));
            }
        }
    }
}

/// The mean difference of two shown pictures, in levels.
double difference(const Image& a, const Image& b)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < a.bytes.size(); ++i) sum += std::abs(int(a.bytes[i]) - int(b.bytes[i]));
    return sum / static_cast<double>(a.bytes.size());
}

// What is drawn smaller shows the same picture, in the same place, and the better the more is drawn of it.
TEST(FrameScale, ASmallerFrameShowsThePicture)
{
    const Scene scene = rippledLake();
    Options options;
    TestRenderer test(scene, options);
    const auto shown = [&](float scale) {
        options.frame.scale = scale;
        test.renderer.setOptions(options, scene.water);
        test.renderer.render({lookAcross(), 0.7, {120, 90}});
        return test.renderer.readDisplay();
    };
    const Image full = shown(1.0f);
    double last = 0.0;
    for (const float scale : {0.85f, 0.67f, 0.5f, 0.25f}) {
        const double error = difference(shown(scale), full);
        EXPECT_GT(error, last) << scale;
        EXPECT_LT(error, 12.0) << scale;
        last = error;
    }
}

// Nothing of one eye's picture gets into the other's.
TEST(FrameScale, EyesSideBySideAreThoseOfOneEye)
{
    const Scene scene = rippledLake();
    Options options;
    options.frame.scale = 0.6f;
    options.caustics.enabled = false; // which lie where the head is, not the eye
    TestRenderer test(scene, options);
    const ivec2 size(60, 45);
    const Camera head = lookAcross();
    options.stereo.output = StereoOptions::Output::sideBySide;
    options.stereo.separation = 0.5f;
    test.renderer.setOptions(options, scene.water);
    test.renderer.render({head, 0.7, size});
    const Image both = test.renderer.readLinear(), bothShown = test.renderer.readDisplay();
    Options one = options;
    one.stereo.output = StereoOptions::Output::off;
    test.renderer.setOptions(one, scene.water);
    for (const Eye eye : bothEyes) {
        test.renderer.render({eyeCamera(head, options.stereo, eye), 0.7, size});
        const Image alone = test.renderer.readLinear(), aloneShown = test.renderer.readDisplay();
        const int from = eye == Eye::left ? 0 : size.x;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const vec4 is = pixel(both, from + x, y), expected = pixel(alone, x, y);
                for (int c = 0; c < 3; ++c) { // the seam is found in another precision
                    ASSERT_NEAR(is[c], expected[c], 1e-3f * expected[c]) << eyeName(eye) << ' ' << x << ',' << y;
                    const auto shown = [&](const Image& image, int column) {
                        return int(image.bytes[static_cast<std::size_t>((y * image.width + column) * 3 + c)]);
                    };
                    ASSERT_EQ(shown(bothShown, from + x), shown(aloneShown, x)) << eyeName(eye) << ' ' << x << ',' << y;
                }
            }
        }
    }
}

} // namespace
} // namespace tarn::test
