// A flight through the lake: what the plan leaves out, keeps or draws with fewer triangles must not be seen to come and
// go. The path crosses the surface, turns away from the water and looks towards it through reeds.
#include "gl_test.h"

#include "base/files.h"
#include "gl/shader_library.h"
#include "measure/image_compare.h"
#include "scene/flight.h"
#include "scene/scene_file.h"
#include "test_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace tarn::test {

namespace {

constexpr ivec2 size(160, 120);
constexpr int frames = 36;

Options smallOptions()
{
    Options options;
    options.sunlight.mapSize = 256;
    options.refraction.targetSize = options.reflection.targetSize = 128;
    options.caustics.photons = options.caustics.textureSize = 64;
    options.frame.msaa = 4;
    return options;
}

/// A picture changed by what changes from one frame to the next.
Image changedBy(const Image& picture, const Image& from, const Image& to)
{
    Image result = picture;
    for (std::size_t i = 0; i < result.bytes.size(); ++i)
        result.bytes[i] = static_cast<std::uint8_t>(std::clamp(picture.bytes[i] + to.bytes[i] - from.bytes[i], 0, 255));
    return result;
}

/// Flies with a plan beside the full frame. Whatever changes from frame to frame must change in both, within what
/// goldens allow.
std::array<int, ruleCount> fly(const Scene& scene, Options options)
{
    TestRenderer planned(scene, options);
    options.plan.enabled = false;
    options.detail.pixels = 0.0f;
    TestRenderer full(scene, options);
    std::array<int, ruleCount> applied{};
    Image plannedBefore, fullBefore;
    for (int i = 0; i < frames; ++i) {
        const Camera camera = flightCamera(scene.cameras, i / static_cast<double>(frames - 1));
        const double time = i / 30.0;
        const FrameReport& stats = planned.renderer.render({camera, time, size});
        for (std::size_t k = 0; k < ruleCount; ++k) applied[k] += stats.rules[k].applies ? 1 : 0;
        full.renderer.render({camera, time, size});
        Image a = planned.renderer.readDisplay(), b = full.renderer.readDisplay();
        EXPECT_TRUE(comparePictures(b, a).same()) << "frame " << i << ": " << comparePictures(b, a).summary();
        if (i > 0) {
            const PictureComparison pop = comparePictures(b, changedBy(fullBefore, plannedBefore, a));
            EXPECT_TRUE(pop.same()) << "from frame " << i - 1 << " to " << i << ": " << pop.summary();
        }
        plannedBefore = std::move(a);
        fullBefore = std::move(b);
    }
    return applied;
}

} // namespace

TEST(FrameFlight, NothingPops)
{
    const Scene scene = loadScene(projectRoot() / "assets/lake/lake.toml");
    const auto applied = fly(scene, smallOptions());
    const auto count = [&](RuleId id) { return applied[static_cast<std::size_t>(id)]; };
    EXPECT_EQ(count(RuleId::cullChunks), frames);
    EXPECT_EQ(count(RuleId::keepMaps), frames - 1) << "the sun stands still";
    EXPECT_GT(count(RuleId::cullHidden), frames / 4) << "reeds, hills and the pier hide water";
    EXPECT_GT(count(RuleId::glowOutOfView), frames / 4);
}

TEST(FrameFlight, NorDoLevelsOfDetail)
{
    const Scene scene = loadScene(projectRoot() / "assets/lake/lake.toml");
    Options options = smallOptions();
    options.detail.pixels = 0.1f;
    fly(scene, options);
}

} // namespace tarn::test
