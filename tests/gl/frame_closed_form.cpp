// Whole frames of scenes whose picture a formula gives.
#include "gl_test.h"
#include "test_renderer.h"
#include "test_scenes.h"

#include "optics/optics.h"
#include "render/renderer.h"
#include "render/view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace tarn::test {

namespace {

constexpr ivec2 pictureSize(320, 240);

/// A camera over the origin's water, looking so many degrees off the vertical, towards -z.
Camera lookDown(float degreesFromVertical, float height = 1.6f)
{
    const float angle = glm::radians(degreesFromVertical);
    Camera camera;
    camera.name = "test";
    camera.eye = vec3(0.0f, height, 0.0f);
    camera.target = camera.eye + vec3(0.0f, -std::cos(angle), -std::sin(angle));
    camera.up = vec3(0.0f, std::sin(angle), -std::cos(angle));
    camera.verticalFov = glm::radians(45.0f);
    camera.farPlane = 500.0f;
    return camera;
}

/// The ray through the centre of a pixel, double precision; y counts from the top.
glm::dvec3 rayThrough(const Camera& camera, int x, int y)
{
    const float aspect = static_cast<float>(pictureSize.x) / static_cast<float>(pictureSize.y);
    const glm::dmat4 worldFromClip =
        glm::inverse(glm::dmat4(clipFromView(camera, aspect)) * glm::dmat4(viewFromWorld(camera)));
    const glm::dvec4 far = worldFromClip * glm::dvec4(2.0 * (x + 0.5) / pictureSize.x - 1.0,
                                                      1.0 - 2.0 * (y + 0.5) / pictureSize.y, 1.0, 1.0);
    return glm::normalize(glm::dvec3(far) / far.w - glm::dvec3(camera.eye));
}

vec2 texelOf(const mat4& clipFromWorld, const vec3& point, int targetSize)
{
    const vec4 clip = clipFromWorld * vec4(point, 1.0f);
    return (vec2(clip) / clip.w * 0.5f + 0.5f) * static_cast<float>(targetSize);
}

bool within(const vec2& texel, int targetSize, float margin)
{
    return texel.x > margin && texel.y > margin && texel.x < static_cast<float>(targetSize) - margin &&
           texel.y < static_cast<float>(targetSize) - margin;
}

} // namespace

struct SnellCase {
    float degrees;
    RefractionOptions::CameraMode camera;
};

class SnellLookup : public testing::TestWithParam<SnellCase> {};

// Flat water over a flat bed: where the refracted ray meets the bed is known, and the lookup must land within a
// texel of it wherever the refraction target sees that place.
TEST_P(SnellLookup, LandsWithinATexelOfSnell)
{
    const float depth = 2.0f;
    const Scene scene = flatLake(depth);
    const Camera camera = lookDown(GetParam().degrees);
    Options options;
    options.refraction.steps = 8;
    options.refraction.camera = GetParam().camera;
    CheckedRenderer renderer(scene, options);
    const Image image = renderer.linear(camera, pictureSize, 0.0, DebugView::positionW);
    const float aspect = static_cast<float>(pictureSize.x) / static_cast<float>(pictureSize.y);
    const mat4 clipFromWorld = refractionView(camera, aspect, scene.water, options, false).clipFromWorld();
    const int size = options.refraction.targetSize;

    int inView = 0;
    int water = 0;
    float worst = 0.0f;
    for (int y = 0; y < pictureSize.y; ++y) {
        for (int x = 0; x < pictureSize.x; ++x) {
            const glm::dvec3 ray = rayThrough(camera, x, y);
            if (pixel(image, x, y).w < 0.5f) continue;
            ++water;
            const glm::dvec3 surface = glm::dvec3(camera.eye) - ray * (camera.eye.y / ray.y);
            const glm::dvec3 refracted = optics64::refractRay(ray, glm::dvec3(0, 1, 0), 1.0 / 1.33);
            const glm::dvec3 hit = surface - refracted * (depth / refracted.y);
            const vec2 expected = texelOf(clipFromWorld, vec3(hit), size);
            // Where the eye's own line through U leaves the bed's picture there is no first look to start from.
            const vec2 start = texelOf(clipFromWorld, vec3(surface), size);
            if (!within(expected, size, 1.0f) || !within(start, size, 1.0f)) continue;
            if (std::abs(hit.x) > 190.0 || std::abs(hit.z) > 190.0) continue; // the bed ends there
            ++inView;
            worst = std::max(worst, glm::distance(expected, texelOf(clipFromWorld, vec3(pixel(image, x, y)), size)));
        }
    }
    EXPECT_GT(water, pictureSize.x * pictureSize.y / 3);
    EXPECT_GT(inView, water / 2);
    EXPECT_LE(worst, 1.0f);
}

