// Waves on the CPU: from physical parameters to the terms that shaders/shared/waves.glsl sums, and that sum.
//
//     std::vector<optics64::WaveTerm> terms{optics64::makeWaveTerm(0.05, 4.0, 0.3, 0.0)};
//     const double y = water.level + optics64::waveHeight(terms, {x, z}, t);
//
// x is (x, z) in world space, heights are relative to the water's level; metres, seconds, radians.
#pragma once

#include "optics/optics.h"

#include <span>

namespace tarn::optics {

/// One component. Its wave travels along `direction` (in the xz plane, from +x towards +z).
/// @param wavelength  m, positive
/// @param period      s; 0: the deep-water dispersion relation, omega² = gravity · k (Airy 1845)
WaveTerm makeWaveTerm(float amplitude, float wavelength, float direction, float phase, float period = 0.0f,
                      float gravity = 9.81f);

/// Height and slope, all components: waveSum of shaders/shared/waves.glsl.
WaveSum waveAt(std::span<const WaveTerm> waves, vec2 x, float t);
float waveHeight(std::span<const WaveTerm> waves, vec2 x, float t);
/// Upward unit normal.
vec3 waveNormalAt(std::span<const WaveTerm> waves, vec2 x, float t);

/// The surface never leaves level ± this.
float totalAmplitude(std::span<const WaveTerm> waves);
/// Mean square slope per axis, Σ A²k²/4: what the glint of a surface seen from far away needs.
float slopeVariance(std::span<const WaveTerm> waves);

} // namespace tarn::optics

namespace tarn::optics64 {

WaveTerm makeWaveTerm(double amplitude, double wavelength, double direction, double phase, double period = 0.0,
                      double gravity = 9.81);
WaveSum waveAt(std::span<const WaveTerm> waves, dvec2 x, double t);
double waveHeight(std::span<const WaveTerm> waves, dvec2 x, double t);
dvec3 waveNormalAt(std::span<const WaveTerm> waves, dvec2 x, double t);
double totalAmplitude(std::span<const WaveTerm> waves);
double slopeVariance(std::span<const WaveTerm> waves);

/// The term for the GPU at time t: omega · t is folded into the phase in double and omega set to 0, so that
/// any time (0, say) may be passed to the shader. A float product omega · t has lost a tenth of a radian
/// after some days.
optics::WaveTerm waveTermAt(const WaveTerm& wave, double t);

} // namespace tarn::optics64
