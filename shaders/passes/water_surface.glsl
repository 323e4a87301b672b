// The point U of the water's surface that a fragment shows, for the passes that draw it. Needs blocks.glsl and waves.glsl.

in vec3 drawnW; // what the grid's triangle shows
#ifdef VERTEX_NORMALS
in vec2 vertexSlope;
#endif

vec3 surfaceW; // U: on the waves themselves after surfaceHere()

struct Surface {
    vec3 normal;     // N, up
    float roughness; // slope variance of the waves that a pixel cannot show
};

// How much of a wave a pixel shows that spans these two vectors of the surface: short crests must fade before they alias.
float shownOf(WaveTerm w, vec2 across, vec2 along)
{
#ifdef FILTER_WAVES
    return waveFilter(w, length(vec2(dot(w.k, across), dot(w.k, along))) / max(w.wavenumber, 1.0e-6));
#else
    return 1.0;
#endif
}

#if SURFACE_STEPS > 0
// Newton's method along the eye's ray, from the triangle to the waves that it stands for. Never faster than twice the
// step to a level plane, for the slope says nothing where a ray grazes a crest; and never further than a quarter of the
// way to the eye, so that it stays on the side of the surface on which the triangle is drawn.
void moveToWaves(vec2 across, vec2 along)
{
    float far = distance(drawnW, eye);
    vec3 direction = (drawnW - eye) / far;
    float side = direction.y < 0.0 ? -1.0 : 1.0;
    float least = max(0.5 * abs(direction.y), 1.0e-3);
    float moved = 0.0;
    for (int step = 0; step < SURFACE_STEPS; ++step) {
        vec3 sum = vec3(0.0); // height and slope
        for (int i = 0; i < int(waveCount); ++i)
            sum += shownOf(waves[i], across, along) * waveTerm(waves[i], surfaceW.xz, time);
        float gap = surfaceW.y - waterLevel - sum.x;
        float rate = side * (direction.y - dot(sum.yz, direction.xz));
        moved = clamp(moved - side * gap / max(rate, least), -0.25 * far, 0.25 * far);
        surfaceW = drawnW + moved * direction;
    }
}
#endif

Surface surfaceHere()
{
    Surface s;
    surfaceW = drawnW;
    s.roughness = sunRoughness * sunRoughness;
    vec2 across = dFdx(drawnW.xz);
    vec2 along = dFdy(drawnW.xz);
#if SURFACE_STEPS > 0
    moveToWaves(across, along);
#endif
#ifdef VERTEX_NORMALS
    s.normal = waveNormal(vertexSlope);
#else
    vec2 slope = vec2(0.0);
    for (int i = 0; i < int(waveCount); ++i) {
        WaveTerm w = waves[i];
        float weight = shownOf(w, across, along);
#ifdef FILTER_WAVES
        s.roughness += 0.5 * waveLostVariance(w, weight);
#endif
        slope += weight * waveTerm(w, surfaceW.xz, time).yz;
    }
    s.normal = waveNormal(slope);
#endif
    return s;
}
