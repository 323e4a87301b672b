// Shades static geometry: radiance towards the eye, linear, on the scene's one scale.
//
// Above the water: sun and sky directly. Below it: the sun refracted by the flat surface and the sky through it, both
// absorbed on their way down. UNDERWATER: the eye is in the water too, so what lies between is water (eq. 10).
// If the surface cuts the near plane, that holds for the pixels under it.
// IN_AIR, IN_WATER: all that is drawn is on that side of the water level, and only that side's light is computed.
// FOR_MAP: for a map of the scene from above: all but the sun's light under water, which the map's readers add.
// DEBUG_VIEW: final, or the normals.
#include "shared/blocks.glsl"
#include "shared/debug_views.glsl"
#ifndef DEBUG_VIEW
#define DEBUG_VIEW DEBUG_VIEW_FINAL
#endif
#include "shared/refraction.glsl"
#include "shared/lighting.glsl"
#if defined(SHADOWS) || defined(CAUSTICS)
#include "shared/sunlight.glsl"
#endif
#ifdef SHADOWS
#include "passes/sun_maps.glsl"
#endif
#include "passes/sun_underwater.glsl"

in vec3 positionW;
in vec3 normalW;
in vec2 uv;
in vec3 tint;
#ifdef NORMAL_MAP
in vec4 tangentW;
uniform sampler2D normalMap;
#endif
#ifdef DIFFUSE_MAP
uniform sampler2D diffuseMap;
#endif
#ifdef ALPHA_MAP
uniform sampler2D alphaMap;
#endif
#ifdef EMISSIVE_MAP
uniform sampler2D emissiveMap;
#endif

uniform vec3 diffuseReflectance;
uniform vec3 emittedRadiance;
#ifdef SPECULAR
uniform vec3 specularReflectance;
uniform float shininess;
#endif
#ifdef TRANSMISSION
uniform vec3 transmission; // of a thin leaf, as a fraction of its reflectance
#endif
#ifdef SHADOWS
uniform float geometryError; // m by which the drawn mesh may differ from that of the shadow maps
#else
const float geometryError = 0.0;
#endif
#ifdef ALPHA_TEST
uniform float alpha;
uniform float alphaCutoff;
#include "passes/cut_out.glsl"
#endif

#ifdef UNDERWATER
uniform sampler2D waterline; // 1 for pixels under water, waterline.frag; a single texel: for all of them
#endif

layout(location = 0) out vec4 fragment;
#ifdef FLAT_WATER
// The point that is drawn. Within a triangle it is not quite at its apparent position, since only vertices are moved there;
// water.frag must know which point it got. Alpha is the coverage.
layout(location = 1) out vec4 drawnPosition;
#endif
#ifdef FOR_MAP
// Radiance for each unit of the sun's irradiance facing it; 1 for a front, 1/2 for the back of something solid.
layout(location = 1) out vec4 response;
#endif

vec3 shadingNormal()
{
    vec3 n = normalize(normalW);
#ifdef NORMAL_MAP
    vec3 t = tangentW.xyz - n * dot(n, tangentW.xyz);
    float length2 = dot(t, t);
    if (length2 > 1.0e-12) { // degenerate texture coordinates have no tangent
        t *= inversesqrt(length2);
        vec3 b = tangentW.w * cross(n, t);
        vec3 m = texture(normalMap, uv).xyz * 2.0 - 1.0;
        n = normalize(m.x * t + m.y * b + m.z * n);
    }
#endif
#ifdef TURN_NORMAL
    if (!gl_FrontFacing) n = -n;
#endif
    return n;
}

// Irradiance and glossy reflection of one source: `irradiance` is that on a surface facing `light`.
vec3 lit(vec3 n, vec3 toEye, vec3 light, vec3 irradiance, vec3 albedo)
{
    float cosine = max(dot(n, light), 0.0);
    vec3 radiance = albedo / lightPi * cosine * irradiance;
#ifdef TRANSMISSION
    radiance += albedo * transmission / lightPi * max(-dot(n, light), 0.0) * irradiance;
#endif
#if defined(SPECULAR) && !defined(FOR_MAP) // a highlight depends on the eye
    radiance += specularReflectance * irradiance * cosine * blinnPhong(max(dot(n, normalize(light + toEye)), 0.0), shininess);
#endif
    return radiance;
}

vec3 punctualLight(LightTerm source, vec3 n, vec3 toEye, vec3 albedo)
{
    vec3 toLight = source.position - positionW;
    float distance2 = max(dot(toLight, toLight), 1.0e-6); // at the source itself the irradiance has no bound
    vec3 light = toLight * inversesqrt(distance2);
    float cone = source.cosOuter < -1.5 ? 1.0 : smoothstep(source.cosOuter, source.cosInner, dot(-light, source.direction));
    return lit(n, toEye, light, source.intensity * (cone / distance2), albedo);
}

