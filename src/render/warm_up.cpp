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

void warmUp(Renderer& renderer, const WaterBody& water, Progress* progress)
{
    const Options options = renderer.options();
    const Options all = tiny(options);
    const double draws = water.present && options.water.enabled ? 7.0 : 4.0;
    double done = 0.0;
    const auto draw = [&](const Options& variant, float height) {
        if (progress) progress->report(done++ / draws, "building shaders");
        const Camera camera = levelCamera(vec3(water.centre.x, height, water.centre.y));
        renderer.setOptions(variant, water);
        renderer.render({camera, 0.0, {16, 12}});
    };
    const float amplitude = totalAmplitude(water);
    const float above = water.level + amplitude + 1.0f;
    // The rules leave out either target, and with the bed its caustics.
    for (const bool refracts : {true, false}) {
        for (const bool reflects : {true, false}) {
            Options variant = all;
            variant.refraction.enabled = refracts && options.refraction.enabled;
            variant.reflection.enabled = reflects && options.reflection.enabled;
            draw(variant, above);
        }
    }
    if (water.present && options.water.enabled) {
        Options glowless = all;
        glowless.glow.enabled = false;
        draw(glowless, above);
        draw(all, surfaceHeight(water, water.centre, 0.0)); // cuts the near plane
        draw(all, water.level - amplitude - 1.0f);
    }
    renderer.setOptions(options, water);
}

} // namespace tarn
