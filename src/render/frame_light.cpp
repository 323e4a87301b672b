#include "render/frame_light.h"

#include "optics/optics.h"
#include "optics/waves.h"
#include "render/unrolled.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace tarn {

namespace {

/// Sun and sky as they are just under the surface at rest.
void lightBelow(blocks::FrameBlock& block, const WaterBody& water, const SkyModel& sky)
{
    const vec3 up(0.0f, 1.0f, 0.0f);
    block.sunDirectionBelow = optics::refractedSunDirection(block.sunDirection, water.ior);
    block.sunBelow = optics::sunIrradianceBelow(block.sunIrradiance, block.sunDirection.y, water.ior);
    block.skyBelow = optics::skyIrradianceBelow(glm::max(sky.irradiance(up), vec3(0.0f)));
    block.deepRadiance =
        optics::deepWaterRadiance(water.colour, block.sunBelow * block.sunDirectionBelow.y, block.skyBelow);
}

} // namespace

blocks::FrameBlock frameBlock(const Scene& scene, const WaterBody& water, const SkyModel& sky, const Options& options)
{
    blocks::FrameBlock block{};
    block.time = 0.0f; // the waves' phases carry it: see wavesBlock
    block.sunDirection = sky.sunDirection();
    block.sunIrradiance = sky.sunIrradiance();
    block.waterLevel = water.level;
    block.ior = water.ior;
    block.hasWater = water.present && options.water.enabled ? 1.0f : 0.0f;
    block.absorption = water.absorption;
    block.waveCount = static_cast<float>(drawnWaveCount(water));
    block.sunSlopeDeviation = options.water.sunSlopeDeviation;
    block.waterRect = vec4(water.centre, 0.5f * water.extent);
    for (std::size_t i = 0; i < 9; ++i) block.skyIrradiance[i] = vec4(sky.irradianceCoefficients()[i], 0.0f);
    lightBelow(block, water, sky);

    std::size_t count = 0;
    for (const PointLight& light : scene.pointLights) {
        if (count == blocks::maxLights) break;
        block.lights[count++] = {light.position, 1.0f, light.intensity, -2.0f, vec3(0.0f, -1.0f, 0.0f), 0.0f};
    }
    for (const SpotLight& light : scene.spotLights) {
        if (count == blocks::maxLights) break;
        block.lights[count++] = {light.position,  std::cos(light.innerAngle),
                                 light.intensity, std::cos(light.outerAngle),
                                 light.direction, 0.0f};
    }
    block.lightCount = static_cast<float>(count);
    return block;
}

blocks::FrameBlock lastingLight(const blocks::FrameBlock& light)
{
    blocks::FrameBlock lasting = light;
    lasting.time = 0.0f;
    for (blocks::GridAxis& axis : lasting.waterGrid) axis = {};
    return lasting;
}

bool sameLight(const blocks::FrameBlock& a, const blocks::FrameBlock& b)
{
    return std::memcmp(&a, &b, sizeof a) == 0; // floats, whose padding has names and is zero
}

int drawnLightCount(const Scene& scene)
{
    return static_cast<int>(
        std::min<std::size_t>(scene.pointLights.size() + scene.spotLights.size(), blocks::maxLights));
}

int drawnWaveCount(const WaterBody& water)
{
    return static_cast<int>(std::min<std::size_t>(water.waves.size(), blocks::maxWaves));
}

blocks::WavesBlock wavesBlock(const WaterBody& water, double time)
{
    blocks::WavesBlock block{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(drawnWaveCount(water)); ++i) {
        const Wave& wave = water.waves[i];
        block.waves[i] = optics64::waveTermAt(
            optics64::makeWaveTerm(wave.amplitude, wave.wavelength, wave.direction, wave.phase, wave.period), time);
    }
    return block;
}

} // namespace tarn
