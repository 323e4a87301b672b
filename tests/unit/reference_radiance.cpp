// The reference's light against closed forms.
#include "base/error.h"
#include "base/progress.h"
#include "optics/waves.h"
#include "reference/reference.h"
#include "temp_folder.h"
#include "test_scenes.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

namespace tarn {
namespace {

using reference::Picture;
using reference::ReferenceOptions;
using reference::Tracer;
using reference::ViewRequest;

constexpr float ior = 1.33f;

ViewRequest viewFrom(const vec3& eye, const vec3& target, float degrees, ivec2 size)
{
    ViewRequest view;
    view.size = size;
    view.camera.eye = eye;
    view.camera.target = target;
    view.camera.verticalFov = glm::radians(degrees);
    return view;
}

/// What a narrow beam from an eye sees, mean of its pixels.
vec3 seen(const Scene& scene, const vec3& eye, const vec3& target, const ReferenceOptions& options,
          float degrees = 0.05f)
{
    const Picture picture = Tracer(scene, scene.water).render(viewFrom(eye, target, degrees, {4, 4}), options);
    vec3 sum(0.0f);
    for (const vec3& radiance : picture.radiance) sum += radiance;
    return sum / static_cast<float>(picture.pixels());
}

float fresnel(float cosine) { return optics::fresnelExact(cosine, 1.0f / ior); }

void addSun(Scene& scene, const vec3& direction, float irradiance)
{
    scene.sun = Sun{glm::normalize(direction), vec3(irradiance), false};
}

TEST(ReferenceRadiance, BeerLambertAlongTheSlantedWay)
{
    Scene scene = test::flatLake(2.0f);
    scene.water.absorption = {0.5f, 0.2f, 0.05f};
    scene.materials[0].diffuse = vec3(0.0f);
    scene.materials[0].emissive = vec3(3.0f);
    for (const float degrees : {10.0f, 45.0f, 70.0f}) {
        const float a = glm::radians(degrees);
        const vec3 radiance = seen(scene, 3.0f * vec3(0.0f, std::cos(a), std::sin(a)), vec3(0.0f), {.samples = 4});
        const float cosWater = std::sqrt(1.0f - std::pow(std::sin(a) / ior, 2.0f));
        const float F = fresnel(std::cos(a));
        for (int c = 0; c < 3; ++c) {
            const float below = 3.0f * std::exp(-scene.water.absorption[c] * 2.0f / cosWater);
            EXPECT_NEAR(radiance[c], F * 1.0f + (1.0f - F) / (ior * ior) * below, 1e-3f) << degrees;
        }
    }
}

/// A closed place where everything shines alike: 1 in the air, n² in the water. No surface may darken or brighten it.
TEST(ReferenceRadiance, AWhiteWorldStaysWhite)
{
    Scene scene = test::flatLake(1.0f, 200.0f);
    scene.water.waves = {{0.05f, 2.0f, 0.3f, 0.4f, 0.0f}, {0.02f, 0.7f, 1.9f, 0.0f, 0.0f}};
    scene.materials[0].diffuse = vec3(0.0f);
    scene.materials[0].emissive = vec3(ior * ior);
    const int white = test::addMaterial(scene, vec3(0.0f));
    scene.materials[static_cast<std::size_t>(white)].emissive = vec3(1.0f);
    test::addBox(scene, {-1.0f, 0.3f, -1.0f}, {1.0f, 2.0f, 1.0f}, white);
    const Tracer tracer(scene, scene.water);
    reference::TraceReport report;
    const Picture above = tracer.render(viewFrom({0.0f, 1.5f, 7.0f}, {0.0f, -1.0f, 0.0f}, 28.0f, {48, 36}),
                                        {.samples = 4, .depth = 12}, nullptr, {}, &report);
    for (std::size_t i = 0; i < above.pixels(); ++i)
        EXPECT_NEAR(above.radiance[i].y, 1.0f, 1e-3f + static_cast<float>(report.truncatedFraction));
    EXPECT_LT(report.truncatedFraction, 1e-3);
}

TEST(ReferenceRadiance, DepthLimitReportsWhatItLeavesOut)
{
    Scene scene = test::flatLake(1.0f);
    const Tracer tracer(scene, scene.water);
    reference::TraceReport report;
    // From below a flat surface the reflected ray goes down for good: one meeting is all there is.
    (void)tracer.render(viewFrom({0.0f, -0.5f, 3.0f}, {0.0f, 0.0f, 0.0f}, 10.0f, {8, 8}), {.samples = 1, .depth = 1},
                        nullptr, {}, &report);
    EXPECT_EQ(report.truncatedFraction, 0.0);
    // Seen from above through waves, more than one may follow; of none, all is left out.
    scene.water.waves = {{0.3f, 1.5f, 0.0f, 0.0f, 0.0f}};
    (void)tracer.render(viewFrom({0.0f, 0.6f, 6.0f}, {0.0f, 0.0f, 0.0f}, 20.0f, {32, 32}), {.samples = 1, .depth = 1},
                        nullptr, {}, &report);
    EXPECT_GT(report.truncatedFraction, 1e-3);
}

/// Sun through flat water onto a diffuse bed and out again; then with the light that the surface sends back down.
TEST(ReferenceRadiance, SunOnTheBedWithAndWithoutBounces)
{
    constexpr float albedo = 0.5f, irradiance = 10.0f;
    Scene scene = test::flatLake(0.5f, 60.0f);
    scene.sky.radiance = vec3(0.0f);
    scene.materials[0].diffuse = vec3(albedo);
    for (const float elevation : {90.0f, 30.0f}) {
        const float e = glm::radians(elevation);
        addSun(scene, {std::cos(e), std::sin(e), 0.0f}, irradiance);
        const float onBed = irradiance * std::sin(e) * (1.0f - fresnel(std::sin(e)));
        const float direct = albedo / pi * onBed * (1.0f - fresnel(std::cos(glm::radians(20.0f)))) / (ior * ior);
        const vec3 eye = 2.0f * vec3(0.0f, std::cos(glm::radians(20.0f)), std::sin(glm::radians(20.0f)));
        const ReferenceOptions once{.samples = 64, .photons = 1'000'000};
        EXPECT_NEAR(seen(scene, eye, vec3(0.0f), once, 3.0f).y / direct, 1.0f, 0.01f) << elevation;
        // 0.472 of the diffuse light from the bed comes back (Fresnel, n = 1.33, mean over the cosine).
        ReferenceOptions often{.samples = 1024, .bounces = 12, .photons = 1'000'000};
        EXPECT_NEAR(seen(scene, eye, vec3(0.0f), often, 3.0f).y / direct, 1.0f / (1.0f - 0.472f * albedo), 0.02f)
            << elevation;
    }
}

TEST(ReferenceRadiance, ARampOnTheBedThroughWaves)
{
    constexpr float edge = 40.0f;
    Scene scene = test::flatLake(1.0f, edge);
    scene.sky.radiance = vec3(0.0f);
    scene.water.waves = {{0.05f, 2.0f, 0.3f, 0.4f, 0.0f}, {0.02f, 0.7f, 1.9f, 0.0f, 0.0f}};
    Image ramp;
    ramp.width = 256;
    ramp.height = 1;
    ramp.channels = 3;
    for (int i = 0; i < 256; ++i) ramp.floats.insert(ramp.floats.end(), 3, (static_cast<float>(i) + 0.5f) / 256.0f);
    scene.images.push_back(ramp);
    scene.materials[0].diffuse = vec3(0.0f);
    scene.materials[0].emissive = vec3(1.0f);
    scene.materials[0].emissiveMap = 0;
    for (Vertex& vertex : scene.meshes[0].vertices) vertex.uv = vec2(vertex.position.x / edge + 0.5f, 0.5f);
    const Tracer tracer(scene, scene.water);
    for (const float x : {-3.0f, 0.5f, 4.0f}) {
        const ViewRequest view = viewFrom({x, 2.0f, 3.0f}, {x, 0.0f, 0.0f}, 0.02f, {1, 1});
        const Picture picture = tracer.render(view, {.samples = 16});
        const float F = picture.fresnel[0];
        const float expected = (1.0f - F) / (ior * ior) * (picture.refractionHit[0].x / edge + 0.5f);
        EXPECT_NEAR(picture.radiance[0].x, expected, 1e-3f * expected);
    }
}

TEST(ReferenceRadiance, TheSunCastsShadowsInTheAir)
{
    Scene scene;
    scene.sky.kind = Sky::Kind::constant;
    scene.sky.radiance = vec3(0.0f);
    addSun(scene, {1.0f, 1.0f, 0.0f}, 10.0f);
    const int grey = test::addMaterial(scene, vec3(0.5f));
    test::addFloor(scene, 0.0f, 40.0f, grey);
    test::addBox(scene, {-0.5f, 0.0f, -0.5f}, {0.5f, 2.0f, 0.5f}, grey);
    const float lit = 0.5f / pi * 10.0f * std::sqrt(0.5f);
    const vec3 up(0.0f, 5.0f, 0.01f);
    EXPECT_NEAR(seen(scene, vec3(-1.5f, 0.0f, 0.0f) + up, {-1.5f, 0.0f, 0.0f}, {.samples = 4}).x, 0.0f, 1e-6f);
    EXPECT_NEAR(seen(scene, vec3(-2.8f, 0.0f, 0.0f) + up, {-2.8f, 0.0f, 0.0f}, {.samples = 4}).x, lit, 1e-4f);
    EXPECT_NEAR(seen(scene, vec3(1.5f, 0.0f, 0.0f) + up, {1.5f, 0.0f, 0.0f}, {.samples = 4}).x, lit, 1e-4f);
}

/// Light on a flat bed under one sine, against rays in its plane counted by the thousand.
TEST(ReferenceRadiance, CausticsOfASineAgainstCountedRays)
{
    constexpr double amplitude = 0.03, length = 1.5, depth = 1.2;
    constexpr int bins = 60;
    Scene scene = test::flatLake(static_cast<float>(depth), 24.0f);
    scene.water.waves = {{static_cast<float>(amplitude), static_cast<float>(length), 0.0f, 0.0f, 0.0f}};
    addSun(scene, {0.0f, 1.0f, 0.0f}, 1.0f);

    std::vector<double> counted(bins, 0.0);
    constexpr int rays = 2'000'000;
    const double k = 2.0 * std::numbers::pi / length;
    for (int i = 0; i < rays; ++i) {
        const double x = length * (i + 0.5) / rays;
        const double slope = amplitude * k * std::cos(k * x);
        const double tilt = std::atan(slope); // of the surface; the sun is overhead
        const double bent = std::asin(std::sin(tilt) / 1.33);
        const double s = std::sin(tilt - bent) / std::sin(tilt + bent + 1e-300),
                     p = std::tan(tilt - bent) / std::tan(tilt + bent + 1e-300);
        const double T = std::abs(tilt) < 1e-9 ? 1.0 - std::pow(0.33 / 2.33, 2.0) : 1.0 - 0.5 * (s * s + p * p);
        double landed = x + (depth + amplitude * std::sin(k * x)) * std::tan(tilt - bent);
        landed -= length * std::floor(landed / length);
        counted[static_cast<std::size_t>(landed / length * bins) % bins] += T * bins / rays;
    }

    const Tracer tracer(scene, scene.water);
    const auto light = tracer.lightOnBed(0.0, {0.75f, 0.0f, 1.5f, 1.5f}, 0.0125, 4'000'000, 3);
    double error = 0.0, mean = 0.0;
    for (int bin = 0; bin < bins; ++bin) {
        double sum = 0.0;
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 16; ++j) {
                const auto value = light({static_cast<float>(length * (bin + (i + 0.5) / 4.0) / bins),
                                          -1.0f + 0.125f * static_cast<float>(j)});
                ASSERT_TRUE(value.has_value());
                sum += static_cast<double>(value->y) / 64.0;
            }
        error += std::pow(sum - counted[static_cast<std::size_t>(bin)], 2.0) / bins;
        mean += sum / bins;
    }
    EXPECT_NEAR(mean, 0.9798, 0.005);
    // The sun's disc smears by 4 mm, the texel by 1.25 cm, a bin is 2.5 cm.
    EXPECT_LT(std::sqrt(error), 0.08);
}

double rmse(const Picture& a, const Picture& b)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels(); ++i)
        sum += std::pow(static_cast<double>(a.radiance[i].y) - static_cast<double>(b.radiance[i].y), 2.0);
    return std::sqrt(sum / static_cast<double>(a.pixels()));
}

