#include "base/error.h"
#include "scene/scene_file.h"
#include "scene/sky.h"
#include "temp_folder.h"

#include <cmath>
#include <functional>

namespace tarn::test {
namespace {

float luminance(const vec3& rgb) { return glm::dot(rgb, vec3(0.2126f, 0.7152f, 0.0722f)); }

vec3 towards(float elevationDegrees, float azimuthDegrees)
{
    const float e = glm::radians(elevationDegrees), a = glm::radians(azimuthDegrees);
    return {std::cos(e) * std::cos(a), std::sin(e), std::cos(e) * std::sin(a)};
}

SkyModel daylight(float sunElevation, float turbidity = 3.0f)
{
    Scene scene;
    scene.sun.emplace();
    scene.sun->direction = towards(sunElevation, 0.0f);
    scene.sky.turbidity = turbidity;
    return SkyModel(scene);
}

TEST(Sky, ConstantIsExact)
{
    Scene scene;
    scene.sky.kind = Sky::Kind::constant;
    scene.sky.radiance = {1.0f, 2.0f, 3.0f};
    const SkyModel sky(scene);
    for (const vec3& direction : {towards(90, 0), towards(-90, 0), towards(10, 77)}) {
        EXPECT_EQ(sky.radiance(direction), scene.sky.radiance);
        const vec3 irradiance = sky.irradiance(direction);
        for (int c = 0; c < 3; ++c) EXPECT_FLOAT_EQ(irradiance[c], pi * scene.sky.radiance[c]);
    }
    EXPECT_EQ(sky.sunIrradiance(), vec3(0.0f));
}

TEST(Sky, LightingScalesOnlyTheIrradiance)
{
    Scene scene;
    scene.sky.kind = Sky::Kind::constant;
    scene.sky.lighting = 0.5f;
    const SkyModel sky(scene);
    EXPECT_EQ(sky.radiance({0.0f, 1.0f, 0.0f}), vec3(1.0f));
    EXPECT_FLOAT_EQ(sky.irradiance({0.0f, 1.0f, 0.0f}).x, 0.5f * pi);
}

TEST(Sky, DaylightIsBrighterAtTheHorizonThanOverhead)
{
    const SkyModel sky = daylight(45.0f);
    const float zenith = luminance(sky.radiance({0.0f, 1.0f, 0.0f}));
    EXPECT_GT(luminance(sky.radiance(towards(3, 180))), zenith) << "away from the sun";
    EXPECT_GT(luminance(sky.radiance(towards(46, 5))), 2.0f * zenith) << "near the sun";
    const vec3 blue = sky.radiance(towards(80, 180));
    EXPECT_GT(blue.z, 1.2f * blue.x) << "a clear sky is blue";
}

TEST(Sky, DaylightHasTheRightSize)
{
    // Preetham's zenith luminance for T = 3 and the sun 30° from the zenith, by hand from appendix A.2:
    // chi = (4/9 - 3/120) (pi - pi/3) = 0.8784, Y = 7.1649 tan(chi) - 0.6465 + 2.4192 = 10.40 kcd/m².
    EXPECT_NEAR(luminance(daylight(60.0f).radiance({0.0f, 1.0f, 0.0f})), 10.40f, 0.15f);
    // A clear sky gives 10 to 30 klx, the sun about 100.
    const SkyModel noon = daylight(70.0f, 2.5f);
    EXPECT_GT(luminance(noon.irradiance({0.0f, 1.0f, 0.0f})), 10.0f);
    EXPECT_LT(luminance(noon.irradiance({0.0f, 1.0f, 0.0f})), 45.0f);
    EXPECT_NEAR(luminance(noon.sunIrradiance()), 95.0f, 12.0f);
}

TEST(Sky, SunGrowsAndWhitensAsItRises)
{
    float before = 0.0f, redness = 1e9f;
    for (float elevation = -5.0f; elevation <= 90.0f; elevation += 1.0f) {
        const vec3 sun = daylight(elevation).sunIrradiance();
        if (elevation < -0.3f) {
            EXPECT_EQ(sun, vec3(0.0f)) << elevation;
            continue;
        }
        EXPECT_GT(luminance(sun), before) << elevation;
        EXPECT_LT(sun.x / sun.z, redness) << elevation;
        before = luminance(sun);
        redness = sun.x / sun.z;
    }
    EXPECT_LT(before, 128.0f);
}

TEST(Sky, EverySunGivesFiniteLight)
{
    for (const float turbidity : {2.0f, 3.0f, 6.0f, 10.0f}) {
        for (float elevation = -90.0f; elevation <= 90.0f; elevation += 7.5f) {
            const SkyModel sky = daylight(elevation, turbidity);
            for (float e = -90.0f; e <= 90.0f; e += 5.0f) {
                for (float a = 0.0f; a < 360.0f; a += 30.0f) {
                    const vec3 radiance = sky.radiance(towards(e, a));
                    for (int c = 0; c < 3; ++c) {
                        ASSERT_TRUE(std::isfinite(radiance[c]) && radiance[c] >= 0.0f)
                            << "T " << turbidity << " sun " << elevation << " at " << e << "," << a;
                    }
                }
            }
        }
    }
}

TEST(Sky, NightFalls)
{
    const auto up = [](float elevation) { return luminance(daylight(elevation).irradiance({0.0f, 1.0f, 0.0f})); };
    EXPECT_GT(up(1.0f), up(-1.0f));
    EXPECT_GT(up(-1.0f), up(-6.0f));
    EXPECT_LT(up(-6.0f), 0.1f);
    EXPECT_GT(up(-6.0f), 0.0f);
}

TEST(Sky, NoHardLineAtTheHorizon)
{
    const SkyModel sky = daylight(30.0f);
    float before = luminance(sky.radiance(towards(3.0f, 90)));
    for (float e = 2.95f; e > -3.0f; e -= 0.05f) {
        const float now = luminance(sky.radiance(towards(e, 90)));
        EXPECT_LT(std::abs(now - before), 0.08f * std::max(now, before)) << e;
        before = now;
    }
}

TEST(Sky, GroundReflectsWhatItReceives)
{
    Scene scene;
    scene.sun.emplace();
    scene.sun->direction = towards(50, 0);
    scene.sky.groundAlbedo = 0.5f;
    const SkyModel sky(scene);
    const vec3 received = sky.irradiance({0.0f, 1.0f, 0.0f}) + sky.sunIrradiance() * std::sin(glm::radians(50.0f));
    const vec3 ground = sky.radiance({0.0f, -1.0f, 0.0f});
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(ground[c], 0.5f / pi * received[c], 0.08f * ground[c]);
}

TEST(Sky, CoefficientsMatchTheIntegral)
{
    const SkyModel sky = daylight(40.0f);
    for (const vec3& normal : {towards(90, 0), towards(0, 0), towards(20, 130), towards(-60, 200)}) {
        vec3 sum(0.0f);
        constexpr int n = 200;
        for (int i = 0; i < n; ++i) {
            for (int k = 0; k < 2 * n; ++k) {
                const float y = -1.0f + 2.0f * (static_cast<float>(i) + 0.5f) / n;
                const float a = pi * (static_cast<float>(k) + 0.5f) / n;
                const float r = std::sqrt(1.0f - y * y);
                const vec3 direction(r * std::cos(a), y, r * std::sin(a));
                sum += sky.radiance(direction) * std::max(glm::dot(direction, normal), 0.0f);
            }
        }
        sum *= 4.0f * pi / (2.0f * n * n);
        // Nine terms are within a few per cent of the truth for smooth skies (Ramamoorthi & Hanrahan 2001).
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(sky.irradiance(normal)[c], sum[c], 0.06f * sum[c]);
    }
}

TEST(Sky, DiscHoldsTheSunsIrradiance)
{
    const SkyModel sky = daylight(45.0f);
    // Solid angle of a disc of 0.2665° radius, small-angle formula pi r².
    const float radius = glm::radians(0.2665f);
    EXPECT_NEAR(sky.sunDiscRadiance().y * pi * radius * radius, sky.sunIrradiance().y, 1e-3f * sky.sunIrradiance().y);
}

/// One colour per face or quarter, so that a wrong turn or mirror shows.
SkyModel pictureSky(int width, int height, const std::function<vec3(int, int)>& colour, float rotation = 0.0f)
{
    Scene scene;
    Image image;
    image.width = width;
    image.height = height;
    image.channels = 3;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) image.floats.push_back(colour(x, y)[c]);
    scene.images.push_back(image);
    scene.sky.kind = Sky::Kind::picture;
    scene.sky.image = 0;
    scene.sky.rotation = rotation;
    return SkyModel(scene);
}

void expectColour(const vec3& actual, const vec3& expected)
{
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(actual[c], expected[c], 0.02f);
}

TEST(SkyPicture, LatitudeLongitudeFacesMinusZ)
{
    // u in r, v in g.
    const auto ramp = [](int x, int y) {
        return vec3((static_cast<float>(x) + 0.5f) / 128.0f, (static_cast<float>(y) + 0.5f) / 64.0f, 0.0f);
    };
    const SkyModel sky = pictureSky(128, 64, ramp);
    expectColour(sky.radiance({0.0f, 0.0f, -1.0f}), {0.5f, 0.5f, 0.0f});
    expectColour(sky.radiance({1.0f, 0.0f, 0.0f}), {0.75f, 0.5f, 0.0f});
    expectColour(sky.radiance({-1.0f, 0.0f, 0.0f}), {0.25f, 0.5f, 0.0f});
    EXPECT_NEAR(sky.radiance({0.0f, 1.0f, 0.0f}).y, 0.0f, 0.02f);
    EXPECT_NEAR(sky.radiance({0.0f, -1.0f, 0.0f}).y, 1.0f, 0.02f);
    // Turned by +90° about y, what lay along -z lies along -x.
    expectColour(pictureSky(128, 64, ramp, pi / 2.0f).radiance({-1.0f, 0.0f, 0.0f}), {0.5f, 0.5f, 0.0f});
}

constexpr int face = 16;

vec3 faceColour(int index)
{
    return {static_cast<float>(index & 1), static_cast<float>(index >> 1 & 1), static_cast<float>(index >> 2 & 1)};
}

void expectFaces(const SkyModel& sky)
{
    const vec3 axes[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, -1}, {0, 0, 1}};
    for (int i = 0; i < 6; ++i) {
        SCOPED_TRACE(i);
        expectColour(sky.radiance(axes[i]), faceColour(i));
        expectColour(sky.radiance(glm::normalize(axes[i] + vec3(0.3f, -0.25f, 0.2f))), faceColour(i));
    }
}

