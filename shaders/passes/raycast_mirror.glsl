// Reflection by rays marched through the map of what stands over the water (Lipp), for water.frag.
#include "passes/above_water_march.glsl"

uniform sampler2D aboveWaterTops; // radiance of what stands over the water, seen from above
uniform sampler2D aboveWaterUndersides; // and from below

AboveWaterHit mirroredHit(vec3 reflected) // as published, a ray never goes down into the water
{
    return findAboveWater(surfaceW, normalize(vec3(reflected.x, max(reflected.y, 1.0e-3), reflected.z)));
}

vec3 mirroredRadiance(AboveWaterHit hit)
{
    vec2 scale = 0.5 / aboveWaterRect.zw;
    vec2 uv = (hit.point.xz - aboveWaterRect.xy) * scale + 0.5;
    // The mip level of the pixel's footprint there, as if seen head-on: facets call this where derivatives are undefined.
    float pixel = pixelAngle * (distance(eye, surfaceW) + distance(surfaceW, hit.point));
    float mipLevel = log2(max(pixel * scale.x * float(textureSize(aboveWaterTops, 0).x), 1.0));
    return mix(textureLod(aboveWaterTops, uv, mipLevel).rgb, textureLod(aboveWaterUndersides, uv, mipLevel).rgb, hit.isUnder);
}
