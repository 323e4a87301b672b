// Intersects a ray with the map of what stands over the water. Needs shared/height_field.glsl, height_pyramid.glsl and the
// uniform marchUnit, m, that Lipp's steps are counted in.
//
// The map is drawn from straight above and from straight below. At each point it holds one piece, from its underside to its
// top: a bank is solid down to the water, a deck is not. The gap between two pieces, one over the other, counts as solid.
// PYRAMID: through the pyramid; else as Lipp does, whose map is drawn from below alone and counts as solid down to the water.

uniform sampler2D aboveWaterHeights; // r: underside, g: top, b: height drawn from below, m; mip level n: least and largest of those
uniform vec4 aboveWaterRect;         // what it covers: centre x, z and half extent x, z, m
uniform float aboveWaterHighest;     // over all of it, m

const float aboveWaterEmpty = 1.0e4; // as an underside: nothing stands there. Its negative: solid down to the water

struct AboveWaterHit {
    vec3 point;    // world
    float isFound; // 1 or 0
    float isUnder; // 1 if the underside was hit
};

vec2 aboveWaterTexel(vec2 xz) { return mapTexel(xz, aboveWaterRect, textureSize(aboveWaterHeights, 0)); }

#ifdef PYRAMID
// Of four corners: their undersides, all solid where one of them is, and where nothing stands as low as the others are.
vec4 cellUndersides(vec4 under)
{
    float least = min(min(under.x, under.y), min(under.z, under.w));
    if (least < -0.5 * aboveWaterEmpty) return vec4(-aboveWaterEmpty);
    return mix(under, vec4(least), step(0.5 * aboveWaterEmpty, under));
}

// Metres from the entry into a cell to where the ray is within what stands there, or -1.
float cellCrossing(ivec2 cell, vec3 from, vec3 along, float within, out float isUnder)
{
    ivec2 last = textureSize(aboveWaterHeights, 0) - 1;
    ivec2 low = clamp(cell, ivec2(0), last), high = clamp(cell + 1, ivec2(0), last);
    vec2 a = texelFetch(aboveWaterHeights, low, 0).rg, b = texelFetch(aboveWaterHeights, ivec2(high.x, low.y), 0).rg;
    vec2 c = texelFetch(aboveWaterHeights, ivec2(low.x, high.y), 0).rg, d = texelFetch(aboveWaterHeights, high, 0).rg;
    vec4 tops = vec4(a.y, b.y, c.y, d.y), under = cellUndersides(vec4(a.x, b.x, c.x, d.x));
    isUnder = 0.0;
    if (under.x > 0.5 * aboveWaterEmpty) return -1.0;
    float overUnder = from.z - patchHeight(under, from.xy);
    float t = patchCrossing(tops, from, along, within); // 0 if the ray is under the top already
    if (t >= 0.0) {
        vec3 met = from + t * along;
        if (met.z >= patchHeight(under, met.xy)) return t;
    }
    if (overUnder >= 0.0) return -1.0;
    // From below: the same patch upside down.
    t = patchCrossing(-under, vec3(from.xy, -from.z), vec3(along.xy, -along.z), within);
    isUnder = 1.0;
    if (t < 0.0) return -1.0;
    vec3 met = from + t * along;
    return met.z <= patchHeight(tops, met.xy) ? t : -1.0;
}

AboveWaterHit findAboveWater(vec3 from, vec3 direction)
{
    const int firstMipLevel = 4; // mirrored things are farther away than the bed
    PyramidRay ray = pyramidRay(from, direction, aboveWaterRect, textureSize(aboveWaterHeights, 0));
    float end = (aboveWaterHighest - from.y) / max(direction.y, 1.0e-6);
    float t = 0.0;
    int mipLevel = firstMipLevel;
    for (int i = 0; i < maxPyramidSteps && t < end; ++i) {
        PyramidBlock block = pyramidBlock(ray, t, mipLevel, end);
        if (!block.isOnMap) break;
        if (mipLevel == 0) {
            float isUnder;
            vec3 inCell = vec3(block.here.xy - block.corner, block.here.z);
            float met = cellCrossing(ivec2(block.corner), inCell, ray.along, block.within, isUnder);
            if (met >= 0.0) return AboveWaterHit(from + (t + met) * direction, 1.0, isUnder);
            t += block.within + ray.past;
            mipLevel = 1;
            continue;
        }
        vec2 range = texelFetch(aboveWaterHeights, max(ivec2(block.corner), ivec2(0)), mipLevel).rg;
        if (block.here.z > range.y || block.here.z + block.within * ray.along.z < range.x) {
            t += block.within + ray.past;
            mipLevel = min(mipLevel + 1, ray.top);
        } else {
            --mipLevel;
        }
    }
    return AboveWaterHit(from + t * direction, 0.0, 0.0);
}
#else
float marchedAboveWater(vec2 xz)
{
    ivec2 last = textureSize(aboveWaterHeights, 0) - 1;
    return texelFetch(aboveWaterHeights, clamp(ivec2(floor(aboveWaterTexel(xz) + 0.5)), ivec2(0), last), 0).b;
}

AboveWaterHit findAboveWater(vec3 from, vec3 direction)
{
    const int mostSteps = 60; // Lipp
    vec3 stride = direction * (marchUnit / reflectionStepsPerUnit(direction.y));
    vec3 before = from, here = from;
    float groundBefore = marchedAboveWater(from.xz), ground = groundBefore;
    float isFound = 0.0;
    for (int i = 0; i < mostSteps && isFound < 0.5; ++i) {
        before = here;
        here += stride;
        if (any(greaterThan(abs(here.xz - aboveWaterRect.xy), aboveWaterRect.zw)) || here.y > aboveWaterHighest) break;
        groundBefore = ground;
        ground = marchedAboveWater(here.xz);
        isFound = step(here.y, ground);
    }
    float fraction = crossingFraction(before.y, groundBefore, here.y, ground);
    return AboveWaterHit(mix(before, here, clamp(fraction, 0.0, 1.0)), isFound, 1.0);
}
#endif
