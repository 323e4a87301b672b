// Rays over height fields: the shared formulas against brute force, and the pyramid that says where nothing can be met.
#include "optics/optics.h"
#include "render/height_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace tarn::test {
namespace {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

TEST(HeightField, StepsAreAsManyAsPublished)
{
    EXPECT_DOUBLE_EQ(optics64::refractionStepsPerUnit(-1.0), 3.0);
    EXPECT_DOUBLE_EQ(optics64::refractionStepsPerUnit(0.0), 10.0);
    EXPECT_DOUBLE_EQ(optics64::refractionStepsPerUnit(-0.5), 6.5);
    EXPECT_DOUBLE_EQ(optics64::reflectionStepsPerUnit(0.0), 4.0);
    EXPECT_DOUBLE_EQ(optics64::reflectionStepsPerUnit(1.0), 0.5);
}

// The lines from (0, 3) to (1, 1) and from (0, 0) to (1, 2) meet at 3/4.
TEST(HeightField, TwoLinesMeetWhereTheDerivationSays)
{
    EXPECT_DOUBLE_EQ(optics64::crossingFraction(3.0, 0.0, 1.0, 2.0), 0.75);
    EXPECT_DOUBLE_EQ(optics64::crossingFraction(1.0, 0.0, -1.0, 0.0), 0.5);
    EXPECT_DOUBLE_EQ(optics64::crossingFraction(2.0, 2.0, 1.0, 2.0), 0.0);
}

struct PatchRay {
    dvec4 corners;
    dvec3 from, along;
    double within = 0.0; ///< to where the ray leaves the cell

