#include "optics/waves.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace tarn {

namespace {

template <typename Term, typename T> Term makeTerm(T amplitude, T wavelength, T direction, T phase, T period, T gravity)
{
    assert(wavelength > T(0) && period >= T(0) && gravity > T(0));
    const T twoPi = T(2) * std::numbers::pi_v<T>;
    Term term{};
    term.wavenumber = twoPi / wavelength;
    term.k = {term.wavenumber * std::cos(direction), term.wavenumber * std::sin(direction)};
    term.omega = period > T(0) ? twoPi / period : std::sqrt(gravity * term.wavenumber);
    term.phase = phase;
    term.amplitude = amplitude;
    return term;
}

template <typename T, typename Term> T sumOfAmplitudes(std::span<const Term> waves)
{
    T sum = T(0);
    for (const Term& wave : waves) sum += std::abs(wave.amplitude);
    return sum;
}

template <typename T, typename Term> T varianceOfSlope(std::span<const Term> waves)
{
    T sum = T(0);
    for (const Term& wave : waves) {
        const T steepness = wave.amplitude * wave.wavenumber;
        sum += T(0.25) * steepness * steepness;
    }
    return sum;
}

} // namespace

namespace optics {

WaveTerm makeWaveTerm(float amplitude, float wavelength, float direction, float phase, float period, float gravity)
{
    return makeTerm<WaveTerm>(amplitude, wavelength, direction, phase, period, gravity);
}

WaveSum waveAt(std::span<const WaveTerm> waves, vec2 x, float t)
{
    return waveSum(waves.data(), static_cast<int>(waves.size()), x, t);
}

float waveHeight(std::span<const WaveTerm> waves, vec2 x, float t) { return waveAt(waves, x, t).height; }

vec3 waveNormalAt(std::span<const WaveTerm> waves, vec2 x, float t) { return waveNormal(waveAt(waves, x, t).slope); }

float totalAmplitude(std::span<const WaveTerm> waves) { return sumOfAmplitudes<float>(waves); }

float slopeVariance(std::span<const WaveTerm> waves) { return varianceOfSlope<float>(waves); }

} // namespace optics

namespace optics64 {

WaveTerm makeWaveTerm(double amplitude, double wavelength, double direction, double phase, double period,
                      double gravity)
{
    return makeTerm<WaveTerm>(amplitude, wavelength, direction, phase, period, gravity);
}

WaveSum waveAt(std::span<const WaveTerm> waves, dvec2 x, double t)
{
    return waveSum(waves.data(), static_cast<int>(waves.size()), x, t);
}

double waveHeight(std::span<const WaveTerm> waves, dvec2 x, double t) { return waveAt(waves, x, t).height; }

dvec3 waveNormalAt(std::span<const WaveTerm> waves, dvec2 x, double t) { return waveNormal(waveAt(waves, x, t).slope); }

double totalAmplitude(std::span<const WaveTerm> waves) { return sumOfAmplitudes<double>(waves); }

double slopeVariance(std::span<const WaveTerm> waves) { return varianceOfSlope<double>(waves); }

optics::WaveTerm waveTermAt(const WaveTerm& wave, double t)
{
    optics::WaveTerm term{};
    term.k = vec2(wave.k);
    term.phase = static_cast<float>(std::remainder(wave.phase - wave.omega * t, 2.0 * std::numbers::pi));
    term.amplitude = static_cast<float>(wave.amplitude);
    term.wavenumber = static_cast<float>(wave.wavenumber);
    return term;
}

} // namespace optics64

} // namespace tarn
