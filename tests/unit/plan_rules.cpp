// The rules by which a frame's plan leaves passes out: when they apply, when they may not, and that they say why.
#include "plan/reduce.h"

#include "optics/optics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tarn {

namespace {

Scene lakeScene()
{
    Scene scene;
    scene.water.present = true;
    scene.water.extent = vec2(40.0f, 20.0f);
    scene.sun = Sun{normalize(vec3(0.0f, 0.7f, -1.0f)), vec3(100.0f), false};
    return scene;
}

Camera cameraAt(const vec3& eye, const vec3& target)
{
    Camera camera;
    camera.eye = eye;
    camera.target = target;
    return camera;
}

const Camera overTheLake = cameraAt({0, 4, 15}, {0, 0, 0});

FramePlan planFor(const Scene& scene, const Camera& camera, const Options& options, const VisibilityFacts* visibility)
{
    return planFrame(scene, scene.water, camera, options, {640, 480}, 0.0, nullptr, visibility);
}

/// Bed and shore in view.
VisibilityFacts everything()
{
    VisibilityFacts visibility;
    visibility.leastDepth = -1.0f;
    visibility.bedReflectance = vec3(0.3f);
    visibility.sunBelow = vec3(80.0f);
    visibility.skyBelow = vec3(20.0f);
    return visibility;
}

Options without(RuleId id)
{
    Options options;
    options.plan.rules[static_cast<std::size_t>(id)] = false;
    return options;
}

} // namespace

TEST(PlanRules, EachHasAnOptionAndSaysWhatBecameOfIt)
{
    const Scene scene = lakeScene();
    const VisibilityFacts visibility = everything();
    const FramePlan plan = planFor(scene, overTheLake, {}, &visibility);
    for (std::size_t i = 0; i < ruleCount; ++i) {
        const auto id = static_cast<RuleId>(i);
        EXPECT_FALSE(plan.rule(id).why.empty()) << rule(id).name;
        EXPECT_GE(rule(id).levels, 1);
        Options options = without(id);
        EXPECT_FALSE(options.plan.allows(id));
        const FramePlan refused = planFor(scene, overTheLake, options, &visibility);
        EXPECT_FALSE(refused.rule(id).applies);
        EXPECT_NE(refused.rule(id).why.find(std::string("plan.") + rule(id).name), std::string::npos);
        options = {};
        options.plan.exact = true;
        EXPECT_EQ(options.plan.allows(id), rule(id).bound == nullptr) << rule(id).name;
        options.plan.enabled = false;
        EXPECT_FALSE(options.plan.allows(id));
    }
}

TEST(PlanRules, WithoutAPlanEveryPassRuns)
{
    const Scene scene = lakeScene();
    Options options;
    options.plan.enabled = false;
    const FramePlan plan = planFor(scene, cameraAt({0, 4, 15}, {0, 60, 100}), options, nullptr);
    for (std::size_t i = 0; i < passCount; ++i)
        EXPECT_EQ(plan.passes[i].wanted, static_cast<PassId>(i) != PassId::heights) << passName(static_cast<PassId>(i));
    for (const RuleState& state : plan.rules) EXPECT_FALSE(state.applies);
}

TEST(PlanRules, AMirrorOfNothingButSkyNeedsNoTarget)
{
    Scene scene = lakeScene();
    VisibilityFacts visibility = everything();
    EXPECT_TRUE(planFor(scene, overTheLake, {}, &visibility)[PassId::reflection].wanted);
    visibility.mirrors = false;
    EXPECT_FALSE(planFor(scene, overTheLake, {}, &visibility)[PassId::reflection].wanted);
    Options options;
    options.reflection.method = ReflectionOptions::Method::distance;
    EXPECT_TRUE(planFor(scene, overTheLake, options, &visibility)[PassId::reflection].wanted);
    options = {};
    options.plan.exact = true;
    EXPECT_TRUE(planFor(scene, overTheLake, options, &visibility)[PassId::reflection].wanted);
    EXPECT_TRUE(planFor(scene, cameraAt({0, -1, 5}, {0, 0, 0}), {}, &visibility)[PassId::reflection].wanted)
        << "from below";
    scene.sky.kind = Sky::Kind::picture;
    EXPECT_TRUE(planFor(scene, overTheLake, {}, &visibility)[PassId::reflection].wanted);
}

TEST(PlanRules, ABedThatIsNotThereNeedsNoTarget)
{
    const Scene scene = lakeScene();
    VisibilityFacts visibility = everything();
    visibility.seesBed = false;
    FramePlan plan = planFor(scene, overTheLake, without(RuleId::bedTooDeep), &visibility);
    EXPECT_FALSE(plan[PassId::refraction].wanted);
    EXPECT_TRUE(planFor(scene, overTheLake, {}, nullptr)[PassId::refraction].wanted) << "nothing is known";
    EXPECT_TRUE(planFor(scene, overTheLake, without(RuleId::noBed), &visibility)[PassId::refraction].wanted)
        << "no bed is not a deep one";
    EXPECT_TRUE(plan[PassId::caustics].wanted) << "the shore's foot may be under water";
    visibility.mainReceives = visibility.reflectionReceives = false;
    plan = planFor(scene, overTheLake, {}, &visibility);
    EXPECT_FALSE(plan[PassId::caustics].wanted);
    EXPECT_TRUE(plan[PassId::sunlight].wanted) << "shadows";
    Options noShadows;
    noShadows.sunlight.shadows = false;
    EXPECT_FALSE(planFor(scene, overTheLake, noShadows, &visibility)[PassId::sunlight].wanted);
    visibility.reflectionReceives = true;
    EXPECT_TRUE(planFor(scene, overTheLake, {}, &visibility)[PassId::caustics].wanted);
}

