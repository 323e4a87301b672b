// The water surface: a sum of sines, y = sum of A sin(k·x - omega t + phase), x in the xz plane.
//
// Needs blocks.glsl (WaveTerm) and trigonometry.glsl. Heights are relative to the water level. Metres, seconds, radians.
//
// Whoever needs the surface (every pass, the plan, the reference, the tests) calls one of the sums below or, for the drawn
// grid, of water_grid.glsl. They are the only loops over the waves.

// GLSL reads the uniform block's array `waves`, which cannot be a parameter without being copied for every fragment. The
// C++ build defines this as `const WaveTerm* waves, int waveCount,` (src/optics/GenerateOptics.cmake).
#define WAVE_ARRAY

// Weights, one for each wave: the uniform array `waveWeights` of a pass that defines WAVE_WEIGHTS. In the C++ build
// `const float* waveWeights,`.
#define WEIGHT_ARRAY

// WAVE(i) for each wave. A pass that knows the number of waves defines it as that many statements (src/render/unrolled.h):
// a software rasteriser pays for a loop and for reading an array at a loop's counter.
#ifndef EACH_WAVE
#define EACH_WAVE for (int i = 0; i < int(waveCount); ++i) { WAVE(i) }
#endif

// Height and slope of the surface, or of what has been summed of it.
struct WaveSum {
    float height; // m above the water level
    vec2 slope;   // dy/dx, dy/dz
};

// What a pixel resolves of the waves, and what it does not.
struct FilteredWaves {
    vec2 slope;          // of the surface: dy/dx, dy/dz
    vec2 meanSlope;      // the mean over the pixel
    float slopeVariance; // per axis, of the slopes about that mean
};

// One component: height, dy/dx, dy/dz at x (m) and t (s).
SHARED vec3 waveTerm(WaveTerm w, vec2 x, float t)
{
    float angle = dot(w.k, x) - w.omega * t + w.phase;
    vec2 sc = w.amplitude * sineAndCosine(angle);
    return vec3(sc.x, sc.y * w.k.x, sc.y * w.k.y);
}

// What is left of a component's amplitude after averaging over a pixel that spans `footprint` metres of the surface:
// the Fourier transform of a Gaussian whose standard deviation is half the footprint. 1 at footprint 0, 0.29 for a
// wave of two footprints (the shortest that pixels can show), 0.007 for one of one footprint.
SHARED float waveFilter(WaveTerm w, float footprint)
{
    float kSigma = 0.5 * w.wavenumber * footprint;
    return exp(-0.5 * kSigma * kSigma);
}

// The same for a pixel whose edges span the vectors `across` and `along` of the surface (x and z, m): the footprint is their
// extent in the wave's direction.
SHARED float waveFilterOverPixel(WaveTerm w, vec2 across, vec2 along)
{
    float a = dot(w.k, across), b = dot(w.k, along); // radians from pixel to pixel
    return exp(-0.125 * (a * a + b * b));
}

// Variance of a component's slope, in its direction, that filtering takes away when it leaves this weight of the amplitude.
// The whole variance is A²k²/2.
SHARED float waveFilteredVariance(WaveTerm w, float weight)
{
    float steepness = w.amplitude * w.wavenumber;
    return 0.5 * steepness * steepness * (1.0 - weight * weight);
}

SHARED WaveSum noWaves()
{
    WaveSum sum;
    sum.height = 0.0;
    sum.slope = vec2(0.0);
    return sum;
}

SHARED WaveSum addWave(WaveSum sum, WaveTerm w, float weight, vec2 x, float t)
{
    vec3 term = weight * waveTerm(w, x, t);
    sum.height += term.x;
    sum.slope += vec2(term.y, term.z);
    return sum;
}

SHARED FilteredWaves addFilteredWave(FilteredWaves sum, WaveTerm w, vec2 x, float t, vec2 across, vec2 along)
{
    vec3 term = waveTerm(w, x, t);
    vec2 slope = vec2(term.y, term.z);
    float weight = waveFilterOverPixel(w, across, along);
    sum.slope += slope;
    sum.meanSlope += weight * slope;
    // Half of the variance to each axis: the glint that takes it up is round.
    sum.slopeVariance += 0.5 * waveFilteredVariance(w, weight);
    return sum;
}

// The surface at x and t.
SHARED WaveSum waveSum(WAVE_ARRAY vec2 x, float t)
{
    WaveSum sum = noWaves();
#define WAVE(i) sum = addWave(sum, waves[i], 1.0, x, t);
    EACH_WAVE
#undef WAVE
    return sum;
}

// The surface with each wave's amplitude multiplied by a weight.
#ifdef WAVE_WEIGHTS
SHARED WaveSum weightedWaveSum(WAVE_ARRAY WEIGHT_ARRAY vec2 x, float t)
{
    WaveSum sum = noWaves();
#define WAVE(i) sum = addWave(sum, waves[i], waveWeights[i], x, t);
    EACH_WAVE
#undef WAVE
    return sum;
}
#endif

// The slopes at x and t in a pixel whose edges span `across` and `along` (x and z, m).
// baseVariance: slope variance of a surface without waves, which theirs is added to.
SHARED FilteredWaves filteredWaves(WAVE_ARRAY vec2 x, float t, vec2 across, vec2 along, float baseVariance)
{
    FilteredWaves sum;
    sum.slope = vec2(0.0);
    sum.meanSlope = vec2(0.0);
    sum.slopeVariance = baseVariance;
#define WAVE(i) sum = addFilteredWave(sum, waves[i], x, t, across, along);
    EACH_WAVE
#undef WAVE
    return sum;
}

// Upward unit normal of a height field with these slopes.
SHARED vec3 waveNormal(vec2 slope)
{
    return normalize(vec3(-slope.x, 1.0, -slope.y));
}