    double over(double t) const
    {
        const dvec3 p = from + t * along;
        return p.z - optics64::patchHeight(corners, {p.x, p.y});
    }
};

PatchRay anyRay(std::mt19937& random)
{
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    PatchRay ray;
    for (int i = 0; i < 4; ++i) ray.corners[i] = unit(random);
    const dvec2 place(unit(random), unit(random));
    ray.from = dvec3(place, optics64::patchHeight(ray.corners, place) + 0.5 * unit(random));
    ray.along = dvec3(2.0 * unit(random) - 1.0, 2.0 * unit(random) - 1.0, -unit(random));
    const auto exit = [](double at, double speed) { return speed > 0.0 ? (1.0 - at) / speed : at / -speed; };
    ray.within = std::min(exit(place.x, ray.along.x), exit(place.y, ray.along.y));
    return ray;
}

TEST(HeightField, APatchIsMetWhereBruteForceMeetsIt)
{
    std::mt19937 random(7);
    int met = 0, missed = 0;
    for (int i = 0; i < 20000; ++i) {
        const PatchRay ray = anyRay(random);
        const double t = optics64::patchCrossing(ray.corners, ray.from, ray.along, ray.within);
        constexpr int steps = 400;
        if (t < 0.0) {
            ++missed;
            for (int j = 0; j <= steps; ++j) ASSERT_GT(ray.over(ray.within * j / steps), -1.0e-9) << i;
            continue;
        }
        ++met;
        ASSERT_LE(t, ray.within);
        ASSERT_NEAR(ray.over(t), 0.0, 1.0e-9) << i;
        for (int j = 0; j < steps; ++j) // the first meeting, not the second
            ASSERT_GT(ray.over(t * j / steps), -1.0e-9) << i;
        const float single =
            optics::patchCrossing(vec4(ray.corners), vec3(ray.from), vec3(ray.along), static_cast<float>(ray.within));
        // A ray that only just touches may miss in single precision.
        const double slope = std::abs(ray.over(t + 1.0e-6) - ray.over(t)) / 1.0e-6;
        if (slope > 0.05 && t < 0.99 * ray.within) {
            EXPECT_NEAR(single, t, 1.0e-4 / slope) << i;
        }
    }
    EXPECT_GT(met, 3000);
    EXPECT_GT(missed, 3000);
}

TEST(HeightField, UnderThePatchIsMetAtOnce)
{
    EXPECT_DOUBLE_EQ(optics64::patchCrossing(dvec4(1.0), dvec3(0.5, 0.5, 0.9), dvec3(1.0, 0.0, -1.0), 1.0), 0.0);
    EXPECT_DOUBLE_EQ(optics64::patchCrossing(dvec4(1.0), dvec3(0.5, 0.5, 1.5), dvec3(0.0, 0.0, -1.0), 1.0), 0.5)
        << "straight down";
    EXPECT_LT(optics64::patchCrossing(dvec4(1.0), dvec3(0.5, 0.5, 1.5), dvec3(0.0, 0.0, -1.0), 0.4), 0.0);
}

HeightField randomField(int edge)
{
    HeightField field;
    field.rect = {vec2(3.0f, -2.0f), vec2(0.5f * static_cast<float>(edge))};
    field.resolution = edge;
    field.lowest = -5.0f;
    std::mt19937 random(3);
    std::uniform_real_distribution<float> height(-4.0f, 0.0f);
    for (int i = 0; i < edge * edge; ++i) field.heights.push_back(height(random));
    return field;
}

TEST(HeightField, IsReadBetweenTexels)
{
    const HeightField field = randomField(8);
    const auto texel = [&](int i, int j) { return field.heights[static_cast<std::size_t>(8 * j + i)]; };
    const vec2 lower = field.rect.centre - field.rect.halfExtent;
    EXPECT_FLOAT_EQ(field.at(lower + vec2(2.5f, 3.5f)), texel(2, 3));
    EXPECT_FLOAT_EQ(field.at(lower + vec2(3.0f, 3.5f)), 0.5f * (texel(2, 3) + texel(3, 3)));
    EXPECT_FLOAT_EQ(field.at(lower - vec2(9.0f)), texel(0, 0)) << "beside it, its border";
    EXPECT_FLOAT_EQ(field.at(lower + vec2(99.0f)), texel(7, 7));
    EXPECT_FLOAT_EQ(field.texel(), 1.0f);
}

// A point is held where the surface passes it, also on the wall between two texels of different heights.
TEST(HeightField, HoldsWhatItsSurfacePasses)
{
    HeightField field;
    field.rect = {vec2(0.0f), vec2(4.0f)};
    field.resolution = 8;
    field.lowest = -5.0f;
    for (int j = 0; j < 8; ++j)
        for (int i = 0; i < 8; ++i) field.heights.push_back(i < 4 ? -3.0f : -1.0f);
    EXPECT_TRUE(field.holds({-2.0f, -3.02f, 0.0f}, 0.05f));
    EXPECT_FALSE(field.holds({-2.0f, -2.8f, 0.0f}, 0.05f)) << "in the water over the bed";
    EXPECT_TRUE(field.holds({0.0f, -2.0f, 0.0f}, 0.05f)) << "on the wall";
    EXPECT_FALSE(field.holds({3.0f, -3.0f, 0.0f}, 0.05f)) << "under a ledge";
}

// Every place of a block, and not only its corners: what is between two blocks belongs to both.
TEST(HeightField, NothingInABlockIsOverItsLargest)
{
    const HeightField field = randomField(16);
    const auto levels = largestHeights(field);
    ASSERT_EQ(levels.size(), 4u);
    EXPECT_EQ(levels.back().size(), 1u);
    EXPECT_EQ(levels.back().front(), *std::max_element(field.heights.begin(), field.heights.end()));
    const vec2 firstCentre = field.rect.centre - field.rect.halfExtent + 0.5f;
    for (int j = 0; j <= 150; ++j)
        for (int i = 0; i <= 150; ++i) {
            const vec2 place = 0.1f * vec2(static_cast<float>(i), static_cast<float>(j));
            const float height = field.at(firstCentre + place);
            for (std::size_t level = 0; level < levels.size(); ++level) {
                const auto edge = static_cast<std::size_t>(16) >> (level + 1);
                const vec2 block = glm::floor(place / std::exp2(static_cast<float>(level + 1)));
                const std::size_t at = static_cast<std::size_t>(block.y) * edge + static_cast<std::size_t>(block.x);
                ASSERT_LE(height, levels[level].at(at) + 1.0e-5f) << i << ' ' << j << ' ' << level;
            }
        }
}

dvec3 unit(double x, double y, double z) { return glm::normalize(dvec3(x, y, z)); }

// y = -1 + 0.2 x - 0.1 z over the whole map; beside it nothing is met, and nothing under `lowest`.
TEST(HeightField, ARayMeetsASlopeWhereTheFormulaSays)
{
    HeightField field;
    field.rect = {vec2(0.0f), vec2(4.0f)};
    field.resolution = 32;
    field.lowest = -5.0f;
    for (int j = 0; j < 32; ++j)
        for (int i = 0; i < 32; ++i)
            field.heights.push_back(-1.0f + 0.2f * (0.25f * (static_cast<float>(i) + 0.5f) - 4.0f) -
                                    0.1f * (0.25f * (static_cast<float>(j) + 0.5f) - 4.0f));
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-3.0, 3.0);
    int met = 0;
    for (int i = 0; i < 2000; ++i) {
        const dvec3 from(place(random), 0.0, place(random)),
            ray = unit(place(random), -1.0 - std::abs(place(random)), place(random));
        const double exact = (-1.0 + 0.2 * from.x - 0.1 * from.z - from.y) / (ray.y - 0.2 * ray.x + 0.1 * ray.z);
        const dvec3 hit = from + exact * ray;
        if (exact < 0.0 || std::max(std::abs(hit.x), std::abs(hit.z)) > 3.8) continue;
        const auto t = field.firstMeeting(from, ray);
        ASSERT_TRUE(t) << i;
        ASSERT_NEAR(*t, exact, 1.0e-5) << i;
        ++met;
    }
    EXPECT_GT(met, 1000);
    EXPECT_FALSE(field.firstMeeting({3.9, 0.0, 0.0}, unit(1.0, -0.1, 0.0))) << "leaves the map";
    field.heights.assign(field.heights.size(), -5.0f);
    EXPECT_FALSE(field.firstMeeting({0.0, 0.0, 0.0}, unit(0.1, -1.0, 0.0))) << "nothing lies there";
    EXPECT_EQ(field.firstMeeting({0.0, -6.0, 0.0}, unit(0.1, -1.0, 0.0)), std::nullopt) << "from under it all";
}