// The bound is checked against the formulas themselves: just where the rule begins to apply, a bed as bright as can be
// changes the display by less than half of one 255th.
TEST(PlanRules, ABedIsTooDeepWhereNoLightOfItIsLeftThatCouldBeSeen)
{
    Scene scene = lakeScene();
    scene.water.absorption = vec3(0.5f, 0.4f, 0.6f);
    scene.water.waves = {{0.1f, 4.0f, 0.0f, 0.0f, 0.0f}};
    Options options;
    options.frame.exposure = 0.05f;
    VisibilityFacts visibility = everything();
    float depth = 0.0f;
    for (; depth < 100.0f; depth += 0.05f) {
        visibility.leastDepth = depth;
        if (!planFor(scene, overTheLake, options, &visibility)[PassId::refraction].wanted) break;
    }
    EXPECT_GT(depth, 5.0f);
    EXPECT_LT(depth, 30.0f);
    const float light = std::exp(-0.4f * (depth - 0.1f));
    const float bed = 0.3f * (16.0f * 80.0f + 20.0f) * light; // lit through the shallowest water that the waves leave
    const float exposed = options.frame.exposure * bed * light / (scene.water.ior * scene.water.ior);
    for (const float base : {0.0f, 0.001f, 0.01f, 0.05f, 0.2f, 1.0f}) {
        const auto shown = [](float value) { return optics::srgbColour(optics::toneAces(vec3(value))).x; };
        EXPECT_LT(shown(base + exposed) - shown(base), 0.5f / 255.0f) << base;
    }
    options.plan.exact = true;
    EXPECT_TRUE(planFor(scene, overTheLake, options, &visibility)[PassId::refraction].wanted);
    options.plan.exact = false;
    scene.pointLights.emplace_back();
    EXPECT_TRUE(planFor(scene, overTheLake, options, &visibility)[PassId::refraction].wanted) << "a lamp at the bed";
}

// Waves of known steepness, one facet after another: none that mirrors a visible lobe is missed.
TEST(PlanRules, NoGlowIsMissedThatAWaveCouldMirror)
{
    Scene scene = lakeScene();
    scene.water.waves = {{0.02f, 2.0f, 0.3f, 0.0f, 0.0f}, {0.01f, 0.7f, 1.4f, 0.0f, 0.0f}};
    const float slope = 2.0f * pi * (0.02f / 2.0f + 0.01f / 0.7f);
    const VisibilityFacts visibility = everything();
    int leftOut = 0;
    for (int turn = 0; turn < 36; ++turn) {
        const float angle = static_cast<float>(turn) * pi / 18.0f;
        const Camera camera = cameraAt({0, 3, 0}, {std::sin(angle) * 10.0f, 1.0f, -std::cos(angle) * 10.0f});
        const FramePlan plan = planFor(scene, camera, {}, &visibility);
        if (plan[PassId::glow].wanted) continue;
        ++leftOut;
        const mat4 worldFromClip = glm::inverse(clipFromView(camera, 4.0f / 3.0f) * viewFromWorld(camera));
        float most = 0.0f;
        for (int i = 0; i < 21 * 21 * 16; ++i) {
            const vec2 at(0.1f * static_cast<float>(i % 21) - 1.0f, 0.1f * static_cast<float>(i / 21 % 21) - 1.0f);
            const vec4 point = worldFromClip * vec4(at, 0.5f, 1.0f);
            const vec3 ray = normalize(vec3(point) / point.w - camera.eye);
            const float about = static_cast<float>(i / 441) * pi / 8.0f;
            const vec3 normal = optics::waveNormal(slope * vec2(std::cos(about), std::sin(about)));
            const vec3 mirrored = optics::reflectRay(-scene.sun->direction, normal);
            most = std::max(most, std::pow(std::max(glm::dot(mirrored, -ray), 1.0e-6f), 200.0f));
        }
        EXPECT_LT(displayChange(FrameOptions::ToneCurve::aces, most), 0.5f / 255.0f) << turn;
    }
    EXPECT_GT(leftOut, 5) << "the sun in the back";
    EXPECT_LT(leftOut, 30);
}

TEST(PlanRules, HiddenWaterIsAskedForAgainBeforeItIsLeftOut)
{
    Scene scene = lakeScene();
    VisibilityFacts visibility = everything();
    EXPECT_FALSE(planFor(scene, overTheLake, {}, &visibility).rule(RuleId::waterHidden).applies);
    visibility.waterWasHidden = true;
    const FramePlan plan = planFor(scene, overTheLake, {}, &visibility);
    EXPECT_TRUE(plan.rule(RuleId::waterHidden).applies);
    EXPECT_TRUE(plan[PassId::water].wanted) << "the depth of the frame decides";
    EXPECT_FALSE(
        planFor(scene, cameraAt({0, 0.05f, 15}, {0, 0, 0}), {}, &visibility).rule(RuleId::waterHidden).applies);
    Options stereo;
    stereo.stereo.output = StereoOptions::Output::sideBySide;
    EXPECT_FALSE(planFor(scene, overTheLake, stereo, &visibility).rule(RuleId::waterHidden).applies);
}

TEST(PlanRules, RawValuesAreThoseOfTheFullFrame)
{
    const PlanOptions plan = planForRawValues({});
    EXPECT_TRUE(plan.allows(RuleId::cullChunks));
    EXPECT_TRUE(plan.allows(RuleId::keepMaps));
    EXPECT_FALSE(plan.allows(RuleId::noBed)) << "paths and hits would be gone";
    EXPECT_FALSE(plan.allows(RuleId::nothingForCaustics));
}

} // namespace tarn
