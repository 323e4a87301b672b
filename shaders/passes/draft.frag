// The picture that stands in while the programs of the real one are built: diffuse surfaces in the sun and under the sky,
// without shadows; the water absorbs along straight lines, as if it did not refract.
// ALPHA_TEST: a cut-out. Short on purpose: what counts is how soon a driver has compiled it.
#include "shared/blocks.glsl"
#include "shared/refraction.glsl"
#include "shared/lighting.glsl"

in vec3 positionW;
in vec3 normalW;
in vec2 uv;
in vec3 tint;

uniform sampler2D diffuseMap;
uniform vec3 diffuseReflectance;
uniform vec3 emittedRadiance;
#ifdef ALPHA_TEST
uniform sampler2D alphaMap;
uniform float alpha;
uniform float alphaCutoff;
#endif

out vec4 fragment;

void main()
{
    vec4 texel = texture(diffuseMap, uv);
#ifdef ALPHA_TEST
    if (alpha * texel.a * texture(alphaMap, uv).r < alphaCutoff) discard;
#endif
    vec3 n = normalize(normalW);
    // Depths of the point and of the eye; the part of the line between them that is under the water level is water.
    float depth = hasWater * max(waterLevel - positionW.y, 0.0);
    float eyeDepth = hasWater * max(waterLevel - eye.y, 0.0);
    float waterFraction = min(max(depth, eyeDepth) / max(abs(positionW.y - eye.y), 1.0e-4), 1.0);
    vec3 toSun = depth > 0.0 ? sunDirectionBelow : sunDirection;
    vec3 sun = depth > 0.0 ? sunBelow : sunIrradiance;
    vec3 light = sun * max(dot(n, toSun), 0.0) + shIrradiance(skyIrradiance, n);
    light *= beerLambert(absorption, skyPathFactor * depth);
    // Samples at the edge of a triangle extrapolate its corners' colours, and may fall below zero.
    vec3 albedo = diffuseReflectance * max(tint, vec3(0.0)) * texel.rgb;
    vec3 radiance = emittedRadiance + albedo / lightPi * light;
    vec3 attenuation = beerLambert(absorption, waterFraction * distance(positionW, eye));
    radiance = radianceThroughWater(radiance, deepRadiance, attenuation);
    // Radiance that leaves the water spreads, and what enters it narrows.
    if (depth > 0.0 && eyeDepth <= 0.0) radiance /= ior * ior;
    if (depth <= 0.0 && eyeDepth > 0.0) radiance *= ior * ior;
    fragment = vec4(radiance, 1.0);
}
