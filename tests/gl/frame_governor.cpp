// What the viewer's governor relies on: sizes need no programs of their own, and averaged samples are the supersampled
// picture.
#include "gl/shader_library.h"
#include "gl_test.h"
#include "plan/ladder.h"
#include "plan/refinement.h"
#include "render/warm_up.h"
#include "test_renderer.h"
#include "test_scenes.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

namespace tarn::test {
namespace {

Options small()
{
    Options options;
    options.sunlight.mapSize = 64;
    options.refraction.targetSize = options.reflection.targetSize = 32;
    options.caustics.photons = options.caustics.textureSize = 32;
    return options;
}

/// Twice the value where the option allows it, else half of it, else none.
std::vector<std::string> otherValues(const FieldRow& row)
{
    if (row.type == "int")
        return {fmt::format("{}", 2 * std::stoi(row.value)), fmt::format("{}", std::stoi(row.value) / 2)};
    if (row.type == "float")
        return {fmt::format("{}", 2.0f * std::stof(row.value)), fmt::format("{}", 0.5f * std::stof(row.value))};
    return {};
}

TEST(FrameGovernor, SizesAndNumbersNeedNoProgramsOfTheirOwn)
{
    const Scene scene = rippledLake();
    const Options base = small();
    TestRenderer test(scene, base);
    warmUp(test.renderer, scene.water);
    const std::size_t before = test.shaders->built();
    int tried = 0;
    Options listed = base;
    for (const FieldRow& row : listFields([&](FieldVisitor& visitor) { visit(visitor, listed); })) {
        if (!isSizeOnly(row.key)) continue;
        for (const std::string& value : otherValues(row)) {
            Options options = base;
            try {
                assign([&](FieldVisitor& visitor) { visit(visitor, options); }, {row.key, value, "test"});
            } catch (const std::exception&) {
                continue; // out of its range
            }
            if (!programsServe(base, options)) continue;
            test.renderer.setOptions(options, scene.water);
            test.renderer.render({lookAcross(), 0.1, {32, 24}});
            EXPECT_EQ(test.shaders->built(), before) << row.key << " = " << value;
            ++tried;
        }
    }
    EXPECT_GT(tried, 20);

    Options other = base;
    other.sunlight.taps = 1;
    test.renderer.setOptions(other, scene.water);
    test.renderer.render({lookAcross(), 0.1, {32, 24}});
    EXPECT_GT(test.shaders->built(), before) << "what is no size does, or the test shows nothing";
}

double rmse(const Image& a, const Image& b)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < a.floats.size(); ++i)
        sum += std::pow(static_cast<double>(a.floats[i] - b.floats[i]), 2.0);
    return std::sqrt(sum / static_cast<double>(a.floats.size()));
}

TEST(FrameGovernor, AveragedSamplesAreTheSupersampledPicture)
{
    const Scene scene = rippledLake();
    Options options = small();
    options.glow.enabled = false;
    options.frame.msaa = 1;
    const ivec2 size(80, 60);
    TestRenderer test(scene, options);
    const auto draw = [&](int sample) {
        test.renderer.render({lookAcross(), 0.7, size, DebugView::final, false, sample});
        return test.renderer.readLinear();
    };
    const Image alone = draw(0);
    EXPECT_LT(rmse(draw(1), alone), 1e-4) << "the first is the picture itself";
    Image mean;
    for (int n = 1; n <= Refinement::samples; ++n) mean = draw(n);
    const FrameReport& again =
        test.renderer.render({lookAcross(), 0.7, size, DebugView::final, false, Refinement::samples});
    EXPECT_TRUE(again.rule(RuleId::keepFrame).applies) << "and is kept";
    EXPECT_LT(rmse(draw(1), alone), 1e-4) << "it begins anew";

    options.frame.scale = 8.0f;
    test.renderer.setOptions(options, scene.water);
    const Image truth = draw(0);
    EXPECT_LT(rmse(mean, truth), 0.45 * rmse(alone, truth)) << "of the single sample's error";
    options.frame.scale = 4.0f;
    test.renderer.setOptions(options, scene.water);
    EXPECT_LT(rmse(mean, truth), 1.25 * rmse(draw(0), truth)) << "about as good as so many samples on a grid";
}

TEST(FrameGovernor, TargetsAndMapsStayWhileSamplesAreAveraged)
{
    const Scene scene = rippledLake();
    TestRenderer test(scene, small());
    const auto draw = [&](int sample) -> const FrameReport& {
        return test.renderer.render({lookAcross(), 0.7, {80, 60}, DebugView::final, false, sample});
    };
    draw(1);
    const FrameReport& second = draw(2);
    EXPECT_TRUE(second.rule(RuleId::keepTargets).applies) << second.rule(RuleId::keepTargets).why;
    EXPECT_TRUE(second.rule(RuleId::keepMaps).applies) << second.rule(RuleId::keepMaps).why;
}

} // namespace
} // namespace tarn::test
