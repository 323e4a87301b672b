#include "render/warm_up.h"

#include "base/progress.h"
#include "gl/shader_library.h"
#include "gl/vertex_array.h"

#include <fmt/format.h>

#include <functional>

namespace tarn {

namespace {

/// A small one of each round that is not the size itself: nothing that is drawn here may be taken for what the user's
/// frames, or those of another round, would hold.
int smallSize(int size, std::size_t round)
{
    for (const int small : {16, 32, 64})
        if (small != size && round-- == 0) return small;
    return size;
}

/// Everything there is, as small as it can be: no chunk is left out, and the targets cost nothing.
Options tiny(Options options, std::size_t round)
{
    const auto wanted = options.plan.rules;
    options.plan.rules.fill(false);
    options.plan.rules[static_cast<std::size_t>(RuleId::keepMaps)] = true;
    const auto chooser = static_cast<std::size_t>(RuleId::fewestCascades); // of programs
    options.plan.rules[chooser] = wanted[chooser];
    for (int* size : {&options.sunlight.mapSize, &options.heights.mapSize, &options.refraction.targetSize,
                      &options.reflection.targetSize, &options.caustics.photons, &options.caustics.textureSize})
        *size = smallSize(*size, round);
    return options;
}

Camera levelCamera(const vec3& eye)
{
    Camera camera;
    camera.eye = eye;
    camera.target = eye + vec3(1.0f, -0.1f, 0.0f);
    return camera;
}

/// Frames that together use every program that a frame with these options may use.
/// @param round 0 or 1
void drawEverySort(Renderer& renderer, const Options& options, const WaterBody& water, std::size_t round)
{
    const Options all = tiny(options, round);
    const auto draw = [&](const Options& variant, float height) {
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
    if (!water.present || !options.water.enabled) return;
    Options glowless = all;
    glowless.glow.enabled = false;
    draw(glowless, above);
    draw(all, surfaceHeight(water, water.centre, 0.0)); // cuts the near plane
    draw(all, water.level - amplitude - 1.0f);
}

/// The renderer as it was, whatever happens meanwhile.
class WarmingUp {
public:
    explicit WarmingUp(Renderer& renderer, const WaterBody& water)
        : renderer_(renderer), options_(renderer.options()), water_(water)
    {
        renderer_.setWarmingUp(true);
    }
    ~WarmingUp()
    {
        renderer_.shaders().countFirstUses({});
        renderer_.setWarmingUp(false);
        renderer_.setOptions(options_, water_);
    }
    const Options& options() const { return options_; }

private:
    Renderer& renderer_;
    Options options_;
    const WaterBody& water_;
};

} // namespace

void warmUp(Renderer& renderer, const WaterBody& water, Progress* progress)
{
    const WarmingUp state(renderer, water);
    gl::ShaderLibrary& shaders = renderer.shaders();
    const auto say = [progress](double fraction, const std::string& what) {
        if (progress) progress->report(fraction, what);
    };
    std::size_t programs = 0;
    shaders.countFirstUses([&] { say(0.0, fmt::format("compiling shaders, {} so far", programs++)); });
    {
        // How many there are is known only once they are compiled, of which drivers leave the longer part to the first draw.
        const gl::NoDrawing noDrawing;
        drawEverySort(renderer, state.options(), water, 0);
    }
    std::size_t drawn = 0;
    shaders.countFirstUses([&] {
        say(static_cast<double>(drawn) / static_cast<double>(programs),
            fmt::format("building shaders, {} of {}", drawn + 1, programs));
        ++drawn;
    });
    drawEverySort(renderer, state.options(), water, 1);
}

} // namespace tarn
