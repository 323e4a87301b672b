// The bed by rays marched through its heights (Lipp), for water.frag: needs struct Transmitted and letThrough().
#if defined(SHADOWS) || defined(CAUSTICS)
#include "shared/sunlight.glsl"
#endif
#ifdef SHADOWS
#include "passes/sun_maps.glsl"
#endif
#include "passes/sun_underwater.glsl"
#include "passes/height_march.glsl"

uniform sampler2D bedRadiance; // of the bed seen from above, without the sun
uniform sampler2D bedResponse; // radiance for each unit of the sun's irradiance on a surface that faces it

// Lipp: the ray is marched through the bed's heights. What it meets is lit here, so that the map need not follow the waves.
Transmitted lookupBed(vec3 refracted, out bool isFound)
{
    vec3 direction = normalize(vec3(refracted.x, min(refracted.y, -1.0e-3), refracted.z)); // it only goes down
    GroundHit ground = findGround(surfaceW, direction);
    isFound = ground.isFound;
    Transmitted t;
    t.hitW = ground.point;
    t.path = distance(ground.point, surfaceW);
    vec2 place = (ground.point.xz - bedRect.xy) * (0.5 / bedRect.zw) + 0.5;
    vec3 across = dFdx(ground.point), along = dFdy(ground.point);
    vec2 acrossMap = across.xz * (0.5 / bedRect.zw), alongMap = along.xz * (0.5 / bedRect.zw);
    vec3 bed = textureGrad(bedRadiance, place, acrossMap, alongMap).rgb;
    bed += textureGrad(bedResponse, place, acrossMap, alongMap).rgb * sunUnderwater(ground.point, across, along, 0.0);
    if (!isFound) bed = deepRadiance;
    t.radiance = radianceThroughWater(bed, deepRadiance, letThrough(t.path));
    return t;
}
