// Which part of a picture's error each approximation owns: the sums, and the approximations that the
// reference makes.
#include "app/error_budget.h"
#include "app/trade_experiment.h"
#include "measure/trade/trade_json.h"
#include "test_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tarn {
namespace {

using reference::Picture;
using reference::Tracer;
using reference::ViewRequest;

constexpr double none = ErrorBudget::none;

ErrorBudget someBudget()
{
    return {
        .quantity = "mean FLIP",
        .rows = {{"refraction", 0.03, 0.02, "refraction.steps=24"}, {"shadow map", none, -0.005}, {"clip", 0.01, none}},
        .total = 0.06,
        .together = 0.035,
        .remaining = 0.02,
        .noise = 0.004,
        .unmodelled = none};
}

TEST(ErrorBudget, SumsLeaveOutWhatIsNotMeasured)
{
    EXPECT_DOUBLE_EQ(sumOfParts(someBudget(), &ErrorBudget::Row::alone), 0.04);
    EXPECT_DOUBLE_EQ(sumOfParts(someBudget(), &ErrorBudget::Row::removed), 0.015);
    EXPECT_TRUE(std::isnan(sumOfParts({}, &ErrorBudget::Row::alone)));
}

TEST(ErrorBudget, TableShowsPartsWholeAndWhatIsUnexplained)
{
    const std::string table = budgetTable(someBudget());
    for (const char* line :
         {"  refraction                           0.0300     0.0200  refraction.steps=24\n",
          "  shadow map                                -    -0.0050\n",
          "  sum of the parts                     0.0400     0.0150\n",
          "  all at once                          0.0350     0.0400\n",
          "  the frame                                       0.0600  its error as it is\n",
          "  unexplained                                     0.0200  its error with all of them taken out\n"})
        EXPECT_NE(table.find(line), std::string::npos) << line << "is not in\n" << table;
}

TEST(ErrorBudget, JsonKeepsEverything)
{
    const ErrorBudget budget = someBudget();
    const nlohmann::json json = toJson(budget);
    EXPECT_TRUE(json["rows"][1]["alone"].is_null());
    EXPECT_TRUE(json["unmodelled"].is_null());
    const ErrorBudget back = budgetFrom(nlohmann::json::parse(json.dump()));
    EXPECT_EQ(budgetTable(back), budgetTable(budget));
    EXPECT_EQ(back.rows.size(), 3u);
}

/// A box over a lake whose bed has a ramp of light on it.
Scene rampLake(bool hasWaves)
{
    constexpr float edge = 40.0f;
    Scene scene = test::flatLake(1.0f, edge);
    if (hasWaves) scene.water.waves = {{0.04f, 2.0f, 0.3f, 0.4f, 0.0f}, {0.02f, 0.9f, 1.9f, 0.0f, 0.0f}};
    Image ramp;
    ramp.width = 256;
    ramp.height = 1;
    ramp.channels = 3;
    for (int i = 0; i < 256; ++i) ramp.floats.insert(ramp.floats.end(), 3, (static_cast<float>(i) + 0.5f) / 256.0f);
    scene.images.push_back(ramp);
    scene.materials[0].diffuse = vec3(0.0f);
    scene.materials[0].emissive = vec3(4.0f);
    scene.materials[0].emissiveMap = 0;
    for (Vertex& vertex : scene.meshes[0].vertices) vertex.uv = vec2(vertex.position.x / edge + 0.5f, 0.5f);
    const int lamp = test::addMaterial(scene, vec3(0.0f));
    scene.materials[static_cast<std::size_t>(lamp)].emissive = vec3(5.0f, 2.0f, 0.5f);
    test::addBox(scene, {-2.0f, 0.5f, -6.0f}, {2.0f, 2.5f, -5.0f}, lamp);
    return scene;
}

Camera lakeCamera()
{
    Camera camera;
    camera.eye = {0.5f, 2.0f, 4.0f};
    camera.target = {0.0f, 0.0f, -2.0f};
    camera.verticalFov = glm::radians(45.0f);
    return camera;
}

constexpr ivec2 size{32, 24};

const BudgetPart& partOf(const std::vector<BudgetPart>& parts, const std::string& name)
{
    const auto found =
        std::find_if(parts.begin(), parts.end(), [&](const BudgetPart& part) { return part.name == name; });
    if (found == parts.end()) throw std::out_of_range(name);
    return *found;
}

/// Mean difference of radiance that a part makes in the reference.
double madeBy(const char* part, const Scene& scene, const Options& options)
{
    const Settings settings{options, scene.water};
    const ViewRequest exact{.camera = lakeCamera(), .size = size, .approximations = {}};
    ViewRequest rough = exact;
    Scene light; // the bed's few triangles would rule the flat camera out; rays do not mind them
    light.water = scene.water;
    light.sun = scene.sun;
    partOf(budgetParts(light, settings, exact.camera, size), part).approximate(rough);
    const reference::ReferenceOptions few{.samples = 4, .photons = 10'000};
    const auto pictures = Tracer(scene, scene.water).renderAll({{exact, few}, {rough, few}});
    double sum = 0.0;
    for (std::size_t i = 0; i < pictures[0].pixels(); ++i)
        sum += static_cast<double>(glm::length(pictures[1].radiance[i] - pictures[0].radiance[i]));
    return sum / static_cast<double>(pictures[0].pixels());
}

Options withReflection(ReflectionOptions::Method method, int steps, float distance)
{
    Options options;
    options.reflection.method = method;
    options.reflection.steps = steps;
    options.reflection.distance = distance;
    return options;
}

Options withRefraction(RefractionOptions::CameraMode mode, int steps)
{
    Options options;
    options.refraction.camera = mode;
    options.refraction.steps = steps;
    return options;
}

using Mirror = ReflectionOptions::Method;
using Moved = RefractionOptions::CameraMode;

TEST(Approximations, StillWaterMirrorsAndShowsItsBedExactly)
{
    const Scene still = rampLake(false);
    for (const float c : {0.0f, 1.0f, 50.0f})
        EXPECT_LT(madeBy("reflection lookup", still, withReflection(Mirror::distance, 1, c)), 1e-3) << c;
    EXPECT_LT(madeBy("reflection lookup", still, withReflection(Mirror::iterative, 8, 1.0f)), 1e-3);
    for (const Moved mode : {Moved::main, Moved::flat})
        EXPECT_LT(madeBy("moved camera's coverage", still, withRefraction(mode, 3)), 1e-3);
    // What that camera shows at once is what a flat surface shows.
    EXPECT_LT(madeBy("intersection", still, withRefraction(Moved::flat, 1)), 1e-3);
}

TEST(Approximations, WavesTellLookupsFromTheTruth)
{
    const Scene lake = rampLake(true);
    const double near = madeBy("reflection lookup", lake, withReflection(Mirror::distance, 1, 1.0f));
    EXPECT_GT(near, 0.01);
    // The box stands some seven metres along the rays.
    EXPECT_LT(madeBy("reflection lookup", lake, withReflection(Mirror::distance, 1, 7.0f)), 0.8 * near);
    // A search from the sky's distance may step over so small a thing, but not over a shore with something on
    // it.
    Scene shore = rampLake(true);
    test::addBox(shore, {-30.0f, -0.5f, -7.0f}, {30.0f, 9.0f, -6.5f}, test::addMaterial(shore, vec3(0.2f)));
    const double close = madeBy("reflection lookup", shore, withReflection(Mirror::distance, 1, 1.0f));
    EXPECT_GT(close, 0.01);
    EXPECT_LT(madeBy("reflection lookup", shore, withReflection(Mirror::iterative, 16, 1.0f)), 0.3 * close);
    const double planar = madeBy("intersection", lake, withRefraction(Moved::main, 1));
    EXPECT_GT(planar, 0.005);
    EXPECT_LT(madeBy("intersection", lake, withRefraction(Moved::main, 16)), 0.2 * planar);
    EXPECT_LT(madeBy("moved camera's coverage", lake, withRefraction(Moved::flat, 1)), 1e-3);
}

TEST(Approximations, FineGridsAndMapsAreTheTruth)
{
    const Scene lake = rampLake(true);
    Options options;
    options.water.normals = WaterOptions::Normals::vertex;
    for (const char* part : {"tessellation", "normals of vertices"}) {
        options.water.gridSize = 33;
        const double coarse = madeBy(part, lake, options);
        EXPECT_GT(coarse, 1e-3) << part;
        options.water.gridSize = 1025;
        EXPECT_LT(madeBy(part, lake, options), 0.05 * coarse) << part;
    }
    for (const Moved mode : {Moved::main, Moved::snell, Moved::flat}) {
        Options coarse = withRefraction(mode, 3), fine = coarse;
        coarse.refraction.targetSize = coarse.reflection.targetSize = 16;
        fine.refraction.targetSize = fine.reflection.targetSize = 4096;
        for (const char* part : {"refraction texture", "reflection texture"}) {
            EXPECT_GT(madeBy(part, lake, coarse), 1e-3) << part;
            EXPECT_LT(madeBy(part, lake, fine), 0.1 * madeBy(part, lake, coarse)) << part;
        }
    }
    EXPECT_EQ(madeBy("Schlick's Fresnel", lake, Options{}), 0.0); // the frame's is exact
    options.water.fresnel = WaterOptions::Fresnel::schlick;
    EXPECT_GT(madeBy("Schlick's Fresnel", lake, options), 1e-3);
    options.water.fresnel = WaterOptions::Fresnel::table;
    options.water.fresnelTable = 16;
    const double coarse = madeBy("Fresnel's table", lake, options);
    EXPECT_GT(coarse, 1e-4);
    options.water.fresnelTable = 4096;
    EXPECT_LT(madeBy("Fresnel's table", lake, options), 0.02 * coarse);
    options.water.attenuation = WaterOptions::Attenuation::linear;
    EXPECT_GT(madeBy("linear attenuation", lake, options), 1e-3);
}

TEST(Approximations, AFineShadowMapCastsTheTrueShadow)
{
    Scene scene = test::flatLake(1.0f, 10.0f);
    scene.sun = Sun{glm::normalize(vec3(0.5f, 1.0f, 0.3f)), vec3(10.0f), false};
    const int stone = test::addMaterial(scene, vec3(0.5f));
    test::addFloor(scene, 0.1f, 12.0f, stone); // over the water
    test::addBox(scene, {-1.0f, 1.0f, -2.0f}, {1.0f, 1.5f, 0.0f}, stone);
    Options options;
    options.sunlight.mapSize = 16;
    const double coarse = madeBy("shadow map", scene, options);
    EXPECT_GT(coarse, 0.02);
    options.sunlight.mapSize = 8192;
    EXPECT_LT(madeBy("shadow map", scene, options), 0.15 * coarse);
}

/// With still water all of the sun's light is even, whatever the texel and the filter.
TEST(Approximations, TheCausticsMapOfStillWaterIsEven)
{
    Scene scene = test::flatLake(0.5f, 30.0f);
    scene.sky.radiance = vec3(0.0f);
    scene.sun = Sun{glm::normalize(vec3(0.3f, 1.0f, 0.2f)), vec3(10.0f), false};
    const ViewRequest flat{.camera = lakeCamera(), .size = size, .flatLight = true, .approximations = {}};
    ViewRequest map = flat;
    map.flatLight = false;
    map.causticsTexture = {.rect = {0.0f, 0.0f, 16.0f, 16.0f}, .texel = 0.25, .filter = 2};
    const reference::ReferenceOptions options{.samples = 4, .photons = 1'000'000};
    const auto pictures = Tracer(scene, scene.water).renderAll({{flat, options}, {map, options}});
    double sum = 0.0, difference = 0.0;
    for (std::size_t i = 0; i < pictures[0].pixels(); ++i) {
        sum += static_cast<double>(pictures[0].radiance[i].y);
        difference += static_cast<double>(std::abs(pictures[1].radiance[i].y - pictures[0].radiance[i].y));
    }
    EXPECT_GT(sum, 0.0);
    EXPECT_LT(difference, 0.02 * sum);
}

TEST(BudgetParts, AreOptionsThatThereAre)
{
    const Scene lake = rampLake(true);
    Camera diver = lakeCamera();
    diver.eye.y = -0.5f;
    for (const Camera& camera : {lakeCamera(), diver}) {
        const Settings settings{Options{}, lake.water};
        const auto parts = budgetParts(lake, settings, camera, size);
        Settings exact = settings;
        for (const BudgetPart& part : parts)
            EXPECT_NO_THROW(exact = changedSettings(exact, part.exact, part.name)) << part.name;
        // Whatever is exact stays so: nothing is left to be taken out.
        for (const BudgetPart& part : budgetParts(lake, exact, camera, size))
            EXPECT_EQ(settingsJson(changedSettings(exact, part.exact, part.name)), settingsJson(exact)) << part.name;
    }
    EXPECT_FALSE(partOf(budgetParts(lake, {Options{}, lake.water}, diver, size), "reflection lookup").approximate);
}

TEST(Approximations, AreInThePicturesIdentity)
{
    const Scene lake = rampLake(true);
    const Tracer tracer(lake, lake.water);
    const ViewRequest exact{.camera = lakeCamera(), .size = size, .approximations = {}};
    Options options;
    options.water.normals = WaterOptions::Normals::vertex;
    options.water.fresnel = WaterOptions::Fresnel::schlick;
    for (const BudgetPart& part : budgetParts(lake, {options, lake.water}, exact.camera, size)) {
        if (!part.approximate) continue;
        ViewRequest rough = exact;
        part.approximate(rough);
        EXPECT_NE(tracer.identity(rough, {}), tracer.identity(exact, {})) << part.name;
    }
}

} // namespace
} // namespace tarn
