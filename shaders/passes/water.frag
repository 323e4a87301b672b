// The water's surface: intersects the refracted and the reflected ray with the scene, absorbs, and mixes by Fresnel.
// Mihálik 2008, chapter 7. Radiance through the surface keeps the factor 1/n² (seen from above) or n² (from below).
#include "shared/blocks.glsl"
#include "shared/debug_views.glsl"
#include "shared/refraction.glsl"
#include "shared/trigonometry.glsl"
#include "shared/waves.glsl"
#include "shared/normal_map.glsl"
#include "shared/depth.glsl"
#include "shared/intersection.glsl"
#include "shared/reflection.glsl"
#include "shared/lighting.glsl"
#include "passes/water_surface.glsl"
#include "passes/water_fresnel.glsl"
#if defined(RAYCAST) || defined(RAYCAST_REFLECTION)
#include "shared/height_field.glsl"
#include "passes/height_pyramid.glsl"
#ifndef PYRAMID
uniform float marchUnit;
#endif
#endif

uniform samplerCube skyMap;
#ifdef LINEAR_ATTENUATION
uniform float attenuationLength; // m
#endif
#ifdef UNDERWATER
uniform float refractionDistance; // m of eq. 13
#endif
#ifdef PHONG
uniform float phongExponent;
uniform float phongStrength;
#endif

#ifdef WATERLINE
uniform sampler2D waterline; // which pixels are under water, and which are on the line: waterline.frag
#endif

out vec4 fragment;

struct Transmitted {
    vec3 radiance; // along the refracted ray, at the surface, on its far side
    vec3 hitW;     // W, world
    float path;    // |A - U|, m
};

// Tangents, across and up, of a camera's ray through texture coordinates; its frustum may be oblique.
vec2 tangentsAt(mat4 clipFromView, vec2 texel)
{
    vec2 scale = vec2(clipFromView[0][0], clipFromView[1][1]);
    return (2.0 * texel - 1.0 + clipFromView[2].xy) / scale;
}

// Texture coordinates at which a camera sees a point. Behind the camera there are none; the nearest are the target's border.
vec2 texelOf(vec4 clip) { return clip.xy / max(clip.w, 1.0e-6) * 0.5 + 0.5; }

#ifndef UNDERWATER
// Transmittance of a path from the bed to the surface.
vec3 attenuationOver(float path)
{
#ifdef LINEAR_ATTENUATION
    return vec3(linearAttenuation(path, attenuationLength));
#else
    return beerLambert(absorption, path);
#endif
}
#endif

#ifdef REFRACTION
#include "passes/target_bed.glsl"
#endif

#ifdef RAYCAST
#include "passes/raycast_bed.glsl"
#endif

#ifdef UNDERWATER
#include "passes/air_lookup.glsl"
#endif

#include "passes/mirrored.glsl"

#if !defined(UNDERWATER) && !defined(NO_REFLECTION)
vec3 reflectedFrom(vec3 normal, vec3 toEye)
{
    vec3 reflected = reflectRay(-toEye, normal);
    reflected.y = abs(reflected.y); // what a steep wave mirrors of the water is mirrored there once more
    return reflected;
}

#ifdef FACETS
struct FacetSum {
    vec3 radiance; // mirrored
    float reflected;
    float weight;
};

// Adds a facet that mirrors this radiance. frequency: fraction of the surface with its slope.
void addFacet(inout FacetSum sum, vec3 n, float frequency, vec3 toEye, vec3 radiance)
{
    float facing = max(dot(toEye, n), 0.0); // nothing of a facet is seen from behind
    float weight = frequency * facing / n.y;
    float fraction = weight * fresnelFractions(facing).y;
    sum.radiance += fraction * radiance;
    sum.reflected += fraction;
    sum.weight += weight;
}

void addFacet(inout FacetSum sum, vec2 slope, float frequency, vec3 toEye)
{
    vec3 n = waveNormal(slope);
    addFacet(sum, n, frequency, toEye, reflectedRadiance(reflectedFrom(n, toEye)));
}
#endif