INSTANTIATE_TEST_SUITE_P(Angles, SnellLookup,
                         testing::Values(SnellCase{0.0f, RefractionOptions::CameraMode::snell},
                                         SnellCase{30.0f, RefractionOptions::CameraMode::snell},
                                         SnellCase{60.0f, RefractionOptions::CameraMode::snell},
                                         SnellCase{80.0f, RefractionOptions::CameraMode::snell},
                                         SnellCase{0.0f, RefractionOptions::CameraMode::main},
                                         SnellCase{30.0f, RefractionOptions::CameraMode::main},
                                         SnellCase{60.0f, RefractionOptions::CameraMode::main},
                                         SnellCase{80.0f, RefractionOptions::CameraMode::main}),
                         [](const auto& test) {
                             return std::string(test.param.camera == RefractionOptions::CameraMode::snell ? "snell"
                                                                                                          : "main") +
                                    std::to_string(static_cast<int>(test.param.degrees));
                         });

// The picture's F is the formula's, from straight down to the horizon.
void expectFresnel(CheckedRenderer& renderer, const std::function<double(double cosine)>& formula,
                   double tolerance = 2.0e-6)
{
    for (const float degrees : {0.0f, 30.0f, 60.0f, 80.0f}) {
        const Camera camera = lookDown(degrees);
        const Image image = renderer.linear(camera, pictureSize, 0.0, DebugView::fresnel);
        double worst = 0.0;
        int water = 0;
        for (int y = 0; y < pictureSize.y; ++y) {
            for (int x = 0; x < pictureSize.x; ++x) {
                const vec4 value = pixel(image, x, y);
                if (value.w < 0.5f) continue;
                ++water;
                const double cosine = -static_cast<double>(rayThrough(camera, x, y).y);
                // Towards the horizon the surface point's own rounding turns the ray: leave its last 50 m out.
                if (cosine < 0.02) continue;
                worst = std::max(worst, std::abs(formula(cosine) - static_cast<double>(value.x)));
            }
        }
        EXPECT_GT(water, 1000);
        EXPECT_LE(worst, tolerance) << degrees << " degrees";
    }
}

TEST(FrameClosedForm, FresnelIsExact)
{
    const Scene scene = flatLake(2.0f);
    CheckedRenderer renderer(scene);
    expectFresnel(renderer, [](double c) { return optics64::fresnelExact(c, 1.0 / 1.33); });
}

TEST(FrameClosedForm, FresnelIsSchlicksWhereThatIsAskedFor)
{
    const Scene scene = flatLake(2.0f);
    Options options;
    options.water.fresnel = WaterOptions::Fresnel::schlick;
    CheckedRenderer renderer(scene, options);
    expectFresnel(renderer, [](double c) { return optics64::fresnelSchlick(c, 1.33, 5.0); });
}

// The table's own error is that of tests/unit/optics_fresnel_table.cpp; it follows size, filter and index of
// refraction.
TEST(FrameClosedForm, FresnelIsTheTablesWhereThatIsAskedFor)
{
    const Scene scene = flatLake(2.0f);
    Options options;
    options.water.fresnel = WaterOptions::Fresnel::table;
    CheckedRenderer renderer(scene, options);
    for (const float ior : {1.33f, 1.5f})
        for (const int size : {64, 1024})
            for (const optics::TableFilter filter : {optics::TableFilter::linear, optics::TableFilter::nearest}) {
                options.water.fresnelTable = size;
                options.water.fresnelFilter = filter;
                WaterBody water = scene.water;
                water.ior = ior;
                renderer.setOptions(options, water);
                const double n = static_cast<double>(ior);
                if (filter == optics::TableFilter::linear) {
                    // Graphics cards blend by weights of 8 bits: up to 1/512 of the step between two texels.
                    const optics::FresnelTable table = optics::makeFresnelTable(ior, size, filter);
                    const double step = 2.0 * (1.0 + n * n) / std::sqrt(n * n - 1.0) / (size - 1);
                    expectFresnel(
                        renderer, [&table](double c) { return static_cast<double>(table.at(static_cast<float>(c)).y); },
                        step / 512.0 + 2.0e-6);
                } else {
                    // At a texel's edge rounding chooses between two.
                    const double half = (1.0 + n * n) / (size * std::sqrt(n * n - 1.0));
                    expectFresnel(
                        renderer, [n](double c) { return optics64::fresnelExact(c, 1.0 / n); }, half + 2.0e-6);
                }
            }
}

