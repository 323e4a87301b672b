// The caustics texture: its units, its energy, its four methods against each other, and where light gathers.
#include "gl_test.h"
#include "test_renderer.h"
#include "test_scenes.h"

#include "optics/optics.h"
#include "optics/waves.h"
#include "render/passes/caustics.h"
#include "render/renderer.h"
#include "render/sun_views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tarn::test {

namespace {

using Method = CausticsOptions::Method;
constexpr Method methods[] = {Method::cpu, Method::points, Method::fetch, Method::mesh};

/// A pool over a floor that reaches past its edges, so that no light is lost beside it.
Scene pool(float depth, float edge, float elevationDegrees)
{
    Scene scene = flatLake(depth, edge, edge + 12.0f * depth);
    scene.sky.radiance = vec3(0.0f);
    const float e = glm::radians(elevationDegrees);
    scene.sun = Sun{glm::normalize(vec3(0.8f * std::cos(e), std::sin(e), 0.6f * std::cos(e))), vec3(1.0f), false};
    return scene;
}

void addWaves(Scene& scene, float scale)
{
    scene.water.waves = {{0.020f * scale, 1.3f, 0.3f, 0.0f, 0.0f},
                         {0.012f * scale, 0.8f, 1.9f, 1.0f, 0.0f},
                         {0.006f * scale, 0.45f, -0.9f, 2.0f, 0.0f}};
}

Camera eyeOverThePool()
{
    Camera camera;
    camera.eye = vec3(0.0f, 3.0f, 0.1f);
    camera.target = vec3(0.0f);
    return camera;
}

/// The texture, four floats a texel, rows from -z to +z.
std::vector<float> texture(const Scene& scene, const Options& options, double time = 0.0)
{
    const int edge = options.caustics.textureSize;
    const Image image =
        CheckedRenderer(scene, options).linear(eyeOverThePool(), {edge, edge}, time, DebugView::caustics);
    std::vector<float> rows;
    for (int y = edge - 1; y >= 0; --y) {
        const auto row = image.floats.begin() + static_cast<std::ptrdiff_t>(y) * edge * 4;
        rows.insert(rows.end(), row, row + static_cast<std::ptrdiff_t>(edge) * 4);
    }
    return rows;
}

/// A ray of the sun that meets the waves.
struct Ray {
    glm::dvec3 surface;
    glm::dvec3 refracted;
    double transmittance;
};

/// Through places of the level, in double precision.
class Rays {
public:
    Rays(const Scene& scene, const glm::dvec3& toSun) : toSun_(toSun)
    {
        for (const Wave& w : scene.water.waves)
            terms_.push_back(optics64::makeWaveTerm(w.amplitude, w.wavelength, w.direction, w.phase));
    }

    Ray from(const glm::dvec2& plane) const
    {
        glm::dvec2 x = plane; // on the ray, at the waves' height: a contraction for slopes like these
        for (int k = 0; k < 30; ++k) x = plane + optics64::sunShear(toSun_) * optics64::waveHeight(terms_, x, 0.0);
        const glm::dvec3 normal = optics64::waveNormalAt(terms_, x, 0.0);
        const double cosine = std::max(glm::dot(normal, toSun_), 0.0);
        return {{x.x, optics64::waveHeight(terms_, x, 0.0), x.y},
                optics64::refractRay(-toSun_, normal, 1.0 / 1.33),
                1.0 - optics64::fresnelExact(cosine, 1.0 / 1.33)};
    }

private:
    std::vector<optics64::WaveTerm> terms_;
    glm::dvec3 toSun_;
};

double sum(const std::vector<float>& texels, std::size_t channel)
{
    double total = 0.0;
    for (std::size_t i = channel; i < texels.size(); i += 4) total += static_cast<double>(texels[i]);
    return total;
}

} // namespace