// Mean over a pixel of the mirrored radiance, and of the fractions of light that pass the surface and are mirrored.
//
// FACETS: waves that a pixel cannot show still tilt its surface. Their slopes along the line of sight, which is where
// they matter (a grazing view sees the facets that lean towards it, so that far water mirrors more of the sky and less
// of the shore), are normal; a Gauss-Hermite rule of 3 or 5 of them stands for all. Each counts with the area that the
// eye sees of it, as in the masked slopes of Ross et al. 2005.
vec3 mirroredTowards(vec3 toEye, Surface surface, out vec2 fractions)
{
    fractions = fresnelFractions(max(dot(toEye, surface.meanNormal), 0.0)); // E·N; a crest's far side is seen edge-on
    vec3 middle = reflectedRadiance(reflectedFrom(surface.meanNormal, toEye));
#ifdef FACETS
#if FACETS == 3
    const vec2 rule[3] = vec2[3](vec2(0.0, 0.6666667), vec2(1.7320508, 0.1666667), vec2(-1.7320508, 0.1666667));
#else
    const vec2 rule[5] = vec2[5](vec2(0.0, 0.5333333), vec2(1.3556262, 0.2220759), vec2(-1.3556262, 0.2220759),
                                 vec2(2.8569700, 0.0112574), vec2(-2.8569700, 0.0112574));
#endif
    float deviation = sqrt(max(surface.slopeVariance - sunSlopeDeviation * sunSlopeDeviation, 0.0));
    if (deviation > 0.003) { // below this all facets mirror the same texel
        vec2 slope = -surface.meanNormal.xz / surface.meanNormal.y;
        vec2 across = normalize(toEye.xz + vec2(1.0e-6, 0.0));
        FacetSum sum = FacetSum(vec3(0.0), 0.0, 0.0);
        addFacet(sum, surface.meanNormal, rule[0].y, toEye, middle);
#define FACET(i) addFacet(sum, slope + rule[i + 1].x * deviation * across, rule[i + 1].y, toEye);
        EACH_FACET
#undef FACET
        if (sum.weight > 0.0) {
            float mean = sum.reflected / sum.weight;
            fractions = vec2(1.0 - mean, mean);
            return sum.radiance / sum.weight;
        }
    }
#endif
    return fractions.y * middle;
}
#endif