// Clear, still water over a bed of albedo 1/2 under a white sky, seen straight from above:
// (1 - F) / n² of the bed's radiance and F of the sky's.
TEST(FrameClosedForm, RadianceOfTheBedIsDividedByTheSquareOfTheIndex)
{
    const Scene scene = flatLake(2.0f);
    Options options;
    options.frame.msaa = 1;
    CheckedRenderer renderer(scene, options);
    const Image image = renderer.linear(lookDown(0.0f), pictureSize);
    const double f = optics64::fresnelSchlick(1.0, 1.33, 5.0);
    const double irradianceBelow = std::numbers::pi * 0.934; // of the uniform sky, under the surface
    const double bed = 0.5 / std::numbers::pi * irradianceBelow;
    const double expected = f * 1.0 + (1.0 - f) / (1.33 * 1.33) * bed;
    const vec4 centre = pixel(image, pictureSize.x / 2, pictureSize.y / 2);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(centre[c], expected, 0.005 * expected);
}

// Beer–Lambert down and up: a black sky, a sun overhead and water that absorbs red.
TEST(FrameClosedForm, SunlightIsAbsorbedOnItsWayDownAndUp)
{
    const float depth = 3.0f;
    Scene scene = flatLake(depth);
    scene.sky.radiance = vec3(0.0f);
    Sun sun;
    sun.automatic = false;
    sun.irradiance = vec3(10.0f);
    // Off the zenith, so that its mirror image is not in the picture's middle.
    sun.direction = normalize(vec3(1.0f, 1.0f, 0.0f));
    scene.sun = sun;
    scene.water.absorption = vec3(0.3f, 0.1f, 0.0f);
    Options options;
    options.frame.msaa = 1;
    CheckedRenderer renderer(scene, options);
    const vec4 centre = pixel(renderer.linear(lookDown(0.0f), pictureSize), pictureSize.x / 2, pictureSize.y / 2);

    const double cosAir = sun.direction.y;
    const double cosWater = std::sqrt(1.0 - (1.0 - cosAir * cosAir) / (1.33 * 1.33));
    const double in = 10.0 * cosAir * (1.0 - optics64::fresnelExact(cosAir, 1.0 / 1.33));
    const double out = (1.0 - optics64::fresnelSchlick(1.0, 1.33, 5.0)) / (1.33 * 1.33);
    for (int c = 0; c < 3; ++c) {
        const double k = scene.water.absorption[c];
        const double expected =
            out * 0.5 / std::numbers::pi * in * std::exp(-k * depth / cosWater) * std::exp(-k * depth);
        EXPECT_NEAR(centre[c], expected, 0.01 * expected) << "channel " << c;
    }
}

// A thin leaf lit from behind: its transmission is a share of its reflectance.
TEST(FrameClosedForm, ALeafPassesLightOn)
{
    Scene scene;
    scene.sky.kind = Sky::Kind::constant;
    scene.sky.radiance = vec3(0.0f);
    scene.sun = Sun{normalize(vec3(1.0f, 2.0f, 0.0f)), vec3(10.0f), false};
    scene.materials.resize(1);
    scene.materials[0].diffuse = vec3(0.5f, 0.4f, 0.3f);
    scene.materials[0].twoSided = true;
    addFloor(scene, 3.0f, 10.0f, 0);
    for (Vertex& vertex : scene.meshes[0].vertices) vertex.normal = vec3(0.0f, -1.0f, 0.0f); // of the crown's far side
    Camera camera = lookDown(0.0f);
    camera.eye = vec3(0.0f);
    camera.target = vec3(0.0f, 3.0f, 0.0f);
    scene.materials[0].alphaTested = true;
    for (const vec3 transmission : {vec3(0.6f, 0.5f, 0.0f), vec3(0.0f)}) {
        scene.materials[0].transmission = transmission;
        Options options;
        options.frame.msaa = 1;
        CheckedRenderer renderer(scene, options);
        const vec4 centre = pixel(renderer.linear(camera, pictureSize), pictureSize.x / 2, pictureSize.y / 2);
        for (int c = 0; c < 3; ++c) {
            const double passed = static_cast<double>(scene.materials[0].diffuse[c] * transmission[c]);
            const double expected = passed / std::numbers::pi * 10.0 * 2.0 / std::sqrt(5.0);
            EXPECT_NEAR(centre[c], expected, 0.002 * expected + 1.0e-6) << "channel " << c;
        }
    }
}

