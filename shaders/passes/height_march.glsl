// Intersects a ray with the bed's map of heights. Needs shared/height_field.glsl, height_pyramid.glsl and the uniform
// marchUnit, m, that Lipp's steps are counted in.
// PYRAMID: through the pyramid of largest heights; else in Lipp's steps, MARCH_REFINE times halved at the end.

uniform sampler2D bedHeights; // m, of the texels' centres; mip level n: the largest of 2^n + 1 by 2^n + 1 of them
uniform vec4 bedRect;         // what it covers: centre x, z and half extent x, z, m
uniform float bedLowest;      // height of empty texels, below all others, m

struct GroundHit {
    vec3 point; // world
    bool isFound;
};

vec2 bedTexel(vec2 xz) { return mapTexel(xz, bedRect, textureSize(bedHeights, 0)); }

vec4 bedCorners(ivec2 cell)
{
    ivec2 last = textureSize(bedHeights, 0) - 1;
    ivec2 low = clamp(cell, ivec2(0), last), high = clamp(cell + 1, ivec2(0), last);
    return vec4(texelFetch(bedHeights, low, 0).r, texelFetch(bedHeights, ivec2(high.x, low.y), 0).r,
                texelFetch(bedHeights, ivec2(low.x, high.y), 0).r, texelFetch(bedHeights, high, 0).r);
}

// Between the heights of four texels.
float bedHeight(vec2 xz)
{
    vec2 texel = bedTexel(xz);
    vec2 cell = floor(texel);
    return patchHeight(bedCorners(ivec2(cell)), texel - cell);
}

bool isOnMap(vec2 xz) { return all(lessThanEqual(abs(xz - bedRect.xy), bedRect.zw)); }

#ifdef PYRAMID
GroundHit findGround(vec3 from, vec3 direction)
{
    const int firstMipLevel = 3; // most rays end within some texels of their start
    PyramidRay ray = pyramidRay(from, direction, bedRect, textureSize(bedHeights, 0));
    float end = (from.y - bedLowest) / max(-direction.y, 1.0e-6);
    float t = 0.0;
    int mipLevel = firstMipLevel;
    for (int i = 0; i < maxPyramidSteps && t < end; ++i) {
        PyramidBlock block = pyramidBlock(ray, t, mipLevel, end);
        if (!block.isOnMap) break;
        if (mipLevel == 0) {
            vec3 inCell = vec3(block.here.xy - block.corner, block.here.z);
            float met = patchCrossing(bedCorners(ivec2(block.corner)), inCell, ray.along, block.within);
            if (met >= 0.0) return GroundHit(from + (t + met) * direction, true);
            t += block.within + ray.past;
            mipLevel = 1;
            continue;
        }
        float highest = texelFetch(bedHeights, max(ivec2(block.corner), ivec2(0)), mipLevel).r;
        if (block.here.z + block.within * ray.along.z > highest) {
            t += block.within + ray.past;
            mipLevel = min(mipLevel + 1, ray.top);
        } else {
            if (block.here.z > highest) t += (block.here.z - highest) / -ray.along.z * 0.999;
            --mipLevel;
        }
    }
    return GroundHit(from + min(t, end) * direction, false);
}
#else
float marchedHeight(vec2 xz)
{
#ifdef MARCH_LINEAR
    return bedHeight(xz);
#else
    ivec2 last = textureSize(bedHeights, 0) - 1;
    return texelFetch(bedHeights, clamp(ivec2(floor(bedTexel(xz) + 0.5)), ivec2(0), last), 0).r; // as published
#endif
}

GroundHit findGround(vec3 from, vec3 direction)
{
    const int mostSteps = 40; // Lipp
    vec3 stride = direction * (marchUnit / refractionStepsPerUnit(direction.y));
    vec3 before = from, here = from;
    float groundBefore = marchedHeight(from.xz), ground = groundBefore;
    bool isFound = false;
    for (int i = 0; i < mostSteps && !isFound; ++i) {
        before = here;
        groundBefore = ground;
        here += stride;
        ground = marchedHeight(here.xz);
        isFound = ground > here.y;
    }
    for (int i = 0; i < MARCH_REFINE && isFound; ++i) {
        vec3 middle = 0.5 * (before + here);
        float groundThere = marchedHeight(middle.xz);
        if (groundThere > middle.y) {
            here = middle;
            ground = groundThere;
        } else {
            before = middle;
            groundBefore = groundThere;
        }
    }
    isFound = isFound && isOnMap(here.xz) && ground > bedLowest;
    float fraction = crossingFraction(before.y, groundBefore, here.y, ground);
    return GroundHit(mix(before, here, clamp(fraction, 0.0, 1.0)), isFound);
}
#endif
