// The yardstick of benchmarks draws what it says it does.
#include "gl/counters.h"
#include "measure/yardstick.h"
#include "render/renderer.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tarn {
namespace {

TEST(Yardstick, DrawsTheWholeTerrainInOnePlainCall)
{
    const auto shaders = makeShaderLibrary();
    Yardstick yardstick(*shaders);
    yardstick.draw(0); // what is made once is made
    const gl::Counters before = gl::counters();
    yardstick.draw(1);
    const gl::Counters calls = gl::counters() - before;
    EXPECT_EQ(calls[gl::Call::draw], 1u);
    EXPECT_EQ(calls[gl::Call::programBind], 1u);
    EXPECT_EQ(calls[gl::Call::textureBind], 1u);
    EXPECT_EQ(calls[gl::Call::uniformUpload], 0u);
    EXPECT_EQ(calls[gl::Call::clear], 2u);

    const gl::Target& target = yardstick.target();
    EXPECT_EQ(target.size(), ivec2(1024, 768));
    EXPECT_EQ(target.colour().format(), gl::Format::rgba8);
    EXPECT_EQ(target.depth().format(), gl::Format::depth24);
    EXPECT_EQ(target.samples(), 1);
    const std::vector<float> depths = target.framebuffer().readDepth();
    const auto [highest, lowest] = std::minmax_element(depths.begin(), depths.end());
    EXPECT_LT(*lowest, 1.0f) << "it fills the picture";
    EXPECT_GT(*lowest, 0.98f) << "and its heights the depth";
    EXPECT_GT(*highest, 0.0f);
    EXPECT_LT(*highest, 0.02f);
}

TEST(Yardstick, ShowsThePictureOfTheGround)
{
    const auto shaders = makeShaderLibrary();
    Yardstick yardstick(*shaders);
    yardstick.draw(0);
    const std::vector<std::uint8_t> bytes = yardstick.target().framebuffer().readBytes();
    const std::size_t middle = 4u * (384u * 1024u + 512u);
    EXPECT_GT(bytes[middle + 1], bytes[middle + 2]) << "ground is more green than blue";
    EXPECT_GT(bytes[middle], 40);
    const auto [least, most] = std::minmax_element(bytes.begin() + static_cast<std::ptrdiff_t>(middle) - 400,
                                                   bytes.begin() + static_cast<std::ptrdiff_t>(middle));
    EXPECT_GT(*most - *least, 20) << "and not of one colour";
}

TEST(Yardstick, TellsItsTriangles)
{
    const auto shaders = makeShaderLibrary();
    Yardstick yardstick(*shaders);
    const std::vector<BenchPass> passes = yardstick.drawPasses(0);
    ASSERT_EQ(passes.size(), 1u);
    EXPECT_EQ(passes[0].triangles, 100352u);
    EXPECT_GT(passes[0].wallMs, 0.0);
    EXPECT_GT(passes[0].cpuMs, 0.0);
}

} // namespace
} // namespace tarn
