// Foliage as the mean of many pixels sees it: a layer covers its fraction, and layers behind each other multiply.
#include "gl/shader_library.h"
#include "test_renderer.h"
#include "test_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace tarn::test {

namespace {

constexpr ivec2 pictureSize(64, 64);

/// White ground under black layers, each of which lets the dots of one picture stand: its fraction of texels is there.
Scene layersOver(int layers, double fraction)
{
    Scene scene;
    scene.sky.kind = Sky::Kind::constant;
    scene.sky.radiance = vec3(0.0f);
    const int ground = addMaterial(scene, vec3(0.0f));
    scene.materials[static_cast<std::size_t>(ground)].emissive = vec3(1.0f);
    addFloor(scene, 0.0f, 60.0f, ground);

    constexpr int edge = 128;
    Image dots{"dots", edge, edge, 4, std::vector<std::uint8_t>(edge * edge * 4, 0), {}};
    std::mt19937 random(7);
    std::bernoulli_distribution isThere(fraction);
    for (std::size_t i = 3; i < dots.bytes.size(); i += 4) dots.bytes[i] = isThere(random) ? 255 : 0;
    scene.images.push_back(dots);
    const auto leaf = static_cast<std::size_t>(addMaterial(scene, vec3(0.0f)));
    scene.materials[leaf].diffuseMap = 0;
    scene.materials[leaf].alphaTested = true;
    for (int i = 0; i < layers; ++i)
        addFloor(scene, 1.0f + 0.5f * static_cast<float>(i), 60.0f, static_cast<int>(leaf), 60);
    return scene;
}

double meanThrough(const Scene& scene, const Options& options)
{
    Camera camera;
    camera.eye = vec3(0.0f, 40.0f, 0.0f);
    camera.target = vec3(0.0f, 0.0f, -0.001f);
    camera.verticalFov = glm::radians(40.0f); // a pixel is half a metre, 60 texels
    camera.farPlane = 100.0f;
    CheckedRenderer renderer(scene, options);
    const Image image = renderer.linear(camera, pictureSize);
    double sum = 0.0;
    for (int y = 0; y < pictureSize.y; ++y)
        for (int x = 0; x < pictureSize.x; ++x) sum += static_cast<double>(pixel(image, x, y).x);
    return sum / (pictureSize.x * pictureSize.y);
}

} // namespace

TEST(FrameCutOuts, LayersCoverTheirSharesOneByOne)
{
    for (const double fraction : {0.2, 0.7}) {
        for (int layers = 1; layers <= 3; ++layers) {
            const Scene scene = layersOver(layers, fraction);
            const double expected = std::pow(1.0 - fraction, layers);
            for (const int supersampling : {2, 4}) {
                for (const int msaa : {1, 4}) {
                    Options options;
                    options.frame.msaa = msaa;
                    options.frame.scale = static_cast<float>(supersampling);
                    EXPECT_NEAR(meanThrough(scene, options), expected, 0.015)
                        << fraction << ' ' << layers << ' ' << supersampling << ' ' << msaa;
                }
            }
        }
    }
}

// One test for a pixel can but show all of a layer or none: it is what the picture without supersampling has.
TEST(FrameCutOuts, OneTestForAPixelKnowsNoShares)
{
    Options options;
    options.frame.msaa = 1;
    const double through = meanThrough(layersOver(1, 0.2), options);
    EXPECT_GT(std::abs(through - 0.8), 0.03);
    EXPECT_GT(std::abs(meanThrough(layersOver(2, 0.2), options) - 0.64), 0.03);
}

// A scene's texels are read while it is uploaded, and never again: not for the shares either, which are wanted later.
TEST(FrameCutOuts, AreDrawnAlikeWhenTheSceneHasReleasedItsTexels)
{
    Camera camera;
    camera.eye = vec3(0.0f, 40.0f, 0.0f);
    camera.target = vec3(0.0f, 0.0f, -0.001f);
    Options one, four;
    one.frame.scale = 1.0f;
    four.frame.scale = 4.0f;
    for (const bool isAlphaMap : {false, true}) {
        Scene whole = layersOver(2, 0.4);
        if (isAlphaMap) { // of one channel, as loading makes it
            Material& leaf = whole.materials.back();
            std::swap(leaf.alphaMap, leaf.diffuseMap);
            Image& dots = whole.images.front();
            for (std::size_t i = 0; 4 * i < dots.bytes.size(); ++i) dots.bytes[i] = dots.bytes[4 * i + 3];
            dots.channels = 1;
            dots.bytes.resize(dots.size());
        }
        Scene released = whole;
        CheckedRenderer expected(whole, one), renderer(released, one);
        releaseTexels(released);
        EXPECT_EQ(renderer.linear(camera, pictureSize).floats, expected.linear(camera, pictureSize).floats);
        expected.setOptions(four, whole.water);
        renderer.setOptions(four, released.water);
        const std::vector<float> shares = renderer.linear(camera, pictureSize).floats;
        EXPECT_EQ(shares, expected.linear(camera, pictureSize).floats);
        CheckedRenderer anew(whole, four);
        EXPECT_EQ(shares, anew.linear(camera, pictureSize).floats);
    }
}

} // namespace tarn::test
