// What passes declare that they read, held against the textures that they bind.
#include "test_renderer.h"
#include "test_scenes.h"

#include "gl/program.h"
#include "gl/texture.h"
#include "render/pass_interface.h"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <set>
#include <string>

namespace tarn::test {

namespace {

/// By the labels of what the passes draw into. Nothing for what none of them draws for another.
std::optional<Resource> resourceOf(const std::string& label)
{
    static const std::map<std::string, Resource> resources{
        {"sunlight depth", Resource::sunDepth},
        {"caustics colour 0", Resource::caustics},
        {"heights", Resource::bedHeights},
        {"heights colour 0", Resource::bedHeights},
        {"heights above water", Resource::aboveWaterHeights},
        {"refraction colour 0", Resource::refraction},
        {"refraction depth", Resource::refraction},
        {"reflection colour 0", Resource::reflection},
        {"reflection depth", Resource::reflection},
        {"frame depth", Resource::sceneDepth},
        {"frame colour 0", Resource::sceneColour},
        {"waterline colour 0", Resource::waterline},
        {"glow colour 0", Resource::glow},
    };
    const auto found = resources.find(label);
    return found == resources.end() ? std::nullopt : std::optional(found->second);
}

Scene pond()
{
    Scene scene = flatLake(2.0f, 20.0f);
    scene.sun = Sun{normalize(vec3(0.0f, 0.4f, -1.0f)), vec3(3.0f)}; // mirrored in view
    scene.water.waves = {{0.03f, 2.0f, 0.4f, 0.0f, 0.0f}};
    addBox(scene, {2, -1, -4}, {4, 2, -3}, 0);
    return scene;
}

Options smallOptions()
{
    Options options;
    options.refraction.targetSize = options.reflection.targetSize = 64;
    options.sunlight.mapSize = options.caustics.textureSize = options.caustics.photons = 64;
    options.heights.mapSize = 64;
    options.frame.antialiasing = FrameOptions::Antialiasing::none;
    return options;
}

/// Every resource that each pass binds in a frame.
struct Bound {
    std::map<std::string, std::set<Resource>> byPass;
    FramePlan plan;
};

Bound boundIn(const Options& options, const vec3& eye)
{
    const Scene scene = pond();
    TestRenderer test(scene, options);
    Camera camera;
    camera.eye = eye;
    camera.target = {0, 0, 0};
    Bound bound;
    gl::observeTextures([&](const gl::Texture& texture) {
        if (const auto resource = resourceOf(texture.label()))
            bound.byPass[std::string(test.profiler.openPass())].insert(*resource);
    });
    bound.plan = test.renderer.render({camera, 0.3, {48, 32}}).plan;
    gl::observeTextures({});
    return bound;
}

std::string namesOf(PassId pass, const FramePlan& plan)
{
    std::string names;
    for (const PassId other : readBy(pass, plan)) names += std::string(passName(other)) + ' ';
    return names;
}

} // namespace

TEST(PassInterfaces, PassesBindWhatTheyDeclareAndNothingElse)
{
    Options targets = smallOptions(), maps = smallOptions();
    maps.refraction.method = RefractionOptions::Method::raycast;
    maps.reflection.method = ReflectionOptions::Method::raycast;
    for (const Options& options : {targets, maps})
        for (const vec3 eye : {vec3(0, 2, 7), vec3(0, 0.01f, 7), vec3(0, -1, 7)}) {
            const Bound bound = boundIn(options, eye);
            for (std::size_t i = 0; i < passCount; ++i) {
                const auto pass = static_cast<PassId>(i);
                if (!bound.plan[pass].wanted) continue;
                const PassInterface declared = interfaceOf(pass, bound.plan);
                const auto found = bound.byPass.find(passName(pass));
                if (found == bound.byPass.end()) continue;
                for (const Resource resource : found->second)
                    EXPECT_TRUE(declared.reads.has(resource) || declared.writes.has(resource))
                        << passName(pass) << " binds resource " << static_cast<int>(resource) << " at eye " << eye.y;
            }
        }
}

// And nothing is declared that is not bound: in the frames that need it.
TEST(PassInterfaces, NothingIsDeclaredInVain)
{
    Options targets = smallOptions(), maps = smallOptions();
    maps.refraction.method = RefractionOptions::Method::raycast;
    maps.reflection.method = ReflectionOptions::Method::raycast;
    const Bound withTargets = boundIn(targets, {0, 2, 7}), withMaps = boundIn(maps, {0, 2, 7});
    const auto expectBound = [](const Bound& bound, PassId pass, std::initializer_list<Resource> resources) {
        for (const Resource resource : resources) {
            EXPECT_TRUE(bound.byPass.at(passName(pass)).contains(resource))
                << passName(pass) << " does not bind resource " << static_cast<int>(resource);
            EXPECT_TRUE(interfaceOf(pass, bound.plan).reads.has(resource)) << passName(pass);
        }
    };
    expectBound(withTargets, PassId::caustics, {Resource::sunDepth});
    expectBound(withTargets, PassId::scene, {Resource::sunDepth, Resource::caustics});
    expectBound(withTargets, PassId::refraction, {Resource::sunDepth, Resource::caustics});
    expectBound(withTargets, PassId::reflection, {Resource::sunDepth});
    expectBound(withTargets, PassId::water, {Resource::refraction, Resource::reflection});
    expectBound(withTargets, PassId::glow, {Resource::sceneDepth});
    expectBound(withTargets, PassId::present, {Resource::sceneColour, Resource::glow});
    expectBound(withMaps, PassId::heights, {Resource::sunDepth});
    expectBound(withMaps, PassId::water,
                {Resource::bedHeights, Resource::aboveWaterHeights, Resource::sunDepth, Resource::caustics});
}

TEST(PassInterfaces, APassReadsThoseThatWriteForIt)
{
    const FramePlan plan = boundIn(smallOptions(), {0, 2, 7}).plan;
    EXPECT_EQ(namesOf(PassId::sunlight, plan), "");
    EXPECT_EQ(namesOf(PassId::caustics, plan), "sunlight ");
    EXPECT_EQ(namesOf(PassId::refraction, plan), "sunlight caustics ");
    EXPECT_EQ(namesOf(PassId::scene, plan), "sunlight caustics ");
    EXPECT_EQ(namesOf(PassId::water, plan), "refraction reflection scene ");
    EXPECT_EQ(namesOf(PassId::present, plan), "scene water glow ");
}

} // namespace tarn::test
