// No program is built during a flight, also not where it goes under water or turns away from it.
#include "gl_test.h"

#include "base/files.h"
#include "gl/shader_library.h"
#include "render/warm_up.h"
#include "scene/flight.h"
#include "scene/scene_file.h"
#include "test_renderer.h"
#include "test_scenes.h"

#include <gtest/gtest.h>

namespace tarn::test {

namespace {

Options smallOptions(Options options)
{
    options.sunlight.mapSize = 64;
    options.refraction.targetSize = options.reflection.targetSize = 32;
    options.caustics.photons = options.caustics.textureSize = 32;
    return options;
}

/// Flies and counts the programs that are built on the way.
std::size_t builtInFlight(const Scene& scene, const Options& options, const std::vector<Camera>& cameras, int frames,
                          std::size_t& sides)
{
    TestRenderer test(scene, options);
    const std::size_t atFirst = test.shaders->built();
    warmUp(test.renderer, scene.water);
    EXPECT_GT(test.shaders->built(), atFirst) << "else the flight shows nothing";
    const std::size_t before = test.shaders->built();
    bool seen[3] = {};
    for (int i = 0; i < frames; ++i) {
        const Camera camera = flightCamera(cameras, i / static_cast<double>(frames - 1));
        const FrameReport& stats = test.renderer.render({camera, 0.1 * i, {32, 24}});
        seen[static_cast<std::size_t>(stats.plan.side)] = true;
    }
    sides = static_cast<std::size_t>(seen[0]) + seen[1] + seen[2];
    return test.shaders->built() - before;
}

} // namespace

TEST(FrameWarm, TheLakeIsFlownThroughWithoutBuildingAProgram)
{
    const Scene scene = loadScene(projectRoot() / "assets/lake/lake.toml");
    Options options = smallOptions({});
    options.refraction.camera = RefractionOptions::CameraMode::flat;
    options.reflection.facets = ReflectionOptions::Facets::five;
    std::size_t sides = 0;
    EXPECT_EQ(builtInFlight(scene, options, scene.cameras, 60, sides), 0u);
    EXPECT_GE(sides, 2u) << "the flight goes under water";
}

// Views that each rule leaves something out of, from both sides of the surface and through it.
TEST(FrameWarm, NorDoRulesBuildOneWhenTheyApply)
{
    Scene scene = flatLake(2.0f, 30.0f);
    addBox(scene, {-4, -0.5f, -4}, {-3, 1.5f, -3}, 0);
    scene.sun = Sun{normalize(vec3(0.3f, 1.0f, -0.4f)), vec3(2.0f), false};
    scene.water.waves = {{0.02f, 2.0f, 0.4f, 0.0f, 0.0f}};
    std::vector<Camera> cameras;
    for (const auto& [eye, target] : {std::pair(vec3(0, 3, 8), vec3(0)),
                                      {vec3(0, 3, 8), vec3(0, 9, 20)},
                                      {vec3(5, 6, 5), vec3(5.1f, 0, 5)},
                                      {vec3(0, 0.4f, 8), vec3(-3, 0, -3)},
                                      {vec3(0, -0.6f, 8), vec3(-3, 0, -3)},
                                      {vec3(0, -0.6f, 2), vec3(0, -2, -3)}}) {
        Camera camera;
        camera.eye = eye;
        camera.target = target;
        cameras.push_back(camera);
    }
    for (const bool rays : {false, true}) {
        Options options = smallOptions({});
        if (rays) options.refraction.method = RefractionOptions::Method::raycast;
        if (rays) options.reflection.method = ReflectionOptions::Method::raycast;
        std::size_t sides = 0;
        EXPECT_EQ(builtInFlight(scene, options, cameras, 80, sides), 0u) << rays;
        EXPECT_EQ(sides, 3u);
    }
}

} // namespace tarn::test
