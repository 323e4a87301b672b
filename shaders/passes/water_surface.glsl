// The point U of the water's surface that a fragment shows, and its normals, for the passes that draw the surface. Needs
// blocks.glsl, waves.glsl and normal_map.glsl.

in vec3 drawnW; // on the grid's triangle
#ifdef VERTEX_NORMALS
in vec2 vertexSlope;
#endif

uniform float footprint; // size of a sample's footprint in pixels: less than 1 if several samples of a pixel are averaged

vec3 surfaceW; // U: on the waves themselves after surfaceHere()

struct Surface {
    vec3 normal;         // N, up: of all waves, at U
    vec3 meanNormal;     // of the waves that a pixel resolves: the mean of the facets that mirror into the pixel
    float slopeVariance; // of the others
    vec3 plainNormal;    // meanNormal without the normal map's bump factor
};

#ifdef EACH_SURFACE_STEP
// Newton's method along the eye's ray, from the triangle to the waves that it approximates. A step is at most twice the one to
// a level plane, since the slope means nothing where a ray grazes a crest; and the sum of steps is at most a quarter of the
// distance to the eye, so that U stays on the side of the surface on which the triangle is drawn.
// moved: m along the ray so far.
float surfaceStep(float moved, vec3 direction, float side, float least, float most)
{
    WaveSum sum = waveSum(surfaceW.xz, time);
    float gap = surfaceW.y - waterLevel - sum.height;
    float rate = side * (direction.y - dot(sum.slope, direction.xz));
    float next = clamp(moved - side * gap / max(rate, least), -most, most);
    surfaceW = drawnW + next * direction;
    return next;
}

void moveToWaves()
{
    float range = distance(drawnW, eye);
    vec3 direction = (drawnW - eye) / range;
    float side = direction.y < 0.0 ? -1.0 : 1.0;
    float least = max(0.5 * abs(direction.y), 1.0e-3);
    float moved = 0.0;
#define SURFACE_STEP(i) moved = surfaceStep(moved, direction, side, least, 0.25 * range);
    EACH_SURFACE_STEP
#undef SURFACE_STEP
}
#endif

#ifdef NORMAL_MAP
uniform sampler2D normalMap; // RGB: normals, -1 to 1; A: half the square of their slope
uniform float normalMapTile; // m
uniform float normalMapBump;
uniform vec2 normalMapOffsets[4];

vec2 slopeOf(vec3 normal) { return -normal.xz / normal.y; }

// Adds the normal map's slopes to the waves': unfiltered ones to the normal at U, filtered ones to the mean normal, and the
// variance that filtering has taken away to the slope variance.
void addRipples(inout Surface s)
{
    vec2 across = dFdx(drawnW.xz) * (footprint / normalMapTile), along = dFdy(drawnW.xz) * (footprint / normalMapTile);
    vec3 sum = vec3(0.0), meanSum = vec3(0.0);
    float filteredVariances = 0.0;
    for (int i = 0; i < 4; ++i) {
        vec2 uv = surfaceW.xz / normalMapTile + normalMapOffsets[i];
        sum += textureLod(normalMap, uv, 0.0).xyz;
#ifdef FILTER_WAVES
        vec4 mean = textureGrad(normalMap, uv, across, along);
        meanSum += mean.xyz;
        filteredVariances += normalMapFilteredVariance(mean);
#endif
    }
#ifdef FILTER_WAVES
    s.slopeVariance += normalMapSlopeVariance(filteredVariances, normalMapBump);
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
    s.slopeVariance = sunSlopeDeviation * sunSlopeDeviation;
#ifdef EACH_SURFACE_STEP
    moveToWaves();
#endif
#ifdef VERTEX_NORMALS
    s.normal = waveNormal(vertexSlope);
    s.meanNormal = s.normal;
#elif defined(FILTER_WAVES)
    // A wave fades before it aliases, as its phase advances from pixel to pixel.
    vec2 across = footprint * dFdx(drawnW.xz), along = footprint * dFdy(drawnW.xz);
    FilteredWaves sum = filteredWaves(surfaceW.xz, time, across, along, s.slopeVariance);
    s.normal = waveNormal(sum.slope);
    s.meanNormal = waveNormal(sum.meanSlope);
    s.slopeVariance = sum.slopeVariance;
#else
    s.normal = waveNormal(waveSum(surfaceW.xz, time).slope);
    s.meanNormal = s.normal;
#endif
    s.plainNormal = s.meanNormal;
#ifdef NORMAL_MAP
    addRipples(s);
#endif
    return s;
}
