// The draft's water: mirrors the sky by Fresnel's formula and transmits what draft.frag has drawn behind it. The normal is
// that of the first few waves. UNDERWATER: from below it mirrors the water itself, and transmits the sky alone.
#include "shared/blocks.glsl"
#include "shared/refraction.glsl"
#include "shared/trigonometry.glsl"
// The first four waves; missing ones have an amplitude of 0.
#define EACH_WAVE WAVE(0) WAVE(1) WAVE(2) WAVE(3)
#include "shared/waves.glsl"

in vec3 positionW;

uniform samplerCube skyMap;

out vec4 fragment; // blended: its own radiance, and the fraction of the background's that it replaces

void main()
{
    vec3 toEye = eye - positionW;
    float range = length(toEye);
    toEye /= range;
    vec2 slope = waveSum(positionW.xz, time).slope;
    // Far away a pixel spans many waves and shows their mean.
    slope *= min(1.0, 8.0 / range);
#ifdef UNDERWATER
    vec3 n = -waveNormal(slope);
    float mirrored = fresnelExact(max(dot(n, toEye), 0.0), ior);
    vec3 sky = texture(skyMap, refractRay(-toEye, n, ior)).rgb * (ior * ior); // it narrows as it enters
    vec3 radiance = mix(sky, deepRadiance, mirrored);
    fragment = vec4(radianceThroughWater(radiance, deepRadiance, beerLambert(absorption, range)), 1.0);
#else
    vec3 n = waveNormal(slope);
    float mirrored = fresnelExact(max(dot(n, toEye), 0.0), 1.0 / ior);
    vec3 direction = reflectRay(-toEye, n);
    direction.y = abs(direction.y); // down, it would meet the next wave, which mirrors it up
    fragment = vec4(mirrored * texture(skyMap, direction).rgb, mirrored);
#endif
}
