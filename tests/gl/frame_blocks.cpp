// The uniform blocks as the driver lays them out are those that C++ fills.
#include "gl/shader_library.h"
#include "optics/blocks.h"
#include "render/renderer.h"
#include "render/unrolled.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace tarn::test {

namespace {

struct Member {
    const char* name;
    std::size_t offset;
};

void expectLayout(const gl::Program& program, const char* block, std::size_t size, std::initializer_list<Member> list)
{
    EXPECT_EQ(program.blockSize(block), static_cast<int>(size)) << block;
    for (const Member& member : list)
        EXPECT_EQ(program.blockOffset(member.name), static_cast<int>(member.offset)) << block << "." << member.name;
}

} // namespace

TEST(FrameBlocks, TheDriversOffsetsAreCpps)
{
    using namespace blocks;
    const auto shaders = makeShaderLibrary();
    const auto program = shaders->program("water", "passes/water.vert", "passes/water.frag",
                                          {{"DEBUG_VIEW", "0"}, {"FILTER_WAVES", "1"}, eachWave(2)});
    expectLayout(
        *program, "FrameBlock", sizeof(FrameBlock),
        {{"sunDirection", offsetof(FrameBlock, sunDirection)},
         {"time", offsetof(FrameBlock, time)},
         {"sunIrradiance", offsetof(FrameBlock, sunIrradiance)},
         {"waterLevel", offsetof(FrameBlock, waterLevel)},
         {"sunDirectionBelow", offsetof(FrameBlock, sunDirectionBelow)},
         {"ior", offsetof(FrameBlock, ior)},
         {"sunBelow", offsetof(FrameBlock, sunBelow)},
         {"hasWater", offsetof(FrameBlock, hasWater)},
         {"absorption", offsetof(FrameBlock, absorption)},
         {"waveCount", offsetof(FrameBlock, waveCount)},
         {"deepRadiance", offsetof(FrameBlock, deepRadiance)},
         {"lightCount", offsetof(FrameBlock, lightCount)},
         {"skyBelow", offsetof(FrameBlock, skyBelow)},
         {"sunSlopeDeviation", offsetof(FrameBlock, sunSlopeDeviation)},
         {"waterRect", offsetof(FrameBlock, waterRect)},
         {"waterGrid[0].lower", offsetof(FrameBlock, waterGrid)},
         {"waterGrid[1].vertices", offsetof(FrameBlock, waterGrid) + sizeof(GridAxis) + offsetof(GridAxis, vertices)},
         {"skyIrradiance[0]", offsetof(FrameBlock, skyIrradiance)},
         {"lights[0].position", offsetof(FrameBlock, lights)},
         {"lights[1].cosOuter", offsetof(FrameBlock, lights) + sizeof(LightTerm) + offsetof(LightTerm, cosOuter)},
         {"lights[1].direction", offsetof(FrameBlock, lights) + sizeof(LightTerm) + offsetof(LightTerm, direction)}});
    expectLayout(*program, "ViewBlock", sizeof(ViewBlock),
                 {{"clipFromWorld", offsetof(ViewBlock, clipFromWorld)},
                  {"viewFromWorld", offsetof(ViewBlock, viewFromWorld)},
                  {"worldFromClip", offsetof(ViewBlock, worldFromClip)},
                  {"eye", offsetof(ViewBlock, eye)},
                  {"nearPlane", offsetof(ViewBlock, nearPlane)},
                  {"clipPlane", offsetof(ViewBlock, clipPlane)},
                  {"pixels", offsetof(ViewBlock, pixels)},
                  {"farPlane", offsetof(ViewBlock, farPlane)},
                  {"pixelAngle", offsetof(ViewBlock, pixelAngle)}});
    expectLayout(*program, "WavesBlock", sizeof(WavesBlock),
                 {{"waves[0].k", offsetof(WaveTerm, k)},
                  {"waves[0].omega", offsetof(WaveTerm, omega)},
                  {"waves[0].phase", offsetof(WaveTerm, phase)},
                  {"waves[0].amplitude", offsetof(WaveTerm, amplitude)},
                  {"waves[1].wavenumber", sizeof(WaveTerm) + offsetof(WaveTerm, wavenumber)}});
    const auto photons = shaders->program("caustics photons", "passes/fullscreen.vert", "passes/caustics_photons.frag",
                                          {{"WAVE_COUNT", "1"}, eachWave(1), {"EACH_STEP", ""}});
    expectLayout(*photons, "SunBlock", sizeof(SunBlock),
                 {{"sunRect", offsetof(SunBlock, sunRect)},
                  {"sunRectsBeyond[0]", offsetof(SunBlock, sunRectsBeyond)},
                  {"sunHeights", offsetof(SunBlock, sunHeights)},
                  {"sunBiases", offsetof(SunBlock, sunBiases)},
                  {"causticsRect", offsetof(SunBlock, causticsRect)},
                  {"causticsBorder", offsetof(SunBlock, causticsBorder)}});
}

} // namespace tarn::test
