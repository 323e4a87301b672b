// Which of the sun's maps a box lies in.
#include "optics/optics.h"
#include "render/sun_views.h"

#include <gtest/gtest.h>

#include <random>

namespace tarn::test {

namespace {

SunVolume threeMaps()
{
    SunVolume volume;
    volume.cascades = {{{3, -2}, {10, 8}}, {{5, 0}, {25, 22}}, {{20, 10}, {80, 70}}};
    return volume;
}

Bounds boxAt(const vec3& centre, float half) { return {centre - half, centre + half}; }

constexpr float level = 1.5f;
const vec3 toSun = glm::normalize(vec3(0.7f, 0.5f, -0.3f));

/// The map that scene.frag looks a point up in; 3: none holds it.
unsigned firstHolding(const SunVolume& volume, const vec3& point)
{
    const vec2 plane = optics::sunPlane(point, level, optics::sunSlant(toSun));
    for (unsigned i = 0; i < volume.cascades.size(); ++i)
        if (glm::all(glm::lessThanEqual(glm::abs(plane - volume.cascades[i].centre), volume.cascades[i].halfExtent))) return i;
    return 3;
}

} // namespace

TEST(CascadesHolding, AreThoseThatAnyPointOfTheBoxIsLookedUpIn)
{
    const SunVolume volume = threeMaps();
    std::mt19937 random(7);
    std::uniform_real_distribution<float> place(-90.0f, 110.0f), height(-5.0f, 15.0f), size(0.5f, 20.0f), within(-1.0f, 1.0f);
    int left = 0;
    for (int i = 0; i < 2000; ++i) {
        const vec3 centre(place(random), height(random), place(random));
        const float half = size(random);
        const unsigned held = cascadesHolding(volume, onPlane(boxAt(centre, half), toSun, level));
        for (int k = 0; k < 20; ++k) {
            const vec3 point = centre + half * vec3(within(random), within(random), within(random));
            const unsigned first = firstHolding(volume, point);
            if (first < 3) {
                EXPECT_TRUE(held & 1u << first);
            }
        }
        if (held != 7u) ++left;
    }
    EXPECT_GT(left, 1000) << "or nothing is ever left out";
}

TEST(CascadesHolding, AreAsFewAsABoxAsksFor)
{
    const SunVolume volume = threeMaps();
    const auto held = [&](const vec3& centre) { return cascadesHolding(volume, onPlane(boxAt(centre, 2), toSun, level)); };
    EXPECT_EQ(held({3, level, -2}), 1u);
    EXPECT_EQ(held({22, level, 0}), 2u);
    EXPECT_EQ(held({80, level, 40}), 4u);
    EXPECT_EQ(held({13, level, 0}), 3u);
    EXPECT_EQ(held({500, level, 0}), 0u);
}

} // namespace tarn::test