TEST(SkyPicture, CubeLayoutsAgree)
{
    expectFaces(pictureSky(6 * face, face, [](int x, int) { return faceColour(x / face); }));
    expectFaces(pictureSky(face, 6 * face, [](int, int y) { return faceColour(y / face); }));
    const auto wide = [](int x, int y) {
        const int cells[3][4] = {{7, 2, 7, 7}, {1, 4, 0, 5}, {7, 3, 7, 7}};
        return faceColour(cells[y / face][x / face]);
    };
    expectFaces(pictureSky(4 * face, 3 * face, wide));
    const auto tall = [](int x, int y) {
        const int cells[4][3] = {{7, 2, 7}, {1, 4, 0}, {7, 3, 7}, {7, 5, 7}};
        return faceColour(cells[y / face][x / face]);
    };
    expectFaces(pictureSky(3 * face, 4 * face, tall));
}

TEST(SkyPicture, CrossesJoinWithoutSeams)
{
    // A smooth function of direction painted into the cross must come out again: every face is turned right.
    const auto truth = [](const vec3& d) { return vec3(0.5f) + 0.5f * d; };
    for (const bool isWide : {true, false}) {
        const ivec2 cells[2][6] = {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}},
                                   {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3}}};
        const auto paint = [&](int x, int y) {
            for (int f = 0; f < 6; ++f) {
                const ivec2 cell = cells[isWide ? 0 : 1][f];
                if (cell != ivec2(x / face, y / face)) continue;
                float u = (static_cast<float>(x % face) + 0.5f) / face * 2.0f - 1.0f;
                float v = 1.0f - (static_cast<float>(y % face) + 0.5f) / face * 2.0f;
                if (!isWide && f == 5) {
                    u = -u;
                    v = -v;
                }
                const vec3 points[6] = {{1, v, u}, {-1, v, -u}, {u, 1, v}, {u, -1, -v}, {u, v, -1}, {-u, v, 1}};
                return truth(glm::normalize(points[f]));
            }
            return vec3(0.0f);
        };
        const SkyModel sky = isWide ? pictureSky(4 * face, 3 * face, paint) : pictureSky(3 * face, 4 * face, paint);
        for (float e = -80.0f; e <= 80.0f; e += 10.0f) {
            for (float a = 0.0f; a < 360.0f; a += 15.0f) {
                const vec3 d = towards(e, a);
                EXPECT_LT(glm::length(sky.radiance(d) - truth(d)), 0.08f) << isWide << " " << e << "," << a;
            }
        }
    }
}

TEST(SkyPicture, WhitePictureLightsLikeAConstantSky)
{
    const SkyModel sky = pictureSky(64, 32, [](int, int) { return vec3(2.0f); });
    for (const vec3& normal : {towards(90, 0), towards(-20, 50)})
        EXPECT_NEAR(sky.irradiance(normal).y, 2.0f * pi, 0.01f);
}

TEST(SkyPicture, BrokenPixelsDoNoHarm)
{
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const SkyModel sky =
        pictureSky(8, 4, [&](int x, int) { return vec3(x == 1 ? nan : 1.0f, x == 2 ? inf : 1.0f, -1.0f); });
    for (const vec3& c : sky.irradianceCoefficients())
        for (int i = 0; i < 3; ++i) EXPECT_TRUE(std::isfinite(c[i]));
    EXPECT_EQ(sky.radiance({0.0f, 0.0f, -1.0f}).z, 0.0f);
}

} // namespace
} // namespace tarn::test
