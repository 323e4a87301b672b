// The point U of the water's surface that a fragment shows, for the passes that draw it. Needs blocks.glsl, waves.glsl and
// normal_map.glsl.

in vec3 drawnW; // what the grid's triangle shows
#ifdef VERTEX_NORMALS
in vec2 vertexSlope;
#endif

vec3 surfaceW; // U: on the waves themselves after surfaceHere()

struct Surface {
    vec3 normal;     // N, up: of all waves, at U
    vec3 meanNormal; // of the waves that a pixel can show: about it lie the facets that mirror into the pixel
    float roughness; // slope variance of the others
    vec3 plainNormal; // the same as meanNormal, but for the normal map's bump factor
};

#if SURFACE_STEPS > 0
// Newton's method along the eye's ray, from the triangle to the waves that it stands for. Never faster than twice the
// step to a level plane, for the slope says nothing where a ray grazes a crest; and never further than a quarter of the
// way to the eye, so that it stays on the side of the surface on which the triangle is drawn.
void moveToWaves()
{
    float far = distance(drawnW, eye);
    vec3 direction = (drawnW - eye) / far;
    float side = direction.y < 0.0 ? -1.0 : 1.0;
    float least = max(0.5 * abs(direction.y), 1.0e-3);
    float moved = 0.0;
    for (int step = 0; step < SURFACE_STEPS; ++step) {
        vec3 sum = vec3(0.0); // height and slope
        for (int i = 0; i < int(waveCount); ++i) sum += waveTerm(waves[i], surfaceW.xz, time);
        float gap = surfaceW.y - waterLevel - sum.x;
        float rate = side * (direction.y - dot(sum.yz, direction.xz));
        moved = clamp(moved - side * gap / max(rate, least), -0.25 * far, 0.25 * far);
        surfaceW = drawnW + moved * direction;
    }
}
#endif

#ifdef NORMAL_MAP
uniform sampler2D normalMap; // RGB: normals, -1 to 1; A: half the square of their slope
uniform float normalMapTile; // m
uniform float normalMapBump;
uniform vec2 normalMapOffsets[4];

vec2 slopeOf(vec3 normal) { return -normal.xz / normal.y; }

// The normal map's slopes on top of the waves': those of the finest texels for the normal at U, those that a pixel can
// show for the mean one, and what these have lost as roughness.
void addRipples(inout Surface s)
{
    vec2 across = dFdx(drawnW.xz) / normalMapTile, along = dFdy(drawnW.xz) / normalMapTile;
    vec3 sum = vec3(0.0), meanSum = vec3(0.0);
    float lost = 0.0;
    for (int i = 0; i < 4; ++i) {
        vec2 place = surfaceW.xz / normalMapTile + normalMapOffsets[i];
        sum += textureLod(normalMap, place, 0.0).xyz;
#ifdef FILTER_WAVES
        vec4 mean = textureGrad(normalMap, place, across, along);
        meanSum += mean.xyz;
        lost += normalMapLostVariance(mean);
#endif
    }
#ifdef FILTER_WAVES
    s.roughness += normalMapRoughness(lost, normalMapBump);
#else
    meanSum = sum;
#endif
    vec2 meanSlope = slopeOf(s.meanNormal);
    s.normal = waveNormal(slopeOf(s.normal) + normalMapSlope(sum, normalMapBump));
    s.meanNormal = waveNormal(meanSlope + normalMapSlope(meanSum, normalMapBump));
    s.plainNormal = waveNormal(meanSlope + normalMapSlope(meanSum, 1.0));
}
#endif

Surface surfaceHere()
{
    Surface s;
    surfaceW = drawnW;
    s.roughness = sunRoughness * sunRoughness;
#if SURFACE_STEPS > 0
    moveToWaves();
#endif
#ifdef VERTEX_NORMALS
    s.normal = waveNormal(vertexSlope);
    s.meanNormal = s.normal;
#else
    // A wave fades, before it aliases, by how much of it lies between two pixels.
    vec2 across = dFdx(drawnW.xz);
    vec2 along = dFdy(drawnW.xz);
    vec2 slope = vec2(0.0), meanSlope = vec2(0.0);
    for (int i = 0; i < int(waveCount); ++i) {
        WaveTerm w = waves[i];
        vec2 termSlope = waveTerm(w, surfaceW.xz, time).yz;
        slope += termSlope;
#ifdef FILTER_WAVES
        float footprint = length(vec2(dot(w.k, across), dot(w.k, along))) / max(w.wavenumber, 1.0e-6);
        float weight = waveFilter(w, footprint);
        s.roughness += 0.5 * waveLostVariance(w, weight);
        meanSlope += weight * termSlope;
#endif
    }
    s.normal = waveNormal(slope);
    s.meanNormal = s.normal;
#ifdef FILTER_WAVES
    s.meanNormal = waveNormal(meanSlope);
#endif
#endif
    s.plainNormal = s.meanNormal;
#ifdef NORMAL_MAP
    addRipples(s);
#endif
    return s;
}