// From one pixel to the next, m; derivatives, taken before anything branches.
vec3 acrossW, alongW;

// The sun's irradiance above the water on a surface that faces it.
vec3 sunAbove()
{
#ifdef SHADOWS
    vec2 shear = sunShear(sunDirection);
    vec2 gradient = sunPlaneGradient(cross(acrossW, alongW), shear);
    float height = positionW.y + geometryError * (1.0 + length(gradient));
    return sunIrradiance * sunVisibilityInAir(sunPlane(positionW, waterLevel, shear), height, gradient);
#else
    return sunIrradiance;
#endif
}

void main()
{
    acrossW = dFdx(positionW);
    alongW = dFdy(positionW);
    // Samples at the edge of a triangle extrapolate its corners' colours, and may fall below zero.
    vec3 albedo = diffuseReflectance * max(tint, vec3(0.0));
#ifdef DIFFUSE_MAP
    vec4 texel = texture(diffuseMap, uv);
    albedo *= texel.rgb;
#endif

    float coverage = 1.0;
#ifdef ALPHA_TEST
#ifdef ALPHA_TO_COVERAGE
    // A ramp one pixel wide about the cutoff, so that the samples draw the edge (no half-transparent leaves).
    coverage = alpha * alphaOfMaps(uv);
    coverage = clamp((coverage - alphaCutoff) / max(fwidth(coverage), 1.0e-4) + 0.5, 0.0, 1.0);
    if (coverage <= 0.0) discard;
#else
    if (isCutAway(uv)) discard;
#endif
#endif

    vec3 n = shadingNormal();
    vec3 toEye = normalize(eye - positionW);
#if DEBUG_VIEW == DEBUG_VIEW_NORMALS
    fragment = vec4(n, 1.0);
    return;
#elif DEBUG_VIEW != DEBUG_VIEW_FINAL
#error scene.frag does not write this debug view
#endif

    float depth = waterLevel - positionW.y;
#if defined(IN_AIR)
    const bool submerged = false;
#elif defined(IN_WATER)
    const bool submerged = true;
#else
    // A wall on the very edge of the water counts as wet: without a centimetre's margin rounding would speckle it.
    bool submerged = hasWater > 0.5 && depth > 0.0 &&
                     all(lessThanEqual(abs(positionW.xz - waterRect.xy), waterRect.zw + 0.01));
#endif
#ifdef FOR_MAP
#if defined(ALPHA_TEST) || defined(TURN_NORMAL)
    response = vec4(0.0, 0.0, 0.0, 1.0); // a sheet has nothing behind it
#else
    response = vec4(0.0, 0.0, 0.0, gl_FrontFacing ? 1.0 : 0.5);
#endif
#endif
    vec3 radiance = emittedRadiance;
#ifdef EMISSIVE_MAP
    radiance *= texture(emissiveMap, uv).rgb;
#endif
    if (submerged) {
#ifdef FOR_MAP
        response.rgb = lit(n, toEye, sunDirectionBelow, vec3(1.0), albedo);
#else
        radiance += lit(n, toEye, sunDirectionBelow, sunUnderwater(positionW, acrossW, alongW, geometryError), albedo);
#endif
        radiance += albedo / lightPi * skyIrradianceAtDepth(skyBelow, absorption, depth, n);
    } else {
        radiance += lit(n, toEye, sunDirection, sunAbove(), albedo);
        radiance += albedo / lightPi * shIrradiance(skyIrradiance, n);
#ifdef TRANSMISSION
        radiance += albedo * transmission / lightPi * shIrradiance(skyIrradiance, -n);
#endif
    }
#define LIGHT(i) radiance += punctualLight(lights[i], n, toEye, albedo);
    EACH_LIGHT
#undef LIGHT

#ifdef UNDERWATER
    // Light from above the water level passes through water up to the level (a shore behind the foot of a wave). The mirrored
    // eye of the reflection is above the level itself; all that it sees, it sees through water.
    float fraction = depth > 0.0 ? 1.0 : min(abs(waterLevel - eye.y) / max(abs(positionW.y - eye.y), 1.0e-6), 1.0);
    vec3 a = beerLambert(absorption, fraction * distance(positionW, eye));
    ivec2 pixel = min(ivec2(gl_FragCoord.xy), textureSize(waterline, 0) - 1);
    a = mix(vec3(1.0), a, texelFetch(waterline, pixel, 0).r);
    radiance = radianceThroughWater(radiance, deepRadiance, a);
#endif
    fragment = vec4(radiance, coverage);
#ifdef FLAT_WATER
    drawnPosition = vec4(positionW, 1.0);
#endif
}
