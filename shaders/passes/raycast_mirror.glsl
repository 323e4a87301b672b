// What is mirrored by rays marched through what stands over the water (Lipp), for water.frag.
#include "passes/afloat_march.glsl"

uniform sampler2D afloatAbove; // radiance of what stands over the water, seen from above
uniform sampler2D afloatBelow; // and from below

AfloatHit mirroredHit(vec3 reflected) // as published, a ray never goes down into the water
{
    return findAfloat(surfaceW, normalize(vec3(reflected.x, max(reflected.y, 1.0e-3), reflected.z)));
}

vec3 mirroredRadiance(AfloatHit hit)
{
    vec2 scale = 0.5 / afloatRect.zw;
    vec2 place = (hit.point.xz - afloatRect.xy) * scale + 0.5;
    // As wide as the pixel is there, were it seen straight on: facets call this where derivatives are undefined.
    float pixel = pixelAngle * (distance(eye, surfaceW) + distance(surfaceW, hit.point));
    float lod = log2(max(pixel * scale.x * float(textureSize(afloatAbove, 0).x), 1.0));
    return mix(textureLod(afloatAbove, place, lod).rgb, textureLod(afloatBelow, place, lod).rgb, hit.isUnder);
}