// Flat water: Fresnel's transmittance times the attenuation of the slanted path, in every channel and method.
TEST(FrameCaustics, FlatWaterGivesTransmittanceTimesAttenuation)
{
    for (const float elevation : {90.0f, 45.0f, 15.0f}) {
        Scene scene = pool(2.0f, 12.0f, elevation);
        scene.water.absorption = vec3(0.5f, 0.2f, 0.05f);
        const double cosine = static_cast<double>(scene.sun->direction.y);
        const double t = 1.0 - optics64::fresnelExact(cosine, 1.0 / 1.33);
        const double cosBelow = std::sqrt(1.0 - (1.0 - cosine * cosine) / (1.33 * 1.33));
        for (const Method method : methods) {
            Options options;
            options.caustics.method = method;
            const std::vector<float> texels = texture(scene, options);
            for (int y = 20; y < 236; ++y) {
                for (int x = 20; x < 236; ++x) {
                    for (int c = 0; c < 3; ++c) {
                        const double expected =
                            t * std::exp(-static_cast<double>(scene.water.absorption[c]) * 2.0 / cosBelow);
                        const double got = static_cast<double>(
                            texels[static_cast<std::size_t>(y * 256 + x) * 4 + static_cast<std::size_t>(c)]);
                        ASSERT_NEAR(got, expected, 0.01 * expected)
                            << "method " << static_cast<int>(method) << ", elevation " << elevation << ", texel " << x
                            << ", " << y << ", channel " << c;
                    }
                }
            }
        }
    }
}

// Whatever the waves do to it, the light that enters arrives: no absorption, and a texture that holds all of it.
TEST(FrameCaustics, WavesMoveLightAndKeepIt)
{
    for (const float elevation : {90.0f, 45.0f, 25.0f}) {
        Scene scene = pool(1.5f, 6.0f, elevation);
        addWaves(scene, 1.0f);
        // What enters, ray by ray over the level, in double precision: rows of the lattice that the photons start on.
        const Rays rays(scene, glm::dvec3(scene.sun->direction));
        double entering = 0.0;
        constexpr int n = 400;
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                entering += rays.from({6.0 * ((i + 0.5) / n - 0.5), 6.0 * ((j + 0.5) / n - 0.5)}).transmittance * 36.0 /
                            (n * n);
        for (const Method method : methods) {
            Options options;
            options.caustics.method = method;
            const double texel = 6.0 * 1.05 / 256.0;
            const double arrived = sum(texture(scene, options), 0) * texel * texel;
            EXPECT_NEAR(arrived, entering, 0.01 * entering)
                << "method " << static_cast<int>(method) << ", elevation " << elevation;
        }
    }
}

// A texture that covers a part of the water: its light and what left it make up what entered there. Every photon is
// followed on its own, in double precision and without any picture of the bed.
TEST(FrameCaustics, WhatLeavesTheTextureIsAllThatIsMissing)
{
    Scene scene = pool(2.0f, 6.0f, 40.0f);
    addWaves(scene, 2.0f);
    Options options;
    options.caustics.extent = 2.0f;
    const CausticsRegion region = causticsRegion(scene.water, eyeOverThePool(), options.caustics);
    ASSERT_FLOAT_EQ(region.rect.halfExtent.x, 1.0f);
    const glm::dvec3 toSun(scene.sun->direction);
    const glm::dvec3 toSunBelow = optics64::refractedSunDirection(toSun, 1.33);
    const Rays rays(scene, toSun);
    double entered = 0.0, stayed = 0.0;
    const int edge = options.caustics.photons;
    for (int j = 0; j < edge; ++j) {
        for (int i = 0; i < edge; ++i) {
            const glm::dvec2 lattice(2.0 * (i + 0.5) / edge - 1.0, 2.0 * (j + 0.5) / edge - 1.0);
            const Ray ray = rays.from(glm::dvec2(region.rect.centre) + lattice);
            const glm::dvec3 hit = ray.surface + ray.refracted * ((-2.0 - ray.surface.y) / ray.refracted.y);
            const glm::dvec2 place =
                optics64::sunPlane(hit, 0.0, optics64::sunShear(toSunBelow)) - glm::dvec2(region.rect.centre);
            const double light = ray.transmittance * 4.0 / (edge * edge);
            entered += light;
            if (std::max(std::abs(place.x), std::abs(place.y)) <= 1.0) stayed += light;
        }
    }
    EXPECT_LT(stayed, 0.99 * entered); // some do leave
    for (const Method method : methods) {
        options.caustics.method = method;
        const double arrived = sum(texture(scene, options), 0) * 4.0 / (256.0 * 256.0);
        // The mesh ends at the middles of the outermost photons' cells.
        const double rim = method == Method::mesh ? std::pow((edge - 1.0) / edge, 2.0) : 1.0;
        EXPECT_NEAR(arrived, rim * stayed, 0.01 * stayed) << "method " << static_cast<int>(method);
    }
}

