// How far off geometry may be in a view, so that nothing is seen to move.
#include "render/view.h"
#include "render/visibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace tarn::test {

namespace {

constexpr ivec2 size(320, 200);

vec2 pixelOf(const View& view, const vec3& point)
{
    const vec4 clip = view.clipFromWorld() * vec4(point, 1.0f);
    return (vec2(clip) / clip.w * 0.5f + 0.5f) * vec2(size);
}

Camera wideCamera(float lensShift)
{
    Camera camera;
    camera.eye = {1.0f, 5.0f, 2.0f};
    camera.target = {4.0f, 3.0f, -6.0f};
    camera.verticalFov = 1.2f;
    camera.lensShift = lensShift;
    return camera;
}

class Shifts {
public:
    vec3 direction()
    {
        vec3 d;
        do d = vec3(unit_(random_), unit_(random_), unit_(random_));
        while (glm::length(d) > 1.0f || glm::length(d) < 0.1f);
        return glm::normalize(d);
    }
    float unit() { return unit_(random_); }

private:
    std::mt19937 random_{7};
    std::uniform_real_distribution<float> unit_{-1.0f, 1.0f};
};

} // namespace

TEST(GeometryError, MovesNothingByMoreThanItsPixels)
{
    Shifts shifts;
    for (const float lensShift : {0.0f, 0.3f}) {
        const View view = mainView(wideCamera(lensShift), 1.6f);
        const float perMetre = geometryErrorOf(view, size, 0.5f);
        ASSERT_GT(perMetre, 0.0f);
        float most = 0.0f;
        for (int trial = 0; trial < 20000; ++trial) {
            const vec4 far = glm::inverse(view.clipFromWorld()) * vec4(shifts.unit(), shifts.unit(), 0.5f, 1.0f);
            const vec3 ray = glm::normalize(vec3(far) / far.w - view.eye);
            const float distance = 30.0f + 20.0f * shifts.unit();
            const vec3 point = view.eye + distance * ray;
            // To first order: a hundredth of the shift, times a hundred.
            const vec3 moved = point + 0.01f * perMetre * distance * shifts.direction();
            most = std::max(most, 100.0f * glm::distance(pixelOf(view, moved), pixelOf(view, point)));
        }
        EXPECT_LE(most, 0.53f);
        EXPECT_GT(most, lensShift == 0.0f ? 0.3f : 0.2f) << "a bound that is far from reached costs triangles";
    }
}

TEST(GeometryError, HoldsInParallelProjectionsAnywhere)
{
    Shifts shifts;
    View view;
    view.clipFromView = glm::ortho(-20.0f, 30.0f, -10.0f, 10.0f, 1.0f, 100.0f);
    view.viewFromWorld = glm::lookAt(vec3(0, 30, 0), vec3(5, 0, 0), vec3(0, 0, 1));
    ASSERT_TRUE(view.isParallel());
    EXPECT_FALSE(mainView(wideCamera(0.0f), 1.0f).isParallel());
    const float allowed = geometryErrorOf(view, size, 0.5f);
    float most = 0.0f;
    for (int trial = 0; trial < 5000; ++trial) {
        const vec3 point = 20.0f * shifts.direction();
        most = std::max(most, glm::distance(pixelOf(view, point + allowed * shifts.direction()), pixelOf(view, point)));
    }
    EXPECT_LE(most, 0.501f);
    EXPECT_GT(most, 0.25f);
}

TEST(GeometryError, IsSmallestWhereTheShoreWouldMove)
{
    View view = mainView(wideCamera(0.0f), 1.6f);
    WaterBody water;
    water.present = true;
    water.extent = vec2(100.0f);
    Chunk chunk;
    chunk.boundsW = {{-1, 2, -1}, {1, 3, 1}};
    EXPECT_EQ(allowedError(view, chunk, &water, false), 0.0f) << "a view that asks for full detail";
    view.geometryError = geometryErrorOf(view, size, 0.5f);
    const float air = allowedError(view, chunk, &water, false);
    EXPECT_NEAR(air, view.geometryError * glm::distance(view.eye, vec3(1, 3, 1)), 1e-5f);
    EXPECT_EQ(allowedError(view, chunk, nullptr, false), air);
    chunk.boundsW.lower.y = -1.0f;
    EXPECT_NEAR(allowedError(view, chunk, &water, false), 0.1f * air, 1e-5f) << "across the level";
    EXPECT_NEAR(allowedError(view, chunk, &water, true), air, 1e-5f);
    EXPECT_NEAR(allowedError(view, chunk, nullptr, false), air, 1e-5f);
    chunk.boundsW = {{-1, -3, -1}, {1, -2, 1}};
    const float sunken = allowedError(view, chunk, &water, false);
    view.flatWater = 0.0f;
    EXPECT_NEAR(allowedError(view, chunk, &water, false), sunken / water.ior, 1e-5f);
}

TEST(VisibleChunks, AreTheCoarsestThatDo)
{
    // Two pieces of full detail, one that stands for both, and one above that.
    Chunks chunks;
    const auto at = [](float x, float error, std::array<int, 2> finer) {
        Chunk chunk;
        chunk.boundsW = {{x - 1, -1, -51}, {x + 1, 1, -50}};
        chunk.error = error;
        chunk.finer = finer;
        return chunk;
    };
    chunks.all = {at(-1, 0, {-1, -1}), at(1, 0, {-1, -1}), at(0, 0.02f, {0, 1}), at(0, 0.4f, {2, -1})};
    chunks.full = 2;
    chunks.coarsest = {3};
    const std::vector<Material> materials(1);
    Camera camera;
    camera.eye = vec3(0.0f);
    camera.target = {0, 0, -1};
    View view = mainView(camera, 1.0f);
    const auto drawn = [&](float error) {
        view.geometryError = error / 50.0f;
        std::vector<int> indices;
        for (const Chunk* chunk : visibleChunks(chunks, materials, view, {}, true, nullptr))
            indices.push_back(static_cast<int>(chunk - chunks.all.data()));
        return indices;
    };
    EXPECT_EQ(drawn(0.0f), (std::vector<int>{0, 1}));
    EXPECT_EQ(drawn(0.01f), (std::vector<int>{0, 1}));
    EXPECT_EQ(drawn(0.03f), (std::vector<int>{2}));
    EXPECT_EQ(drawn(0.5f), (std::vector<int>{3}));
    view.viewFromWorld = glm::lookAt(vec3(0.0f), vec3(0, 0, 1), vec3(0, 1, 0));
    EXPECT_TRUE(drawn(0.03f).empty()) << "behind the eye";
}

} // namespace tarn::test