// Small steps never find ground before the meeting, and ground right behind it.
TEST(HeightField, ARayMeetsTheFirstThingInItsWay)
{
    const HeightField field = randomField(32);
    std::mt19937 random(9);
    std::uniform_real_distribution<double> place(-12.0, 12.0);
    int met = 0;
    for (int i = 0; i < 300; ++i) {
        const dvec3 from = dvec3(3.0 + place(random), 0.1, -2.0 + place(random));
        const dvec3 ray = unit(place(random), -2.0, place(random));
        const auto t = field.firstMeeting(from, ray);
        if (!t) continue;
        ++met;
        const auto over = [&](double along) {
            const dvec3 p = from + along * ray;
            return p.y - static_cast<double>(field.at(vec2(p.x, p.z)));
        };
        for (int j = 0; j < 1000; ++j) ASSERT_GT(over(*t * j / 1000.0), -1.0e-5) << i;
        ASSERT_NEAR(over(*t), 0.0, 1.0e-5) << i;
    }
    EXPECT_GT(met, 250);
}

TEST(HeightField, SizesArePowersOfTwo)
{
    EXPECT_EQ(powerOfTwo(16), 16);
    EXPECT_EQ(powerOfTwo(17), 32);
    EXPECT_EQ(powerOfTwo(1000), 1024);
}

} // namespace
} // namespace tarn::test
