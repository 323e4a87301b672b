// The water's surface: finds what the refracted and the reflected ray meet, absorbs, and mixes by Fresnel.
// Mihálik 2008, chapter 7. Radiance through the surface keeps the factor 1/n² (seen from above) or n² (from below).
#include "shared/blocks.glsl"
#include "shared/refraction.glsl"
#include "shared/waves.glsl"
#include "shared/depth.glsl"
#include "shared/intersection.glsl"
#include "shared/lighting.glsl"
#include "passes/water_surface.glsl"

uniform samplerCube skyMap;
#ifdef REFRACTION
uniform sampler2D refractionColour;
uniform sampler2D refractionDepth;
uniform mat4 refractionViewFromWorld;
uniform mat4 refractionClipFromView;
uniform vec2 refractionNearFar;
uniform mat4 worldFromRefractionView;
#ifdef UNDERWATER
uniform float refractionDistance; // m of eq. 13
#else
uniform int refractionSteps;
#endif
#endif
#ifdef REFLECTION
uniform sampler2D reflectionColour;
uniform mat4 reflectionClipFromWorld;
uniform float reflectionDistance; // c of eq. 6
#endif
uniform float schlickExponent; // q of eq. 7

out vec4 fragment;

struct Transmitted {
    vec3 radiance; // along the refracted ray, at the surface, on its far side
    vec3 hitW;     // W, world
    float path;    // |A - U|, m
};

// The texel that a camera sees a point at. Behind the camera there is none; the nearest is the target's border.
vec2 texelOf(vec4 clip) { return clip.xy / max(clip.w, 1.0e-6) * 0.5 + 0.5; }

#if defined(REFRACTION) && !defined(UNDERWATER)
vec2 refractionTexel(vec3 positionR) { return texelOf(refractionClipFromView * vec4(positionR, 1.0)); }

float refractionZ(vec3 positionR)
{
    float depth = texture(refractionDepth, refractionTexel(positionR)).r;
    return viewZFromDepth(depth, refractionNearFar.x, refractionNearFar.y);
}

// Section 7.1 in the refraction camera's view space, whose eye is the origin.
Transmitted lookupBed(vec3 refracted)
{
    vec3 u = (refractionViewFromWorld * vec4(surfaceW, 1.0)).xyz;
    u.z = min(u.z, -1.0e-3); // the turned camera stands back from the water; this only guards the division
    vec3 r = normalize(mat3(refractionViewFromWorld) * refracted);
    vec3 firstSeen = seenThrough(u, refractionZ(u));
#ifdef ITERATIVE
    IntersectionState s = intersectionBegin(u, r, firstSeen);
    for (int i = 1; i < refractionSteps; ++i) s = intersectionStep(s, refractionZ(s.W));
    vec3 hit = s.best;
    vec3 seen = s.bestA;
#else
    vec3 hit = planarIntersection(u, r, firstSeen);
    vec3 seen = firstSeen;
#endif
    Transmitted t;
    t.hitW = (worldFromRefractionView * vec4(hit, 1.0)).xyz;
    t.path = distance(seen, u);
    vec3 bed = texture(refractionColour, refractionTexel(hit)).rgb;
    t.radiance = radianceThroughWater(bed, deepRadiance, beerLambert(absorption, t.path)); // eq. 5
    return t;
}
#endif

vec3 reflectedRadiance(vec3 reflected)
{
#ifdef REFLECTION
    vec4 clip = reflectionClipFromWorld * vec4(surfaceW + reflectionDistance * reflected, 1.0);
    return texture(reflectionColour, texelOf(clip)).rgb;
#elif defined(UNDERWATER)
    return deepRadiance;
#else
    return texture(skyMap, reflected).rgb;
#endif
}

#ifdef UNDERWATER
void main()
{
    Surface surface = surfaceHere();
    vec3 toEye = normalize(eye - surfaceW);
    vec3 down = -surface.normal;
    float cosine = max(dot(toEye, down), 0.0);
    float fresnel = fresnelExact(cosine, ior);

    vec3 refracted = refractRay(-toEye, down, ior); // zero beyond the critical angle, where fresnel is 1
    vec3 hit = surfaceW;
    vec3 above = vec3(0.0);
    if (fresnel < 1.0) {
        above = texture(skyMap, refracted).rgb;
#ifdef REFRACTION
        hit = surfaceW + refractionDistance * refracted; // eq. 13
        vec4 clip = refractionClipFromView * (refractionViewFromWorld * vec4(hit, 1.0));
        vec2 texel = texelOf(clip);
        // The target holds what the eye's own frustum holds; past its border only the sky is known.
        vec2 inside = smoothstep(vec2(0.0), vec2(0.04), texel) * smoothstep(vec2(0.0), vec2(0.04), 1.0 - texel);
        above = mix(above, texture(refractionColour, texel).rgb, inside.x * inside.y * step(0.0, clip.w));
#endif
        above *= ior * ior; // radiance grows by n² into the denser medium
    }
    vec3 below = reflectedRadiance(reflectRay(-toEye, down));
    float path = distance(surfaceW, eye);
    vec3 a = beerLambert(absorption, path);
    // The reflected light's own leg eye–surface is in its target already (section 7.5).
    vec3 radiance = fresnel * below + (1.0 - fresnel) * radianceThroughWater(above, deepRadiance, a);
#else
void main()
{
    Surface surface = surfaceHere();
    vec3 toEye = normalize(eye - surfaceW);
    float cosine = max(dot(toEye, surface.normal), 0.0); // E·N; a crest's far side is seen edge-on
    float fresnel = fresnelSchlick(cosine, ior, schlickExponent);
    vec3 reflected = reflectRay(-toEye, surface.normal);
    reflected.y = max(reflected.y, 0.0); // a steep wave would mirror the water itself; the horizon is nearest

#ifdef REFRACTION
    Transmitted transmitted = lookupBed(refractRay(-toEye, surface.normal, 1.0 / ior));
    vec3 below = transmitted.radiance;
    vec3 hit = transmitted.hitW;
    float path = transmitted.path;
#else
    vec3 below = deepRadiance;
    vec3 hit = surfaceW;
    float path = 0.0;
#endif
    vec3 radiance = fresnel * reflectedRadiance(reflected) + radianceThroughSurface(1.0 - fresnel, ior) * below;
    // The sun itself is not in the reflection target: its image is spread over the waves that are too small to draw.
    float glintFresnel = fresnelSchlick(max(dot(toEye, normalize(toEye + sunDirection)), 0.0), ior, schlickExponent);
    radiance += sunGlint(sunIrradiance, glintFresnel, surface.normal, toEye, sunDirection, surface.roughness);
#endif

#if DEBUG_VIEW == 1
    fragment = vec4(vec3(fresnel), 1.0);
#elif DEBUG_VIEW == 2
    fragment = vec4(vec3(path), 1.0);
#elif DEBUG_VIEW == 3
    fragment = vec4(hit, 1.0);
#elif DEBUG_VIEW == 4
    fragment = vec4(surface.normal, 1.0);
#else
    fragment = vec4(radiance, 1.0);
#endif
}
