// The bed by rays marched through its heights (Lipp), for water.frag. Needs struct Transmitted and attenuationOver(), and
// target_bed.glsl if there is a refraction target too.
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

// Radiance of the ground at a point of the map. The ground is lit here, so that the map need not follow the waves.
// across, along: how the point changes from pixel to pixel.
vec3 groundRadiance(GroundHit ground, vec3 across, vec3 along)
{
    if (!ground.isFound) return deepRadiance;
    vec2 uv = (ground.point.xz - bedRect.xy) * (0.5 / bedRect.zw) + 0.5;
    vec2 acrossMap = across.xz * (0.5 / bedRect.zw), alongMap = along.xz * (0.5 / bedRect.zw);
    vec3 bed = textureGrad(bedRadiance, uv, acrossMap, alongMap).rgb;
    return bed + textureGrad(bedResponse, uv, acrossMap, alongMap).rgb * sunUnderwater(ground.point, across, along, 0.0);
}

struct BedHit {
    Transmitted transmitted;
    bool isFound;
    bool isOnTarget; // the target's picture is taken, not the map's
};

#ifdef BED_TARGET
// Which of the two to use. The target shows the bed at the picture's resolution, but only what the eye sees; the map also
// knows what the ray meets before that. So the search in the target begins at the map's hit, and its result is used if it
// lies on the ray more closely than the map's resolution, unless the map's hit comes first. Where heights jump the map is no
// judge: it has a curtain there, while the real object may be open below.
bool isTargetRight(GroundHit ground, TargetHit target)
{
    if (!ground.isFound) return true;
    vec2 texels = 2.0 * bedRect.zw / vec2(textureSize(bedHeights, 0));
    float texel = max(texels.x, texels.y);
    vec4 corners = bedCorners(ivec2(floor(bedTexel(ground.point.xz))));
    float jump = max(max(corners.x, corners.y), max(corners.z, corners.w)) -
                 min(min(corners.x, corners.y), min(corners.z, corners.w));
    if (jump > 3.0 * texel) {
        float perMetre = 2.0 / (refractionClipFromView[1][1] * float(textureSize(refractionDepth, 0).y)); // of the target's texels
        float near = 2.0 * perMetre * distance(eye, target.hitW);
        return target.gap < max(near, 0.1 * distance(target.hitW, ground.point));
    }
    float beyond = distance(target.hitW, surfaceW) - distance(ground.point, surfaceW);
    return target.gap < 0.2 * texel && beyond < 3.0 * texel;
}
#endif

BedHit lookupBed(vec3 refracted)
{
    vec3 direction = normalize(vec3(refracted.x, min(refracted.y, -1.0e-3), refracted.z)); // it only goes down
    GroundHit ground = findGround(surfaceW, direction);
    vec3 across = dFdx(ground.point), along = dFdy(ground.point);
    float path = distance(ground.point, surfaceW);
    BedHit hit;
    hit.isFound = ground.isFound;
    hit.isOnTarget = false;
#ifdef BED_TARGET
    TargetHit target = searchTarget(direction, max(path, 1.0e-3));
    if (isTargetRight(ground, target)) {
        hit.transmitted = transmittedFrom(target);
        hit.isOnTarget = true;
        return hit;
    }
#endif
    vec3 bed = groundRadiance(ground, across, along);
    hit.transmitted = Transmitted(radianceThroughWater(bed, deepRadiance, attenuationOver(path)), ground.point, path);
    return hit;
}