// An island: where its top stands over the surface there is no water, and the debug views say so.
TEST(FrameClosedForm, NoWaterWhereThereIsNone)
{
    Scene scene = flatLake(2.0f);
    addBox(scene, {-0.3f, -2.0f, -0.3f}, {0.3f, 0.5f, 0.3f}, addMaterial(scene, vec3(0.2f)));
    const Camera camera = lookDown(0.0f);
    CheckedRenderer renderer(scene);
    const Image image = renderer.linear(camera, pictureSize, 0.0, DebugView::pathLength);
    int wrong = 0;
    for (int y = 0; y < pictureSize.y; ++y) {
        for (int x = 0; x < pictureSize.x; ++x) {
            const glm::dvec3 ray = rayThrough(camera, x, y);
            const glm::dvec3 top = glm::dvec3(camera.eye) - ray * ((camera.eye.y - 0.5) / ray.y);
            const double edge = std::max(std::abs(top.x), std::abs(top.z)) - 0.3;
            if (std::abs(edge) < 0.01) continue; // the pixels of its outline
            const bool isWater = pixel(image, x, y).w > 0.5f;
            // Beside the top its sides are not seen from above: there is water up to them.
            if (isWater != (edge > 0.0)) ++wrong;
        }
    }
    EXPECT_EQ(wrong, 0);

    scene.water.present = false;
    CheckedRenderer dry(scene);
    dry.linear(camera, pictureSize);
    EXPECT_FALSE(dry.stats.plan[PassId::water].wanted);
    EXPECT_FALSE(dry.stats.plan[PassId::refraction].wanted);
}

// A post in flat water: its mirror image continues it, within a pixel at the waterline and at its top.
TEST(FrameClosedForm, ReflectionContinuesAPost)
{
    Scene scene = flatLake(4.0f);
    scene.sky.radiance = vec3(0.0f);
    Material glowing;
    glowing.name = "glowing";
    glowing.diffuse = vec3(0.0f);
    glowing.emissive = vec3(100.0f, 0.0f, 0.0f);
    scene.materials.push_back(glowing);
    const float top = 1.5f;
    addBox(scene, {-0.1f, 0.0f, -8.1f}, {0.1f, top, -8.0f}, static_cast<int>(scene.materials.size()) - 1);

    Camera camera = lookDown(85.0f, 1.5f);
    Options options;
    options.frame.msaa = 1;
    options.refraction.enabled = false;
    options.reflection.targetSize = 1024;
    CheckedRenderer renderer(scene, options);
    const Image image = renderer.linear(camera, pictureSize);

    const float aspect = static_cast<float>(pictureSize.x) / static_cast<float>(pictureSize.y);
    const mat4 clipFromWorld = clipFromView(camera, aspect) * viewFromWorld(camera);
    const auto rowOf = [&](const vec3& point) {
        const vec4 clip = clipFromWorld * vec4(point, 1.0f);
        return (0.5f - 0.5f * clip.y / clip.w) * static_cast<float>(pictureSize.y);
    };
    // Mirrored, the post reaches from the waterline to -top; every row between must be its red.
    const float waterline = rowOf(vec3(0.0f, 0.0f, -8.0f));
    const float bottom = rowOf(vec3(0.0f, -top, -8.0f));
    ASSERT_LT(bottom, static_cast<float>(pictureSize.y) - 2.0f);
    const auto isRed = [&](int row) {
        const vec4 p = pixel(image, pictureSize.x / 2, row);
        return p.x > 0.5f && p.x > 4.0f * p.y;
    };
    for (int row = static_cast<int>(waterline) - 5; row + 1 < static_cast<int>(bottom); ++row)
        EXPECT_TRUE(isRed(row)) << "row " << row << " of a post down to " << bottom;
    EXPECT_FALSE(isRed(static_cast<int>(bottom) + 2));
    // Its sides stand over each other.
    const auto leftEdge = [&](int row) {
        for (int x = 0; x < pictureSize.x; ++x)
            if (pixel(image, x, row).x > 0.5f) return x;
        return -1;
    };
    EXPECT_NEAR(leftEdge(static_cast<int>(waterline) - 5), leftEdge(static_cast<int>(waterline) + 5), 1);
}

} // namespace tarn::test