TEST(FrameCaustics, ThePointMethodsAgree)
{
    Scene scene = pool(2.0f, 6.0f, 50.0f);
    scene.water.absorption = vec3(0.4f, 0.1f, 0.05f);
    addWaves(scene, 1.5f);
    Options options;
    options.caustics.photons = 384; // independent of the texture's size
    options.caustics.method = Method::cpu;
    const std::vector<float> cpu = texture(scene, options);
    for (const Method method : {Method::points, Method::fetch}) {
        options.caustics.method = method;
        const std::vector<float> gpu = texture(scene, options);
        ASSERT_EQ(gpu.size(), cpu.size());
        for (std::size_t i = 0; i < cpu.size(); ++i)
            // The shown texture is of half floats, which hold the dim rim less well.
            ASSERT_NEAR(gpu[i], cpu[i], 1.0e-3f * std::max(cpu[i], 0.05f)) << "method " << static_cast<int>(method);
    }
}

// 4,096 photons a texel: sums do not saturate, nor lose the small ones.
TEST(FrameCaustics, ManyPhotonsDoNotSaturate)
{
    const Scene scene = pool(2.0f, 6.0f, 90.0f);
    const double t = 1.0 - optics64::fresnelExact(1.0, 1.0 / 1.33);
    for (const Method method : methods) {
        Options options;
        options.caustics.method = method;
        options.caustics.textureSize = 16;
        options.caustics.photons = 1024;
        const std::vector<float> texels = texture(scene, options);
        EXPECT_NEAR(static_cast<double>(texels[(8 * 16 + 8) * 4]), t, 0.01 * t) << static_cast<int>(method);
    }
    // And where all of them meet in one place.
    std::vector<float> photons;
    for (int i = 0; i < 1 << 18; ++i)
        photons.insert(photons.end(), {0.5f + 0.5f / 16.0f, 0.5f + 0.5f / 16.0f, 1.0f, 0.0f});
    EXPECT_NEAR(gatherPhotons(photons, 16, vec3(0.0f))[(8 * 16 + 8) * 4], static_cast<float>(1 << 18), 1.0f);
}

// A sine wave under a zenith sun is a row of lenses: on the axis of a crest the light at depth d, in front of the focal
// depth f = n / ((n - 1) A k²), is 1 / (1 - d / f) of what falls on it, and it is brightest there.
TEST(FrameCaustics, ASineWaveGathersLightUnderItsCrests)
{
    const double amplitude = 0.02, wavelength = 1.0;
    const double k = 2.0 * std::numbers::pi / wavelength;
    const double focus = 1.33 / (0.33 * amplitude * k * k);
    const double depth = 0.5 * focus;
    Scene scene = pool(static_cast<float>(depth), 4.0f, 90.0f);
    scene.water.waves = {{static_cast<float>(amplitude), static_cast<float>(wavelength), 0.0f, 0.0f, 1.0f}};
    for (const Method method : methods) {
        Options options;
        options.caustics.method = method;
        options.caustics.filter = 0;
        options.caustics.photons = 768;
        const std::vector<float> texels = texture(scene, options);
        const double texel = 4.0 * 1.05 / 256.0;
        const auto at = [&](int x) { return static_cast<double>(texels[static_cast<std::size_t>(128 * 256 + x) * 4]); };
        for (const double crest : {-0.75, 0.25}) {
            const int centre = static_cast<int>(crest / texel + 128.0);
            int brightest = centre - 20;
            for (int x = centre - 20; x <= centre + 20; ++x)
                if (at(x) > at(brightest)) brightest = x;
            EXPECT_NEAR((brightest + 0.5 - 128.0) * texel, crest, texel) << static_cast<int>(method);
            const double t = 1.0 - optics64::fresnelExact(1.0, 1.0 / 1.33);
            const double gain = (at(centre - 1) + at(centre) + at(centre + 1)) / (3.0 * t);
            // d = depth under the crest; from the gain to the focal depth that would give it.
            EXPECT_NEAR((depth + amplitude) / (1.0 - 1.0 / gain), focus, 0.05 * focus) << static_cast<int>(method);
        }
    }
}

