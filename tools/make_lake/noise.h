// Noise over the plane and in space, from a hash of lattice points: no tables, no state.
#pragma once

#include "random.h"

namespace tarn::lake {

inline float saturate(float x) { return std::min(std::max(x, 0.0f), 1.0f); }
inline float smoothStep(float lower, float upper, float x)
{
    const float t = saturate((x - lower) / (upper - lower));
    return t * t * (3.0f - 2.0f * t);
}
inline float mix(float a, float b, float t) { return a + (b - a) * t; }
inline vec3 mix(const vec3& a, const vec3& b, float t) { return a + (b - a) * t; }

/// A pseudo-random word for a lattice point.
std::uint32_t hash(int x, int y, int z, std::uint32_t seed);

/// The same as a number from 0 to 1.
float hashUnit(int x, int y, int z, std::uint32_t seed);

struct Cell {
    float nearest = 0.0f, second = 0.0f; ///< distances to the two nearest feature points
    vec2 offset{0.0f};                   ///< from the nearest feature point to the place asked for
    float id = 0.0f;                     ///< 0 to 1, one value per cell
};

/// Lattice spacing is 1. With a period the pattern repeats after so many cells in x and y, which is
/// what makes the textures tile.
class Noise {
public:
    explicit Noise(std::uint32_t seed) : seed_(seed) {}

    /// Gradient noise (Perlin 2002), about -1 to 1.
    float at(vec2 p, ivec2 period = ivec2(0)) const;
    float at(const vec3& p) const;

    /// Sum of octaves, each at twice the frequency and `gain` times the amplitude; about -1 to 1.
    float fractal(vec2 p, int octaves, ivec2 period = ivec2(0), float gain = 0.5f) const;
    float fractal(const vec3& p, int octaves, float gain = 0.5f) const;

    /// Octaves of 1 - |noise|: crests; 0 to 1.
    float ridges(vec2 p, int octaves, ivec2 period = ivec2(0)) const;
    float ridges(const vec3& p, int octaves) const;

    /// Worley 1996.
    Cell cell(vec2 p, ivec2 period = ivec2(0)) const;

private:
    std::uint32_t seed_;
};

} // namespace tarn::lake
