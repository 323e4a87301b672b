// Loops of a shader written out by the preprocessor.
//
// A software rasteriser runs every loop once more than it counts, with all pixels masked out, and reads what a loop's
// counter indexes lane by lane: written out, a sum over the waves takes a fraction of the time. Shaders compile no
// branch for what a scene does not have. The cost is a program for each count.
#pragma once

#include "gl/shader_source.h"
#include "scene/scene.h"

#include <string>

namespace tarn {

/// The definition of `macro`: BODY(0) BODY(1) … BODY(count - 1), each a statement of its own, to be used as
///
///     #define WAVE(i) sum = addWave(sum, waves[i], 1.0, x, time);
///         EACH_WAVE
///     #undef WAVE
///
/// @param most counts beyond this become a loop: the compiler's time grows with what is written out
inline std::pair<std::string, std::string> unrolled(const std::string& macro, const std::string& body, int count,
                                                    int most)
{
    if (count > most) return {macro, "for (int i = 0; i < " + std::to_string(count) + "; ++i) { " + body + "(i) }"};
    std::string text;
    for (int i = 0; i < count; ++i) text += body + "(" + std::to_string(i) + ") ";
    return {macro, text};
}

/// EACH_WAVE of shaders/shared/waves.glsl, for a known number of waves.
inline std::pair<std::string, std::string> eachWave(int waveCount)
{
    constexpr int most = 32;
    return unrolled("EACH_WAVE", "WAVE", waveCount, most);
}

/// How many waves of the water a frame shows: WavesBlock holds no more.
int drawnWaveCount(const WaterBody& water);

/// How many of the scene's point and spot lights a frame shows: FrameBlock holds no more.
int drawnLightCount(const Scene& scene);

/// EACH_SURFACE_STEP: the steps of Newton's method from the grid to the waves; not defined when there are none.
inline void addSurfaceSteps(gl::Defines& defines, int steps)
{
    if (steps > 0) defines.push_back(unrolled("EACH_SURFACE_STEP", "SURFACE_STEP", steps, steps));
}

} // namespace tarn
