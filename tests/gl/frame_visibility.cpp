// What is left out of a pass must not be seen in it.
#include "test_scenes.h"

#include "gl/profiler.h"
#include "gl/shader_library.h"
#include "render/renderer.h"
#include "render/visibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tarn::test {

TEST(WaterCover, HidesOnlyWhatLiesBehindTheSurface)
{
    WaterBody water;
    water.present = true;
    water.extent = vec2(20.0f);
    water.waves = {{0.1f, 3.0f, 0.0f, 0.0f, 0.0f}};
    const WaterCover cover = waterCover(water);
    const vec3 eye(0.0f, 2.0f, 5.0f);
    const auto box = [](const vec3& lower, const vec3& upper) { return Bounds{lower, upper}; };
    EXPECT_TRUE(cover.hides(eye, box({-1, -3, -1}, {1, -1, 1})));
    EXPECT_FALSE(cover.hides(eye, box({-1, -3, -1}, {1, -0.05f, 1}))) << "a trough may uncover it";
    EXPECT_FALSE(cover.hides(eye, box({-1, -3, -1}, {1, 1, 1}))) << "it stands out of the water";
    EXPECT_FALSE(cover.hides({0, 0.05f, 5}, box({-1, -3, -1}, {1, -1, 1}))) << "the eye may be under a crest";
    EXPECT_FALSE(cover.hides({0, 2, 30}, box({-1, -3, 8}, {1, -1, 9.5f}))) << "seen past the water's near edge";
    EXPECT_FALSE(cover.hides(eye, box({-1, -3, -60}, {1, -2, -50}))) << "seen past the water's far edge";
    EXPECT_FALSE(WaterCover{}.hides(eye, box({-1, -3, -1}, {1, -1, 1})));
}

TEST(Visibility, AMediumIsNamedOnlyWhereNothingElseCanBe)
{
    WaterBody water;
    water.present = true;
    water.level = 1.0f;
    water.extent = vec2(20.0f);
    const auto at = [&](const vec3& lower, const vec3& upper) { return mediumOf({lower, upper}, water, 0.01f); };
    EXPECT_EQ(at({-1, 1, -1}, {1, 3, 1}), Medium::air);
    EXPECT_EQ(at({-1, -3, -1}, {1, 0.9f, 1}), Medium::water);
    EXPECT_EQ(at({-1, -3, -1}, {1, 1, 1}), Medium::both) << "its top lies in the level itself";
    EXPECT_EQ(at({9, -3, -1}, {11, 0, 1}), Medium::both) << "across the water's edge";
    EXPECT_EQ(at({10.5f, -3, -1}, {12, 0, 1}), Medium::air) << "beside the water";
    EXPECT_EQ(at({10.005f, -3, -1}, {12, 0, 1}), Medium::both) << "within the rim that gets wet";
}

namespace {

struct Picture {
    std::vector<float> pixels;
    std::size_t triangles;
};

Picture picture(const Scene& scene, const Camera& camera, bool cull)
{
    Options options;
    options.plan.rules[static_cast<std::size_t>(RuleId::cullChunks)] = cull;
    const auto shaders = makeShaderLibrary();
    gl::Profiler profiler;
    Renderer renderer(scene, options, *shaders, profiler);
    const FrameReport stats = renderer.render({camera, 0.7, {160, 120}, DebugView::final});
    std::size_t triangles = 0; // of the scene: the water's grid is not culled
    for (const FrameReport::Pass& pass : stats.passes)
        if (pass.name != "water") triangles += pass.triangles;
    return {renderer.readLinear().floats, triangles};
}

} // namespace

TEST(Visibility, CullingChangesNoPixel)
{
    Scene scene = flatLake(3.0f, 60.0f);
    scene.water.waves = {{0.05f, 2.0f, 0.4f, 0.0f, 0.0f}, {0.03f, 0.9f, 1.4f, 1.0f, 0.0f}};
    // Boxes everywhere: under, in and over the water, behind the eye and beyond the lake.
    for (int x = -5; x <= 5; ++x) {
        for (int z = -5; z <= 5; ++z) {
            const vec3 at(static_cast<float>(x) * 7.0f, static_cast<float>((x * 7 + z * 3) % 5) - 2.5f,
                          static_cast<float>(z) * 7.0f);
            addBox(scene, at - 0.6f, at + 0.6f, 0);
        }
    }
    std::size_t drawn = 0;
    std::size_t all = 0;
    for (const vec3 eye : {vec3(0, 1.5f, 20), vec3(-25, 6, 10), vec3(40, 3, 0), vec3(3, -1, 3)}) {
        Camera camera;
        camera.eye = eye;
        camera.target = vec3(0.0f, -0.5f, 0.0f);
        const Picture culled = picture(scene, camera, true);
        const Picture full = picture(scene, camera, false);
        std::size_t different = 0;
        float most = 0.0f;
        for (std::size_t i = 0; i < full.pixels.size(); ++i) {
            if (culled.pixels[i] != full.pixels[i]) ++different;
            most = std::max(most, std::abs(culled.pixels[i] - full.pixels[i]));
        }
        EXPECT_EQ(different, 0u) << "by up to " << most << " from " << eye.x << ", " << eye.y << ", " << eye.z;
        drawn += culled.triangles;
        all += full.triangles;
    }
    EXPECT_LT(drawn, all / 2);
}

} // namespace tarn::test