// What the default settings cost in truth: against 16 times the photons, and from one frame to the next against the
// light's own change. (Points open gaps where waves spread them; the filter must hide that.)
TEST(FrameCaustics, TheDefaultIsCloseToManyPhotonsAndDoesNotFlicker)
{
    Scene scene = pool(2.0f, 6.0f, 55.0f);
    addWaves(scene, 1.0f);
    const Options usual;
    Options many;
    many.caustics.photons = 1024;
    const std::vector<float> a = texture(scene, usual), aTrue = texture(scene, many);
    const std::vector<float> b = texture(scene, usual, 1.0 / 30.0), bTrue = texture(scene, many, 1.0 / 30.0);
    double square = 0.0, light = 0.0, change = 0.0, trueChange = 0.0;
    for (std::size_t i = 0; i < a.size(); i += 4) {
        square += std::pow(static_cast<double>(a[i] - aTrue[i]), 2.0);
        light += static_cast<double>(aTrue[i]);
        change += static_cast<double>(std::abs(b[i] - a[i]));
        trueChange += static_cast<double>(std::abs(bTrue[i] - aTrue[i]));
    }
    const double texels = static_cast<double>(a.size() / 4);
    const double error = std::sqrt(square / texels) / (light / texels);
    EXPECT_LT(error, 0.08);
    EXPECT_GT(error, 0.0); // the two are not one and the same
    EXPECT_LT(change, 1.05 * trueChange);
    RecordProperty("relative_rmse", std::to_string(error));
    RecordProperty("flicker", std::to_string(change / trueChange - 1.0));
}

// The lattice keeps its place on the water: a region moves by whole texels, whatever the eye does.
TEST(FrameCaustics, TheRegionMovesByWholeTexels)
{
    WaterBody water;
    water.present = true;
    water.extent = vec2(200.0f);
    CausticsOptions options;
    for (int i = 0; i < 200; ++i) {
        Camera camera;
        camera.eye = vec3(0.137f * static_cast<float>(i), 1.7f, -0.071f * static_cast<float>(i));
        camera.target = camera.eye + vec3(std::sin(0.1f * static_cast<float>(i)), -0.2f, 1.0f);
        const CausticsRegion region = causticsRegion(water, camera, options);
        const float texel = 2.0f * region.rect.halfExtent.x / 256.0f;
        EXPECT_FLOAT_EQ(region.rect.halfExtent.x, 8.0f);
        for (const float c : {region.rect.centre.x, region.rect.centre.y})
            EXPECT_NEAR(c / texel, std::round(c / texel), 1.0e-3f);
    }
    water.extent = vec2(10.0f, 6.0f); // small water is held whole, and stays where it is
    const CausticsRegion whole = causticsRegion(water, Camera{}, options);
    EXPECT_EQ(whole.rect.centre, water.centre);
    EXPECT_EQ(whole.border, 0.0f);
}

// No sun, no caustics, and nothing is drawn for them.
TEST(FrameCaustics, NoneBelowTheHorizon)
{
    Scene scene = pool(2.0f, 6.0f, 30.0f);
    addWaves(scene, 1.0f);
    for (const float elevation : {-5.0f, 0.0f}) {
        const float e = glm::radians(elevation);
        scene.sun->direction = vec3(std::cos(e), std::sin(e), 0.0f);
        EXPECT_EQ(sum(texture(scene, {}), 0), 0.0);
        Options options;
        const FramePlan plan = planFrame(scene, scene.water, scene.cameras.front(), options, {64, 64}, 0.0);
        EXPECT_FALSE(plan[PassId::caustics].wanted);
        EXPECT_FALSE(plan[PassId::sunlight].wanted);
    }
}

} // namespace tarn::test
