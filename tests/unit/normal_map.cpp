// Ripples of a normal map: the shared formula, the layers' drift, and the reference's surface against closed forms.
#include "base/files.h"
#include "optics/optics.h"
#include "reference/reference.h"
#include "reference/water_surface.h"
#include "test_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tarn {
namespace {

using glm::dvec2;
using glm::dvec3;
using reference::WaterSurface;

constexpr double twoPi = 2.0 * std::numbers::pi;

dvec3 normalOf(const dvec2& slope) { return glm::normalize(dvec3(-slope.x, 1.0, -slope.y)); }

TEST(NormalMap, FourEqualLayersHaveTheLayersSlope)
{
    for (const dvec2 slope : {dvec2(0.0), dvec2(0.2, -0.1), dvec2(-1.5, 3.0)}) {
        const dvec3 colour = 0.5 * normalOf(slope) + 0.5;
        const dvec3 sum = 4.0 * optics64::normalMapNormal(colour);
        EXPECT_LT(glm::length(optics64::normalMapSlope(sum, 1.0) - slope), 1e-12);
        // Lipp: y times the bump factor, so that slopes grow by its inverse.
        EXPECT_LT(glm::length(optics64::normalMapSlope(sum, 0.5) - 2.0 * slope), 1e-12);
        const dvec3 steeper = glm::normalize(normalOf(slope) * dvec3(1.0, 0.25, 1.0));
        EXPECT_LT(glm::length(optics64::waveNormal(optics64::normalMapSlope(sum, 0.25)) - steeper), 1e-12);
    }
}

TEST(NormalMap, LayersThatLeanApartAreLevelTogether)
{
    dvec3 sum(0.0);
    for (const dvec2 slope : {dvec2(0.3, 0.0), dvec2(-0.3, 0.0), dvec2(0.0, 0.7), dvec2(0.0, -0.7)})
        sum += normalOf(slope);
    EXPECT_LT(glm::length(optics64::normalMapSlope(sum, 0.2)), 1e-12);
}

TEST(NormalMap, SlopesEndWhereTheListingHasNoNormal)
{
    for (const float bump : {0.0f, 1e-8f, 0.3f, 1.0f})
        for (const vec3 sum : {vec3(0.0f, 4.0f, 0.0f), vec3(0.1f, 4.0f, 0.0f), vec3(3.0f, 0.0f, 1.0f), vec3(0.0f)}) {
            const vec2 slope = optics::normalMapSlope(sum, bump);
            ASSERT_TRUE(std::isfinite(slope.x) && std::isfinite(slope.y));
            EXPECT_LE(glm::length(slope), 50.01f);
            EXPECT_NEAR(glm::length(optics::waveNormal(slope)), 1.0f, 1e-6f);
        }
    EXPECT_EQ(optics::normalMapSlope(vec3(0.0f, 4.0f, 0.0f), 0.0f), vec2(0.0f));
}

/// Half of the texels lean one way and half the other: the mean is level, and the variance is all of the slopes'.
TEST(NormalMap, AveragedSlopesAreVariance)
{
    const double s = 0.3;
    const dvec3 mean = 0.5 * (normalOf({s, 0.0}) + normalOf({-s, 0.0}));
    EXPECT_NEAR(optics64::normalMapFilteredVariance(glm::dvec4(mean, 0.5 * s * s)), 0.5 * s * s, 1e-12);
    EXPECT_NEAR(optics64::normalMapFilteredVariance(glm::dvec4(normalOf({s, 0.0}), 0.5 * s * s)), 0.0, 1e-12);
    // The mean of four that do not know of each other has a quarter of the variance of one.
    EXPECT_NEAR(optics64::normalMapSlopeVariance(4.0 * 0.01, 1.0), 0.0025, 1e-12);
    EXPECT_NEAR(optics64::normalMapSlopeVariance(4.0 * 0.01, 0.5), 0.01, 1e-12);
}

TEST(NormalMap, LayersDriftWithTheirVelocities)
{
    WaterNormalMap map;
    map.tile = 2.5f;
    const auto start = layerOffsets(map, 0.0);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_GT(glm::distance(start[i], start[j]), 0.05);
    // What is at x now was at x - v t: also after a year, in which single precision would have lost the place.
    for (const double time : {0.7, 3.0e7}) {
        const auto later = layerOffsets(map, time);
        for (std::size_t i = 0; i < 4; ++i) {
            const dvec2 moved = dvec2(map.layers[i].velocity) * time / 2.5;
            const dvec2 turns = later[i] + moved - start[i];
            EXPECT_LT(glm::length(turns - glm::round(turns)), 1e-6);
            EXPECT_TRUE(later[i].x >= 0.0 && later[i].x <= 1.0 && later[i].y >= 0.0 && later[i].y <= 1.0);
        }
    }
}

WaterSurface surfaceOf(const Scene& scene, double time = 0.0)
{
    return WaterSurface(scene.water, time, {}, {},
                        &scene.images[static_cast<std::size_t>(scene.water.normalMap.image)]);
}

void addWaves(Scene& scene) { scene.water.waves = {{0.06f, 2.3f, 0.3f, 0.4f, 0.0f}, {0.03f, 0.9f, 1.7f, 1.1f, 0.0f}}; }

TEST(ReferenceRipples, AFlatMapChangesNothing)
{
    Scene scene = test::flatLake(2.0f, 20.0f);
    addWaves(scene);
    test::addNormalMap(scene, 4, [](const vec2&) { return vec2(0.0f); });
    scene.water.normalMap.bump = 0.1f;
    const WaterSurface rippled = surfaceOf(scene, 1.3), plain(scene.water, 1.3);
    for (double x = -9.0; x < 9.0; x += 0.37)
        EXPECT_LT(glm::distance(rippled.normal(x, 0.3 * x), plain.normal(x, 0.3 * x)), 1e-7);
}

TEST(ReferenceRipples, AConstantTiltAddsItsSlopeToTheWaves)
{
    Scene scene = test::flatLake(2.0f, 20.0f);
    addWaves(scene);
    test::addNormalMap(scene, 4, [](const vec2&) { return vec2(0.12f, -0.05f); });
    for (const float bump : {1.0f, 0.4f}) {
        scene.water.normalMap.bump = bump;
        const WaterSurface rippled = surfaceOf(scene, 1.3), plain(scene.water, 1.3);
        for (double x = -9.0; x < 9.0; x += 0.37) {
            const dvec3 n = plain.normal(x, 0.3 * x);
            const dvec2 slope = -dvec2(n.x, n.z) / n.y + dvec2(0.12, -0.05) / static_cast<double>(bump);
            EXPECT_LT(glm::distance(rippled.normal(x, 0.3 * x), normalOf(slope)), 1e-6);
        }
    }
    scene.water.normalMap.enabled = false;
    EXPECT_EQ(surfaceOf(scene, 1.3).normal(1.0, 2.0), WaterSurface(scene.water, 1.3).normal(1.0, 2.0));
}

/// A sine on whole wave numbers, whose mean over the layers is known: the picture is read where the layers lie, with x
/// to the right and z upward, and goes on over its edges.
TEST(ReferenceRipples, ASineIsFoundWhereItsLayersLie)
{
    Scene scene = test::flatLake(2.0f, 20.0f);
    const auto slopeAt = [](const dvec2& uv) {
        return 0.15 * std::cos(twoPi * (2.0 * uv.x + uv.y)) * dvec2(1.0, 0.5) +
               dvec2(0.0, 0.1 * std::sin(twoPi * uv.y));
    };
    test::addNormalMap(scene, 256, [&](const vec2& uv) { return vec2(slopeAt(dvec2(uv))); });
    scene.water.normalMap.tile = 1.5f;
    scene.water.normalMap.bump = 0.8f;
    const double time = 2.9;
    const WaterSurface surface = surfaceOf(scene, time);
    const auto offsets = layerOffsets(scene.water.normalMap, time);
    for (double x = -9.0; x < 9.0; x += 0.0937) {
        const double z = 3.0 - 0.71 * x;
        dvec3 sum(0.0);
        for (const dvec2& offset : offsets) sum += normalOf(slopeAt(dvec2(x, z) / 1.5 + offset));
        const dvec3 steeper = glm::normalize(sum * dvec3(1.0, static_cast<double>(0.8f), 1.0));
        EXPECT_LT(glm::distance(surface.normal(x, z), steeper), 2e-4) << x; // of blending between 256 texels
    }
}

/// What ripples mirror into the water is mirrored once more, so that no reflected ray of a level surface goes down.
TEST(ReferenceRipples, MirroredRaysStayOverTheWater)
{
    Scene scene = test::flatLake(2.0f, 60.0f);
    test::addNormalMap(scene, 4, [](const vec2&) { return vec2(0.0f, -0.5f); });
    const WaterSurface surface = surfaceOf(scene);
    const dvec3 U(0.0), grazing = glm::normalize(dvec3(0.0, -0.1, 1.0));
    const dvec3 mirrored = optics64::reflectRay(grazing, surface.normal(0.0, 0.0));
    const dvec3 kept = surface.keptOn(mirrored, U, true);
    EXPECT_GT(kept.y, 0.0);
    EXPECT_NEAR(std::abs(mirrored.y), kept.y, 1e-12);
    EXPECT_EQ(surface.keptOn(dvec3(0.0, 1.0, 0.0), U, true), dvec3(0.0, 1.0, 0.0));
    EXPECT_EQ(WaterSurface(scene.water, 0.0).keptOn(dvec3(0.0, -1.0, 0.0), U, true), dvec3(0.0, -1.0, 0.0));
}

/// An unlike picture is another picture to a checkpoint.
TEST(ReferenceRipples, AreInAPicturesIdentity)
{
    Scene scene = test::flatLake(2.0f, 60.0f);
    const auto identity = [&] {
        return reference::Tracer(scene, scene.water).identity({.camera = scene.cameras[0], .approximations = {}}, {});
    };
    const std::string plain = identity();
    test::addNormalMap(scene, 4, [](const vec2&) { return vec2(0.1f); });
    const std::string rippled = identity();
    EXPECT_NE(rippled, plain);
    scene.water.normalMap.layers[2].velocity.x += 0.1f;
    EXPECT_NE(identity(), rippled);
    scene.water.normalMap.enabled = false;
    EXPECT_EQ(identity(), plain);
}

/// The shipped picture: up everywhere, level in the mean, as steep as its maker says, and seamless.
TEST(ShippedRipples, AreSeamlessAndLevel)
{
    const Image image = readImage(projectRoot() / "assets/water/ripples.png");
    ASSERT_EQ(image.channels, 3);
    const int edge = image.width;
    const auto slope = [&](int x, int y) {
        const auto i = static_cast<std::size_t>((y % edge) * edge + x % edge) * 3;
        const auto value = [&](std::size_t c) { return static_cast<float>(image.bytes[i + c]) / 255.0f; };
        return dvec2(optics::normalMapSlope(optics::normalMapNormal(vec3(value(0), value(1), value(2))), 1.0f));
    };
    dvec2 mean(0.0);
    double squares = 0.0, inside = 0.0, across = 0.0;
    for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x) {
            mean += slope(x, y) / (static_cast<double>(edge) * edge);
            squares += 0.5 * glm::dot(slope(x, y), slope(x, y)) / (static_cast<double>(edge) * edge);
            double& widest = x + 1 == edge || y + 1 == edge ? across : inside;
            widest = std::max(
                {widest, glm::distance(slope(x, y), slope(x + 1, y)), glm::distance(slope(x, y), slope(x, y + 1))});
        }
    EXPECT_LT(glm::length(mean), 2e-3);
    EXPECT_NEAR(std::sqrt(squares), 0.2, 0.002);
    EXPECT_LT(across, inside);
}

} // namespace
} // namespace tarn