TEST(ReferenceRadiance, FourTimesTheSamplesHalveTheError)
{
    Scene scene = test::flatLake(0.7f, 30.0f);
    scene.water.waves = {{0.05f, 0.8f, 0.3f, 0.4f, 0.0f}};
    addSun(scene, {1.0f, 1.0f, 0.3f}, 5.0f);
    const Tracer tracer(scene, scene.water);
    const ViewRequest view = viewFrom({0.0f, 1.0f, 4.0f}, {0.0f, 0.0f, 0.0f}, 40.0f, {32, 24});
    const auto at = [&](int samples, int seed) {
        return tracer.render(view, {.samples = samples, .bounces = 1, .photons = 500'000, .seed = seed});
    };
    const Picture truth = at(1024, 1);
    const double coarse = rmse(at(8, 1), truth), fine = rmse(at(32, 1), truth);
    EXPECT_GT(coarse / fine, 1.6); // 2 for independent samples; even ones do better
    EXPECT_LT(coarse / fine, 5.0);
}

TEST(ReferenceRadiance, ThreadsAndInterruptionsChangeNoBit)
{
    Scene scene = test::flatLake(0.7f, 30.0f);
    scene.water.waves = {{0.05f, 0.8f, 0.3f, 0.4f, 0.0f}};
    addSun(scene, {1.0f, 1.0f, 0.3f}, 5.0f);
    const Tracer tracer(scene, scene.water);
    const ViewRequest view = viewFrom({0.0f, 1.0f, 4.0f}, {0.0f, 0.0f, 0.0f}, 40.0f, {24, 18});
    const ReferenceOptions options{.samples = 6, .bounces = 1, .photons = 100'000};
    const Picture whole = tracer.render(view, options);
    {
        const tbb::global_control oneThread(tbb::global_control::max_allowed_parallelism, 1);
        EXPECT_EQ(tracer.render(view, options).radiance, whole.radiance);
    }

    const test::TempFolder folder;
    const std::filesystem::path file = folder.path() / "unfinished.exr";
    class StopAt : public Progress {
    public:
        std::atomic<bool> stop{false};
        void report(double fraction, const std::string& what) override
        {
            if (what.find("sample") != std::string::npos && fraction > 0.4) stop = true;
        }
    } progress;
    EXPECT_THROW((void)tracer.render(view, options, &progress, {.file = file, .interrupt = &progress.stop}),
                 reference::Interrupted);
    EXPECT_TRUE(std::filesystem::exists(file));
    EXPECT_EQ(tracer.render(view, options, nullptr, {.file = file}).radiance, whole.radiance);
    // The file of one picture is no start for another.
    ViewRequest other = view;
    other.time = 0.5;
    EXPECT_THROW((void)tracer.render(other, options, nullptr, {.file = file}), Error);
}

TEST(ReferencePicture, IsReadAsItWasWritten)
{
    const test::TempFolder folder;
    Scene scene = test::flatLake(0.7f, 30.0f);
    const Picture made = Tracer(scene, scene.water)
                             .render(viewFrom({0.0f, 1.0f, 4.0f}, {0.0f, 0.0f, 0.0f}, 40.0f, {12, 9}), {.samples = 1});
    const std::filesystem::path file = folder.path() / "truth.exr";
    writePicture(file, made);
    const Picture read = reference::readPicture(file);
    EXPECT_EQ(read.size, made.size);
    EXPECT_EQ(read.radiance, made.radiance);
    EXPECT_EQ(read.refractionHit, made.refractionHit);
    EXPECT_EQ(read.events, made.events);
    EXPECT_EQ(read.metadata.at("tarn:samples"), "1");

    Image plain;
    plain.width = plain.height = 2;
    plain.channels = 3;
    plain.floats.assign(12, 0.5f);
    writeImage(folder.path() / "plain.exr", plain);
    try {
        (void)reference::readPicture(folder.path() / "plain.exr");
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("plain.exr"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("tarn reference"), std::string::npos);
    }
}

} // namespace
} // namespace tarn
