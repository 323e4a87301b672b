// The water surface: a sum of sines, y = sum of A sin(k·x - omega t + phase), x in the xz plane.
//
// Needs blocks.glsl (WaveTerm) and trigonometry.glsl. Heights are relative to the water's level. Metres, seconds, radians.

// GLSL reads the uniform block's array `waves`, which cannot be a parameter without being copied for every fragment.
// The C++ build defines this as `const WaveTerm* waves,` (src/optics/GenerateOptics.cmake).
#define WAVE_ARRAY

struct WaveSample {
    float height;       // m above the level
    vec2 slope;         // dy/dx, dy/dz
    float filteredVariance; // of the slope, per axis: what the footprint averaged away
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

// The same for a pixel whose edges span these vectors of the surface, x and z in m: the footprint is how much of them goes
// along the wave.
SHARED float waveFilterOverPixel(WaveTerm w, vec2 across, vec2 along)
{
    float a = dot(w.k, across), b = dot(w.k, along); // radians from pixel to pixel
    return exp(-0.125 * (a * a + b * b));
}

// Variance of a component's slope along its direction that its weight takes away: A²k²/2 is all of it.
SHARED float waveFilteredVariance(WaveTerm w, float weight)
{
    float steepness = w.amplitude * w.wavenumber;
    return 0.5 * steepness * steepness * (1.0 - weight * weight);
}

// All components at x and t, seen through a footprint (0: unfiltered).
SHARED WaveSample waveSum(WAVE_ARRAY int count, vec2 x, float t, float footprint)
{
    WaveSample result;
    result.height = 0.0;
    result.slope = vec2(0.0);
    result.filteredVariance = 0.0;
    for (int i = 0; i < count; ++i) {
        float weight = waveFilter(waves[i], footprint);
        vec3 term = weight * waveTerm(waves[i], x, t);
        result.height += term.x;
        result.slope += vec2(term.y, term.z);
        // Half of it to each axis: the glint that takes it up is round.
        result.filteredVariance += 0.5 * waveFilteredVariance(waves[i], weight);
    }
    return result;
}

// Upward unit normal of a height field with these slopes.
SHARED vec3 waveNormal(vec2 slope)
{
    return normalize(vec3(-slope.x, 1.0, -slope.y));
}
