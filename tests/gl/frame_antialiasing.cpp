// frame.antialiasing: what smooths edges, and what it leaves alone.
#include "gl/shader_library.h"
#include "gl_test.h"
#include "optics/filters.h"
#include "render/passes/fxaa.h"
#include "test_renderer.h"
#include "test_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace tarn::test {
namespace {

constexpr ivec2 pictureSize(48, 40);

/// A shown picture with its luma, as present.frag leaves it, filtered.
std::vector<vec3> smoothed(const std::function<vec3(int x, int y)>& colour)
{
    std::vector<float> texels;
    for (int y = 0; y < pictureSize.y; ++y)
        for (int x = 0; x < pictureSize.x; ++x) {
            const vec3 c = colour(x, y);
            for (const float value : {c.x, c.y, c.z, optics::fxaaLuma(c)}) texels.push_back(value);
        }
    gl::Texture source({.format = gl::Format::rgba32f, .size = pictureSize}, "shown");
    source.upload(std::span<const float>(texels));
    const auto shaders = makeShaderLibrary();
    FxaaPass pass(*shaders);
    const std::vector<float> floats = pass.draw(source).framebuffer().readFloats();
    std::vector<vec3> result;
    for (std::size_t i = 0; i < floats.size(); i += 4) result.emplace_back(floats[i], floats[i + 1], floats[i + 2]);
    return result;
}

vec3 at(const std::vector<vec3>& picture, int x, int y)
{
    return picture[static_cast<std::size_t>(y * pictureSize.x + x)];
}

TEST(FrameAntialiasing, FxaaLeavesWhatHasNoEdge)
{
    const auto slope = [](int x, int y) {
        return vec3(0.3f) + 0.004f * static_cast<float>(x) + 0.003f * static_cast<float>(y);
    };
    const std::vector<vec3> same = smoothed(slope);
    for (int y = 0; y < pictureSize.y; ++y)
        for (int x = 0; x < pictureSize.x; ++x) ASSERT_LT(glm::distance(at(same, x, y), slope(x, y)), 1.0f / 255.0f);
    // A straight edge along the pixels is not blurred but for what counts as smaller than a pixel.
    const std::vector<vec3> straight = smoothed([](int x, int) { return vec3(x < 20 ? 0.2f : 0.8f); });
    for (int x = 0; x < pictureSize.x; ++x) ASSERT_NEAR(at(straight, x, 17).x, x < 20 ? 0.2f : 0.8f, 0.05f) << x;
}

/// How much of a pixel lies under a line through the picture.
double covered(int x, int y, double slope)
{
    constexpr int samples = 16;
    double sum = 0.0;
    for (int i = 0; i < samples; ++i) {
        const double height = 6.3 + slope * (x + (i + 0.5) / samples);
        sum += std::clamp(height - y, 0.0, 1.0);
    }
    return sum / samples;
}

// A line that climbs: the filter takes most of its steps away, across and up alike, and stays between both
// sides.
TEST(FrameAntialiasing, FxaaSmoothsASlantedEdge)
{
    for (const double slope : {0.11, 0.2, 0.37}) {
        for (const bool isTurned : {false, true}) {
            const auto stepped = [&](int x, int y) {
                if (isTurned) std::swap(x, y);
                return vec3(6.3 + slope * (x + 0.5) > y + 0.5 ? 0.9f : 0.1f);
            };
            const std::vector<vec3> smooth = smoothed(stepped);
            double before = 0.0, after = 0.0;
            for (int y = 4; y < 36; ++y) {
                for (int x = 4; x < 36; ++x) {
                    const double truth = 0.1 + 0.8 * (isTurned ? covered(y, x, slope) : covered(x, y, slope));
                    const float is = at(smooth, x, y).x;
                    ASSERT_GE(is, 0.1f - 0.003f);
                    ASSERT_LE(is, 0.9f + 0.003f);
                    before += std::pow(stepped(x, y).x - truth, 2.0);
                    after += std::pow(is - truth, 2.0);
                }
            }
            EXPECT_LT(after, 0.25 * before) << slope << (isTurned ? " turned" : "");
        }
    }
}

TEST(FrameAntialiasing, WithoutItOneSampleOfAPixelIsDrawn)
{
    Scene scene = flatLake(1.0f);
    addBox(scene, vec3(-1.0f, -0.5f, -4.0f), vec3(1.0f, 1.0f, -3.0f), addMaterial(scene, vec3(0.05f)));
    Camera camera;
    camera.eye = vec3(0.4f, 1.7f, 4.0f);
    camera.target = vec3(0.0f, 0.3f, -2.0f);
    camera.up = normalize(vec3(0.2f, 1.0f, 0.0f));
    Options options;
    options.frame.msaa = 1;
    TestRenderer test(scene, options);
    const auto draw = [&](FrameOptions::Antialiasing antialiasing, int samples) {
        options.frame.antialiasing = antialiasing;
        options.frame.msaa = samples;
        test.renderer.setOptions(options, scene.water);
        test.renderer.render({camera, 0.0, {80, 60}});
        return std::pair(test.renderer.readDisplay(), test.renderer.readLinear());
    };
    const auto one = draw(FrameOptions::Antialiasing::msaa, 1), none = draw(FrameOptions::Antialiasing::none, 4);
    const auto fxaa = draw(FrameOptions::Antialiasing::fxaa, 4), four = draw(FrameOptions::Antialiasing::msaa, 4);
    EXPECT_EQ(one.first.bytes, none.first.bytes);
    EXPECT_NE(one.first.bytes, four.first.bytes);
    EXPECT_NE(one.first.bytes, fxaa.first.bytes);
    EXPECT_EQ(one.second.floats, fxaa.second.floats); // radiance is not filtered
    // Against the mean of many: the filter is nearer to it than nothing.
    options.frame.scale = 8.0f;
    const Image truth = draw(FrameOptions::Antialiasing::none, 1).first;
    const auto error = [&](const Image& image) {
        double sum = 0.0;
        for (std::size_t i = 0; i < image.bytes.size(); ++i) sum += std::abs(int(image.bytes[i]) - int(truth.bytes[i]));
        return sum;
    };
    EXPECT_LT(error(fxaa.first), 0.8 * error(none.first));
    EXPECT_LT(error(four.first), 0.8 * error(none.first));
}

} // namespace
} // namespace tarn::test
