// A frame with levels of detail is the frame without them, for fewer triangles.
#include "gl/shader_library.h"
#include "test_renderer.h"
#include "test_scenes.h"

#include <algorithm>
#include <cmath>

namespace tarn::test {

namespace {

constexpr ivec2 size(160, 120);

/// Hills beside a pond, finer than any eye on the far side can see, under a low sun.
Scene hills()
{
    Scene scene = flatLake(3.0f, 40.0f);
    const auto height = [](float x, float z) {
        return 4.0f * std::sin(0.11f * x) * std::sin(0.13f * z) + 0.02f * std::sin(5.0f * x) * std::sin(4.0f * z);
    };
    Mesh mesh = groundMesh(height, 192, 0.25f, 16);
    for (Vertex& vertex : mesh.vertices) vertex.position += vec3(-24.0f, 2.0f, -90.0f);
    for (MeshPart& part : mesh.parts) {
        part.bounds.lower += vec3(-24.0f, 2.0f, -90.0f);
        part.bounds.upper += vec3(-24.0f, 2.0f, -90.0f);
    }
    addModel(scene, std::move(mesh));
    scene.sun = Sun{glm::normalize(vec3(1.0f, 0.5f, 0.4f)), vec3(3.0f), false};
    return scene;
}

Camera towardsHills(float z)
{
    Camera camera;
    camera.eye = {0.0f, 6.0f, z};
    camera.target = {0.0f, 2.0f, z - 60.0f};
    return camera;
}

std::size_t sceneTriangles(const FrameReport& stats)
{
    std::size_t sum = 0;
    for (const FrameReport::Pass& pass : stats.passes)
        if (pass.name == "scene") sum += pass.triangles;
    return sum;
}

} // namespace

TEST(Detail, DrawsTheSamePictureWithFewerTriangles)
{
    const Scene scene = hills();
    Options options;
    options.detail.pixels = 0.5f;
    CheckedRenderer renderer(scene, options);
    const Camera camera = towardsHills(40.0f);
    const Image coarse = renderer.linear(camera, size);
    const std::size_t few = sceneTriangles(renderer.stats);
    options.detail.pixels = 0.0f;
    renderer.setOptions(options, scene.water);
    const Image full = renderer.linear(camera, size);
    const std::size_t many = sceneTriangles(renderer.stats);
    EXPECT_LT(few, many / 3);

    double sum = 0.0, brightness = 0.0;
    std::size_t off = 0;
    for (std::size_t i = 0; i < full.floats.size(); ++i) {
        const float difference = std::abs(coarse.floats[i] - full.floats[i]);
        sum += difference;
        brightness += full.floats[i];
        if (difference > 0.1f) ++off;
    }
    EXPECT_LT(sum / brightness, 0.005);
    EXPECT_LT(off, full.floats.size() / 200) << "along outlines only";
    EXPECT_GT(sum, 0.0) << "the levels are drawn";
}

TEST(Detail, IsFullWhereTheEyeIsNear)
{
    const Scene scene = hills();
    Options options;
    options.detail.pixels = 0.5f;
    CheckedRenderer renderer(scene, options);
    const Camera camera = towardsHills(-65.0f);
    renderer.linear(camera, size);
    const std::size_t few = sceneTriangles(renderer.stats);
    options.detail.pixels = 0.0f;
    renderer.setOptions(options, scene.water);
    renderer.linear(camera, size);
    EXPECT_GT(few, sceneTriangles(renderer.stats) / 3);
}

TEST(Detail, OfNoPixelsIsTheFrameOfARendererThatNeverHadLevels)
{
    const Scene scene = hills();
    Options options;
    options.detail.pixels = 0.5f;
    CheckedRenderer had(scene, options);
    const Camera camera = towardsHills(40.0f);
    had.linear(camera, size);
    options.detail.pixels = 0.0f;
    had.setOptions(options, scene.water);
    const Image after = had.linear(camera, size);
    CheckedRenderer never(scene, options);
    EXPECT_EQ(after.floats, never.linear(camera, size).floats);
}

} // namespace tarn::test