#ifdef UNDERWATER
void main()
{
    // No mean normal here: at the rim of Snell's window a mean over facets is what none of them shows.
    Surface surface = surfaceHere();
    vec3 toEye = normalize(eye - surfaceW);
    vec3 down = -surface.normal;
    float cosine = max(dot(toEye, down), 0.0);
#ifdef PAPER
    float fresnel = fresnelSchlick(cosine, ior, schlickExponent); // n1 and n2 may change places in eq. 8
    vec3 refracted = refractRayOfPaper(toEye, surface.normal, ior);
#else
    float fresnel = fresnelExact(cosine, ior);
    vec3 refracted = refractRay(-toEye, down, ior); // zero beyond the critical angle, where fresnel is 1
#endif
#ifdef NO_REFLECTION
    fresnel = step(1.0, fresnel); // beyond the critical angle nothing is refracted: the water's own colour is left
#endif
    vec3 hit = surfaceW;
    float fraction = 0.0;
    vec3 above = vec3(0.0);
    if (fresnel < 1.0) above = ior * ior * lookupAir(refracted, hit, fraction); // radiance grows by n² into the denser medium
    vec3 reflected = reflectRay(-toEye, down);
    vec3 below = reflectedRadiance(reflected);
    float path = distance(surfaceW, eye);
    vec3 a = beerLambert(absorption, path);
    // The reflected light's own leg eye–surface is in its target already (section 7.5).
    vec3 radiance = fresnel * below + (1.0 - fresnel) * radianceThroughWater(above, deepRadiance, a);
#else
void main()
{
    Surface surface = surfaceHere();
    vec3 toEye = normalize(eye - surfaceW);
#ifdef NO_REFLECTION
    const vec2 fractions = vec2(1.0, 0.0);
    const vec3 mirrored = vec3(0.0);
#else
    vec2 fractions;
    vec3 mirrored = mirroredTowards(toEye, surface, fractions);
#endif
    float fresnel = fractions.y;

#if defined(REFRACTION) || defined(RAYCAST)
    // Mirrored radiance is a mean over the pixel's facets. Refraction takes the facet in the middle of the pixel: that is one of
    // those in the mean, while a ray refracted by the mean normal belongs to none of them.
    vec3 refracted = refractRay(-toEye, surface.normal, 1.0 / ior);
#ifdef RAYCAST
    BedHit bed = lookupBed(refracted);
    Transmitted transmitted = bed.transmitted;
#else
    Transmitted transmitted = transmittedFrom(searchTarget(refracted, -1.0));
#endif
    vec3 below = transmitted.radiance;
    vec3 hit = transmitted.hitW;
    float path = transmitted.path;
#else
    vec3 below = deepRadiance;
    vec3 hit = surfaceW;
    float path = 0.0;
#endif
    vec3 radiance = mirrored + radianceThroughSurface(fractions.x, ior) * below;
#ifdef NO_REFLECTION
    // nor the sun
#elif defined(PHONG)
    // Lipp takes Fresnel's cosine from the plain normal too; here it is that of the surface that mirrors.
    radiance += phongGlint(sunIrradiance, fractions.y, surface.plainNormal, toEye, sunDirection, phongExponent, phongStrength);
#else
    // The sun itself is not in the reflection target: its image is spread over the waves that are too small to draw.
    float glintFresnel = fresnelFractions(max(dot(toEye, normalize(toEye + sunDirection)), 0.0)).y;
    radiance += sunGlint(sunIrradiance, glintFresnel, surface.meanNormal, toEye, sunDirection, surface.slopeVariance);
#endif
#endif

#ifdef WATERLINE
    // The surface is drawn once for either side. Not before the end: what follows a discard has no derivatives.
    vec2 side = texelFetch(waterline, ivec2(gl_FragCoord.xy), 0).rg;
    bool isFromBelow = side.g > 0.5 ? !gl_FrontFacing : side.r > 0.5;
#ifdef UNDERWATER
    if (!isFromBelow) discard;
#else
    if (isFromBelow) discard;
#endif
#endif

#if DEBUG_VIEW == DEBUG_VIEW_FRESNEL
    fragment = vec4(vec3(fresnel), 1.0);
#elif DEBUG_VIEW == DEBUG_VIEW_PATH_LENGTH
    fragment = vec4(vec3(path), 1.0);
#elif DEBUG_VIEW == DEBUG_VIEW_POSITION_W
    fragment = vec4(hit, 1.0);
#elif DEBUG_VIEW == DEBUG_VIEW_NORMALS
#ifdef UNDERWATER
    fragment = vec4(surface.normal, 1.0);
#else
    fragment = vec4(surface.meanNormal, 1.0);
#endif
#elif DEBUG_VIEW == DEBUG_VIEW_POSITION_U
    fragment = vec4(surfaceW, 1.0);
#elif DEBUG_VIEW == DEBUG_VIEW_POSITION_A
    fragment = vec4(hit, 0.5);
#ifdef RAYCAST
    fragment = vec4(hit.x, bedHeight(hit.xz), hit.z, bed.isFound ? 1.0 : 0.5); // the picture is taken straight from above
#ifdef BED_TARGET
    if (bed.isOnTarget) fragment = sampledPosition(hit);
#endif
#elif defined(REFRACTION)
    fragment = sampledPosition(hit);
#endif
#ifdef UNDERWATER
    if (fraction < 0.5) fragment.a = 0.5; // the sky was taken
#endif
#elif DEBUG_VIEW == DEBUG_VIEW_REFLECTION_HIT
#ifdef NO_REFLECTION
    fragment = vec4(0.0); // nothing
#elif defined(UNDERWATER)
    fragment = mirroredPosition(reflected);
#else
    fragment = mirroredPosition(reflectedFrom(surface.meanNormal, toEye));
#endif
#elif DEBUG_VIEW == DEBUG_VIEW_FINAL
    fragment = vec4(radiance, 1.0);
#else
#error water.frag does not write this debug view
#endif
}
