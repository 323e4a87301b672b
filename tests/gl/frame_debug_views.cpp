// Every debug view shows something, and something of its own.
#include "test_renderer.h"
#include "test_scenes.h"

#include "gl/shader_library.h"
#include "render/debug_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace tarn::test {

namespace {

/// A pool with waves, sun and a box that stands in it: everything that a pass can show is there.
Scene poolWithABox()
{
    Scene scene = flatLake(2.0f, 24.0f, 40.0f);
    scene.sun = Sun{glm::normalize(vec3(0.4f, 0.8f, 0.3f)), vec3(90.0f), false};
    scene.water.absorption = vec3(0.5f, 0.2f, 0.1f);
    scene.water.waves = {{0.02f, 1.3f, 0.3f, 0.0f, 0.0f}, {0.012f, 0.8f, 1.9f, 1.0f, 0.0f}};
    addBox(scene, {-1.0f, -2.0f, -1.0f}, {1.0f, 1.0f, 1.0f}, addMaterial(scene, vec3(0.6f, 0.3f, 0.2f)));
    return scene;
}

} // namespace

TEST(FrameDebugViews, EachShowsItsOwnValues)
{
    const Scene scene = poolWithABox();
    Camera camera;
    camera.eye = vec3(0.5f, 2.5f, 6.0f);
    camera.target = vec3(0.0f);
    CheckedRenderer renderer(scene);
    std::vector<std::vector<float>> pictures;
    for (const DebugViewInfo& info : debugViews) {
        Image image = renderer.linear(camera, {48, 36}, 0.4, info.view);
        float largest = 0.0f;
        for (std::size_t i = 0; i < image.floats.size(); ++i)
            if (i % 4 != 3) largest = std::max(largest, std::abs(image.floats[i]));
        EXPECT_GT(largest, 1.0e-3f) << info.name << " shows nothing";
        for (std::size_t other = 0; other < pictures.size(); ++other)
            EXPECT_NE(image.floats, pictures[other])
                << info.name << " shows what " << debugViews[other].name << " does";
        pictures.push_back(std::move(image.floats));
    }
}

} // namespace tarn::test
