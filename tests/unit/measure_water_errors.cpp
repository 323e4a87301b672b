// The figures of errors that were put there: made-up pixels, known percentiles, and pictures with nothing to measure.

#include "base/error.h"
#include "measure/error_map.h"
#include "measure/heat.h"
#include "measure/water_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tarn {
namespace {

using reference::Event;

/// A row of water pixels in which both agree: seen from (0, 1, 0), U at (i, 0, 0), hits 1 m below and in the sky.
struct Pair {
    WaterQuantities used;
    reference::Picture truth;

    explicit Pair(int count) : used(ivec2(count, 1)), truth(ivec2(count, 1))
    {
        used.eye = vec3(0.0f, 1.0f, 0.0f);
        used.footprint = {vec3(0.0f, 1.0f, 0.0f), 0.01};
        for (int i = 0; i < count; ++i) {
            const auto pixel = static_cast<std::size_t>(i);
            const vec3 surface(static_cast<float>(i), 0.0f, 0.0f), hit = surface - vec3(0.0f, 1.0f, 0.0f);
            const vec3 ray = glm::normalize(surface - used.eye);
            used.isWater[pixel] = used.hasSample[pixel] = used.mirrorsSky[pixel] = 1;
            used.surface[pixel] = truth.surface[pixel] = surface;
            used.position[pixel] = used.picture[pixel] = truth.refractionHit[pixel] = hit;
            used.mirrored[pixel] = vec3(ray.x, -ray.y, ray.z);
            truth.normal[pixel] = vec3(0.0f, 1.0f, 0.0f);
            used.fresnel[pixel] = truth.fresnel[pixel] = 0.25f;
            used.waterPath[pixel] = truth.path[pixel] = 1.0f;
            truth.events[pixel] = Event::meetsWater | Event::refracted | Event::refractionHit;
        }
    }
};

TEST(WaterErrors, NothingIsWrongWhereBothAgree)
{
    const Pair p(5);
    const ErrorFigures figures = errorFigures(p.used, p.truth);
    EXPECT_DOUBLE_EQ(figures.refractionMedian, 0.0);
    EXPECT_DOUBLE_EQ(figures.refractionMax, 0.0);
    EXPECT_DOUBLE_EQ(figures.refractionWrong5cm, 0.0);
    EXPECT_DOUBLE_EQ(figures.refractionWrongTexel, 0.0);
    EXPECT_DOUBLE_EQ(figures.refractionInvalid, 0.0);
    EXPECT_NEAR(figures.reflectionMax, 0.0, 1e-5);
    EXPECT_DOUBLE_EQ(figures.fresnelMax, 0.0);
    EXPECT_DOUBLE_EQ(figures.pathP99, 0.0);
    EXPECT_TRUE(std::isnan(figures.causticsRmse)); // nobody has compared them yet
    EXPECT_TRUE(std::isnan(figures.flip));
    EXPECT_TRUE(std::isnan(figures.rmse));
}

// 101 pixels, wrong by 0 cm, 1 cm … 100 cm: percentiles are the ranks themselves.
TEST(WaterErrors, PercentilesAndSharesOfKnownDistances)
{
    Pair p(101);
    for (std::size_t i = 0; i < 101; ++i) {
        p.used.position[i].z += 0.01f * static_cast<float>(i);
        p.used.picture[i].z += 0.005f * static_cast<float>(i);
    }
    p.used.footprint.edgePerMetre = 0.0;
    ErrorFigures figures = errorFigures(p.used, p.truth);
    EXPECT_NEAR(figures.refractionMedian, 0.50, 1e-6);
    EXPECT_NEAR(figures.refractionP95, 0.95, 1e-6);
    EXPECT_NEAR(figures.refractionP99, 0.99, 1e-6);
    EXPECT_NEAR(figures.refractionMax, 1.00, 1e-6);
    EXPECT_NEAR(figures.refractionWrong5cm, 95.5 / 101.0, 0.6 / 101.0); // 5 cm itself may round either way
    EXPECT_DOUBLE_EQ(figures.refractionWrongTexel, 100.0 / 101.0);
    EXPECT_DOUBLE_EQ(figures.refractionInvalid, 0.0);

    p.used.footprint.edgePerMetre = 1.0; // from the eye each hit is 2 m away or more
    figures = errorFigures(p.used, p.truth);
    EXPECT_DOUBLE_EQ(figures.refractionWrongTexel, 0.0);
}

TEST(WaterErrors, TheFartherOfPlaceAndPictureCounts)
{
    Pair p(2);
    p.used.position[0].x += 0.3f;
    p.used.picture[0].x += 0.1f;
    p.used.position[1].x += 0.1f;
    p.used.picture[1].x += 0.3f;
    EXPECT_NEAR(*errorAt(ErrorKind::refraction, p.used, p.truth, 0), 0.3, 1e-6);
    EXPECT_NEAR(*errorAt(ErrorKind::refraction, p.used, p.truth, 1), 0.3, 1e-6);
}

TEST(WaterErrors, APixelWithoutASampleIsWrongButNoDistance)
{
    Pair p(4);
    p.used.hasSample[1] = 0;
    p.used.picture[1] = vec3(0.0f, -1000.0f, 0.0f);
    ErrorFigures figures = errorFigures(p.used, p.truth);
    EXPECT_DOUBLE_EQ(figures.refractionInvalid, 0.25);
    EXPECT_DOUBLE_EQ(figures.refractionWrong5cm, 0.25);
    EXPECT_DOUBLE_EQ(figures.refractionWrongTexel, 0.25);
    EXPECT_DOUBLE_EQ(figures.refractionMax, 0.0);

    p.used.hasSample.assign(4, 0);
    figures = errorFigures(p.used, p.truth);
    EXPECT_DOUBLE_EQ(figures.refractionInvalid, 1.0);
    EXPECT_TRUE(std::isnan(figures.refractionMedian));
}

/// A bed at -1 m over -8 to 8 m in both directions, in texels of 1 m, with a wall of half a metre on the texels of a
/// column.
HeightField bedWithWall(int column)
{
    HeightField field;
    field.rect = {vec2(0.0f), vec2(8.0f)};
    field.resolution = 16;
    field.lowest = -3.0f;
    for (int i = 0; i < 256; ++i) field.heights.push_back(i % 16 == column ? -0.5f : -1.0f);
    return field;
}

// Four rays go down at 45 degrees from (0, 0, 0), a wall's ridge stands at x = 0.5: each of them meets it at x = 1/3.
TEST(WaterErrors, ARayThatPassesWhatTheMapHoldsHasSteppedOverIt)
{
    Pair p(4);
    EXPECT_TRUE(std::isnan(errorFigures(p.used, p.truth).refractionMissed)) << "no map";
    p.used.heights = bedWithWall(8);
    for (std::size_t i = 0; i < 4; ++i) p.used.surface[i] = vec3(0.0f);
    // The ramp rises from -1 at x = -0.5 to -0.5 at 0.5: y = -0.75 + x / 2.
    p.used.position = {vec3(0.5f, -0.5f, 0.0f), vec3(1.1f, -1.1f, 0.0f), vec3(2.0f, -2.0f, 0.0f),
                       vec3(0.5f, -0.5f, 0.0f)};
    ErrorFigures figures = errorFigures(p.used, p.truth);
    EXPECT_DOUBLE_EQ(figures.refractionMissed, 0.25) << "over a texel behind it, but not less";
    p.used.hasSample[3] = 0;
    figures = errorFigures(p.used, p.truth);
    EXPECT_DOUBLE_EQ(figures.refractionMissed, 0.5) << "and what found nothing though there is something";
    p.truth.events[2] |= Event::fromBelow;
    figures = errorFigures(p.used, p.truth);
    EXPECT_DOUBLE_EQ(figures.refractionMissed, 1.0 / 3.0) << "seen from below no ray is marched";
    p.used.position.assign(4, vec3(0.0f));
    EXPECT_DOUBLE_EQ(errorFigures(p.used, p.truth).refractionMissed, 0.0) << "a ray that ends where it starts";
}

TEST(WaterErrors, ReflectionIsAnAngleFromTheTrueSurface)
{
    Pair p(3);
    const float turn = glm::radians(3.0f);
    // Straight down at pixel 0: the mirrored direction is straight up.
    p.used.mirrored[0] = vec3(std::sin(turn), std::cos(turn), 0.0f);
    EXPECT_NEAR(*errorAt(ErrorKind::reflection, p.used, p.truth, 0), 3.0, 1e-4);
    // A point at any distance along the same direction is as right, or as wrong.
    for (const float distance : {0.5f, 200.0f}) {
        p.used.mirrorsSky[1] = 0;
        p.used.mirrored[1] = p.truth.surface[1] + distance * vec3(1.0f, 1.0f, 0.0f);
        EXPECT_NEAR(*errorAt(ErrorKind::reflection, p.used, p.truth, 1), 0.0, 1e-4);
        p.used.mirrored[1] = p.truth.surface[1] + distance * vec3(0.0f, 1.0f, 0.0f);
        EXPECT_NEAR(*errorAt(ErrorKind::reflection, p.used, p.truth, 1), 45.0, 1e-4);
    }
    p.used.mirrorsSky[2] = 1;
    p.used.mirrored[2] = -p.used.mirrored[2];
    EXPECT_NEAR(errorFigures(p.used, p.truth).reflectionMax, 180.0, 1e-4);
    EXPECT_NEAR(errorFigures(p.used, p.truth).reflectionMedian, 45.0, 1e-4);
}

// The right direction may still show the wrong thing: sky before the tree that stands there, or the bank behind it.
TEST(WaterErrors, WhatIsMirroredMayBeAnotherThing)
{
    Pair p(5);
    EXPECT_DOUBLE_EQ(errorFigures(p.used, p.truth).reflectionWrong, 0.0);
    EXPECT_TRUE(std::isnan(errorFigures(p.used, p.truth).reflectionSceneP95)) << "all mirror the sky";
    const auto meets = [&](std::size_t i) { // 10 m along the true ray
        p.truth.events[i] |= Event::reflectionHit;
        p.truth.reflectionHit[i] = p.truth.surface[i] + 10.0f * p.used.mirrored[i];
    };
    const auto shows = [&](std::size_t i, float distance) {
        p.used.mirrorsSky[i] = 0;
        p.used.mirrored[i] = p.truth.surface[i] + distance * p.used.mirrored[i];
    };
    meets(0); // shows the sky
    meets(1);
    shows(1, 10.9f);
    meets(2);
    shows(2, 12.0f);
    shows(3, 10.0f); // the sky is true
    p.truth.events[4] |= Event::reflectionWater;
    shows(4, 10.0f);
    const ErrorFigures figures = errorFigures(p.used, p.truth);
    EXPECT_DOUBLE_EQ(figures.reflectionWrong, 0.75) << "0, 2 and 3 of the four that meet no water";
    EXPECT_NEAR(figures.reflectionMax, 0.0, 1e-4);
    EXPECT_GT(figures.reflectionSceneP95, 90.0);
}

TEST(WaterErrors, WaterThatMirrorsNothingHasNoErrorOfReflection)
{
    Pair p(2);
    p.used.reflects = false;
    EXPECT_EQ(errorAt(ErrorKind::reflection, p.used, p.truth, 0), std::nullopt);
    EXPECT_TRUE(std::isnan(errorFigures(p.used, p.truth).reflectionMedian));
    EXPECT_TRUE(errorAt(ErrorKind::fresnel, p.used, p.truth, 0).has_value());
}

TEST(WaterErrors, FresnelAndPathAreAbsoluteDifferences)
{
    Pair p(2);
    p.used.fresnel = {0.30f, 0.10f};
    p.used.waterPath = {0.5f, 1.5f};
    p.truth.path = {1.0f, 1.0f};
    const ErrorFigures figures = errorFigures(p.used, p.truth);
    EXPECT_NEAR(figures.fresnelMean, 0.10, 1e-6);
    EXPECT_NEAR(figures.fresnelMax, 0.15, 1e-6);
    EXPECT_NEAR(figures.pathMedian, 0.5, 1e-6);
    EXPECT_NEAR(figures.pathP99, 0.5, 1e-6);
}

TEST(WaterErrors, FromBelowThePathIsKnownWithoutAHit)
{
    Pair p(1);
    p.truth.events[0] = Event::meetsWater;
    EXPECT_FALSE(errorAt(ErrorKind::path, p.used, p.truth, 0));
    EXPECT_FALSE(errorAt(ErrorKind::refraction, p.used, p.truth, 0));
    p.truth.events[0] = Event::meetsWater | Event::fromBelow;
    p.used.waterPath[0] = 1.25f;
    EXPECT_NEAR(*errorAt(ErrorKind::path, p.used, p.truth, 0), 0.25, 1e-6);
    EXPECT_FALSE(errorAt(ErrorKind::refraction, p.used, p.truth, 0));
}

TEST(WaterErrors, NoWaterInOneIsNoError)
{
    Pair p(4);
    p.used.isWater[0] = 0;
    p.truth.events[1] = 0;
    p.used.isWater[2] = 0;
    p.truth.events[2] = 0;
    const WaterAgreement agreement = waterAgreement(p.used, p.truth);
    EXPECT_EQ(agreement.onlyTruth, 1u);
    EXPECT_EQ(agreement.onlyUsed, 1u);
    EXPECT_EQ(agreement.neither, 1u);
    EXPECT_EQ(agreement.both, 1u);
    for (const ErrorKind kind : {ErrorKind::refraction, ErrorKind::reflection, ErrorKind::fresnel, ErrorKind::path})
        for (std::size_t pixel = 0; pixel < 4; ++pixel)
            EXPECT_EQ(errorAt(kind, p.used, p.truth, pixel).has_value(), pixel == 3);

    p.truth.events.assign(4, 0);
    const ErrorFigures figures = errorFigures(p.used, p.truth);
    for (const FigureField& field : errorFigureFields()) EXPECT_TRUE(std::isnan(figures.*field.member)) << field.name;
}

TEST(WaterErrors, NothingRefractedLeavesTheOthers)
{
    Pair p(2);
    p.truth.events.assign(2, Event::meetsWater);
    const ErrorFigures figures = errorFigures(p.used, p.truth);
    EXPECT_TRUE(std::isnan(figures.refractionMedian));
    EXPECT_TRUE(std::isnan(figures.refractionInvalid));
    EXPECT_TRUE(std::isnan(figures.pathMedian));
    EXPECT_DOUBLE_EQ(figures.fresnelMax, 0.0);
    EXPECT_NEAR(figures.reflectionMax, 0.0, 1e-5);
}

TEST(WaterErrors, SizesMustAgree)
{
    const Pair p(2), q(3);
    EXPECT_THROW(errorFigures(p.used, q.truth), Error);
    EXPECT_THROW(waterAgreement(p.used, q.truth), Error);
    EXPECT_THROW(errorMap(ErrorKind::path, p.used, q.truth), Error);
}

/// A texture of 8x8 texels of half a metre about (1, 2), in a wide lake; light grows along x.
CausticsMap ramp(float border = 0.0f)
{
    CausticsMap map;
    map.region = {{vec2(1.0f, 2.0f), vec2(2.0f)}, border};
    map.water = {vec2(0.0f), vec2(100.0f)};
    map.resolution = 8;
    map.toSun = vec3(0.0f, 1.0f, 0.0f);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            map.light.emplace_back(-1.0f + 0.5f * (static_cast<float>(x) + 0.5f)); // its own x in metres
    return map;
}

vec3 rampAt(const vec2& plane) { return vec3(plane.x); }

TEST(CausticsErrors, TheTextureIsReadBetweenItsTexels)
{
    const CausticsMap map = ramp();
    for (const vec2 plane : {vec2(1.0f, 2.0f), vec2(0.3f, 1.2f), vec2(1.93f, 2.9f)})
        EXPECT_NEAR(causticsAt(map, plane)->x, plane.x, 1e-5f);
    // Two texels from the edge the frame begins to mix in a flat surface's light.
    EXPECT_TRUE(causticsAt(map, {0.01f, 2.0f}));
    EXPECT_FALSE(causticsAt(map, {-0.01f, 2.0f}));
    EXPECT_FALSE(causticsAt(ramp(1.5f), {0.4f, 2.0f}));
    EXPECT_TRUE(causticsAt(ramp(1.5f), {0.6f, 2.0f}));
    CausticsMap pond = ramp();
    pond.water = {vec2(0.0f, 2.0f), vec2(2.0f)};
    EXPECT_TRUE(causticsAt(pond, {0.9f, 2.0f}));
    EXPECT_FALSE(causticsAt(pond, {1.1f, 2.0f})); // a metre from the water's edge
}

TEST(CausticsErrors, TheSameLightHasNoError)
{
    ErrorFigures figures;
    addCausticsFigures(figures, ramp(), rampAt);
    EXPECT_NEAR(figures.causticsRmse, 0.0, 1e-6);
    EXPECT_NEAR(figures.causticsEnergy, 1.0, 1e-6);
}

TEST(CausticsErrors, RmseIsRelativeToTheMeanAndEnergyIsARatio)
{
    CausticsMap map = ramp();
    map.light.assign(64, vec3(1.2f, 0.9f, 0.9f));
    ErrorFigures figures;
    addCausticsFigures(figures, map, [](const vec2&) { return vec3(2.0f, 1.0f, 1.0f); });
    // Differences 0.8, 0.1, 0.1; the mean of the truth is 4/3.
    EXPECT_NEAR(figures.causticsRmse, std::sqrt(0.66 / 3.0) / (4.0 / 3.0), 1e-6);
    EXPECT_NEAR(figures.causticsEnergy, 3.0 / 4.0, 1e-6);
}

TEST(CausticsErrors, TheTruthIsAveragedOverTheTexel)
{
    CausticsMap map = ramp();
    map.light.assign(64, vec3(1.0f));
    ErrorFigures figures;
    // Stripes of 1/8 m, 0 and 2: their mean over any texel is 1.
    addCausticsFigures(figures, map, [](const vec2& plane) {
        return vec3(static_cast<int>(std::floor(plane.x * 8.0f)) % 2 == 0 ? 2.0f : 0.0f);
    });
    EXPECT_NEAR(figures.causticsRmse, 0.0, 1e-6);
}

TEST(CausticsErrors, PlacesThatAreNotKnownAreLeftOut)
{
    ErrorFigures figures;
    const CausticsMap map = ramp();
    addCausticsFigures(figures, map, [](const vec2& plane) -> std::optional<vec3> {
        if (plane.y > 2.0f) return std::nullopt;
        return 2.0f * rampAt(plane);
    });
    EXPECT_NEAR(figures.causticsEnergy, 0.5, 1e-6);
    ErrorFigures none;
    addCausticsFigures(none, map, [](const vec2&) { return std::optional<vec3>(); });
    EXPECT_TRUE(std::isnan(none.causticsRmse));
    addCausticsFigures(none, map, [](const vec2&) { return vec3(0.0f); }); // night
    EXPECT_TRUE(std::isnan(none.causticsEnergy));
    EXPECT_THROW(addCausticsFigures(none, map, rampAt, 0), Error);
}

// Under a slanted sun the light of a point entered the level beside it.
TEST(CausticsErrors, APixelIsComparedWhereItsLightEntered)
{
    Pair p(3);
    p.used.caustics = ramp();
    p.used.caustics->toSun = glm::normalize(vec3(0.5f, 1.0f, 0.0f));
    for (std::size_t i = 0; i < 3; ++i) {
        p.truth.events[i] |= Event::causticsKnown;
        p.truth.refractionHit[i] = vec3(0.5f, -1.0f, 2.0f); // crosses the level at x = 1
        p.truth.caustics[i] = vec3(1.0f, 1.3f, 1.0f);
    }
    p.truth.refractionHit[1].x = 40.0f;
    p.truth.events[2] |= Event::fromBelow;
    EXPECT_NEAR(*errorAt(ErrorKind::caustics, p.used, p.truth, 0), 0.1, 1e-5);
    EXPECT_FALSE(errorAt(ErrorKind::caustics, p.used, p.truth, 1));
    EXPECT_FALSE(errorAt(ErrorKind::caustics, p.used, p.truth, 2));
    p.used.caustics.reset();
    EXPECT_FALSE(errorAt(ErrorKind::caustics, p.used, p.truth, 0));
}

TEST(ErrorMap, HoldsTheErrorsAndSaysWhatIsNotKnown)
{
    Pair p(3);
    p.used.waterPath = {1.0f, 1.25f, 1.5f};
    p.used.isWater[2] = 0;
    const Image map = errorMap(ErrorKind::path, p.used, p.truth);
    EXPECT_EQ(map.channels, 1);
    ASSERT_EQ(map.floats.size(), 3u);
    EXPECT_FLOAT_EQ(map.floats[0], 0.0f);
    EXPECT_FLOAT_EQ(map.floats[1], 0.25f);
    EXPECT_TRUE(std::isnan(map.floats[2]));
}

TEST(ErrorMap, ItsColoursGrowBrighterAndGreyIsUnknown)
{
    Image map;
    map.width = 12;
    map.height = map.channels = 1;
    for (int i = 0; i <= 10; ++i) map.floats.push_back(0.05f * static_cast<float>(i));
    map.floats.push_back(std::numeric_limits<float>::quiet_NaN());
    const Image picture = heatPicture(map, 0.0, 0.5);
    ASSERT_EQ(picture.bytes.size(), 36u);
    const auto brightness = [&](std::size_t pixel) {
        return 2 * picture.bytes[3 * pixel] + 7 * picture.bytes[3 * pixel + 1] + picture.bytes[3 * pixel + 2];
    };
    for (std::size_t pixel = 1; pixel <= 10; ++pixel) EXPECT_GT(brightness(pixel), brightness(pixel - 1));
    EXPECT_LT(brightness(0), 20);
    EXPECT_EQ(heatPicture(map, 0.0, 0.01).bytes[3 * 10], picture.bytes[3 * 10]); // beyond the end is the end
    EXPECT_EQ(picture.bytes[33], picture.bytes[34]);
    EXPECT_EQ(picture.bytes[33], picture.bytes[35]);
}

} // namespace
} // namespace tarn
