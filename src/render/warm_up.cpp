#include "render/warm_up.h"

#include "base/progress.h"

namespace tarn {

namespace {

/// Everything there is, as small as it can be: no chunk is left out, and the targets cost nothing.
Options tiny(Options options)
{
    const auto wanted = options.plan.rules;
    options.plan.rules.fill(false);
    options.plan.rules[static_cast<std::size_t>(RuleId::keepMaps)] = true;
    const auto chooser = static_cast<std::size_t>(RuleId::fewestCascades); // of programs
    options.plan.rules[chooser] = wanted[chooser];
    constexpr int least = 16;
    options.sunlight.mapSize = options.heights.mapSize = least;
    options.refraction.targetSize = options.reflection.targetSize = least;
    options.caustics.photons = options.caustics.textureSize = least;
    return options;
}

Camera levelCamera(const vec3& eye)
{
    Camera camera;
    camera.eye = eye;
    camera.target = eye + vec3(1.0f, -0.1f, 0.0f);
    return camera;
}

} // namespace

std::vector<WarmUpFrame> warmUpFrames(const Options& options, const WaterBody& water)
{
    const Options all = tiny(options);
    const float amplitude = totalAmplitude(water);
    const float above = water.level + amplitude + 1.0f;
    std::vector<WarmUpFrame> frames;
    // The rules leave out either target, and with the bed its caustics.
    for (const bool refracts : {true, false}) {
        for (const bool reflects : {true, false}) {
            Options variant = all;
            variant.refraction.enabled = refracts && options.refraction.enabled;
            variant.reflection.enabled = reflects && options.reflection.enabled;
            frames.push_back({variant, above});
        }
    }
    if (water.present && options.water.enabled) {
        Options glowless = all;
        glowless.glow.enabled = false;
        frames.push_back({glowless, above});
        frames.push_back({all, surfaceHeight(water, water.centre, 0.0)}); // cuts the near plane
        frames.push_back({all, water.level - amplitude - 1.0f});
    }
    return frames;
}

void drawWarmUp(Renderer& renderer, const WarmUpFrame& frame, const WaterBody& water)
{
    const Camera camera = levelCamera(vec3(water.centre.x, frame.height, water.centre.y));
    renderer.setOptions(frame.options, water);
    renderer.render({camera, 0.0, {16, 12}});
}

void warmUp(Renderer& renderer, const WaterBody& water, Progress* progress)
{
    const Options options = renderer.options();
    const std::vector<WarmUpFrame> frames = warmUpFrames(options, water);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        if (progress)
            progress->report(static_cast<double>(i) / static_cast<double>(frames.size()), "building shaders");
        drawWarmUp(renderer, frames[i], water);
    }
    renderer.setOptions(options, water);
}

} // namespace tarn
