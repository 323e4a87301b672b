// The point U of the water's surface that a fragment shows, for the passes that draw it. Needs blocks.glsl and waves.glsl.

in vec3 surfaceW; // U
#ifdef VERTEX_NORMALS
in vec2 vertexSlope;
#endif

struct Surface {
    vec3 normal;     // N, up
    float roughness; // slope variance of the waves that a pixel cannot show
};

Surface surfaceHere()
{
    Surface s;
    s.roughness = sunRoughness * sunRoughness;
#ifdef VERTEX_NORMALS
    s.normal = waveNormal(vertexSlope);
#else
    vec2 slope = vec2(0.0);
    vec2 across = dFdx(surfaceW.xz);
    vec2 along = dFdy(surfaceW.xz);
    for (int i = 0; i < int(waveCount); ++i) {
        WaveTerm w = waves[i];
        float weight = 1.0;
#ifdef FILTER_WAVES
        // The pixel's extent along this wave: short crests must fade before they alias.
        weight = waveFilter(w, length(vec2(dot(w.k, across), dot(w.k, along))) / max(w.wavenumber, 1.0e-6));
        s.roughness += 0.5 * waveLostVariance(w, weight);
#endif
        slope += weight * waveTerm(w, surfaceW.xz, time).yz;
    }
    s.normal = waveNormal(slope);
#endif
    return s;
}
