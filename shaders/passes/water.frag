// The water's surface: finds what the refracted and the reflected ray meet, absorbs, and mixes by Fresnel.
// Mihálik 2008, chapter 7. Radiance through the surface keeps the factor 1/n² (seen from above) or n² (from below).
#include "shared/blocks.glsl"
#include "shared/refraction.glsl"
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
#ifdef REFRACTION
uniform sampler2D refractionColour;
uniform sampler2D refractionDepth;
uniform mat4 refractionViewFromWorld;
uniform mat4 refractionClipFromView;
uniform vec2 refractionNearFar;
uniform mat4 worldFromRefractionView;
uniform int refractionSteps;
#endif
#ifdef LINEAR_ATTENUATION
uniform float attenuationLength; // m
#endif
#ifdef UNDERWATER
uniform float refractionDistance; // m of eq. 13
#endif
#ifdef REFLECTION
uniform sampler2D reflectionColour;
#ifdef ITERATIVE_REFLECTION
uniform mat4 reflectionViewFromWorld;
uniform int reflectionSteps;
#else
uniform mat4 reflectionClipFromWorld;
uniform float reflectionDistance; // c of eq. 6
#endif
#if DEBUG_VIEW == 7 || defined(ITERATIVE_REFLECTION)
uniform sampler2D reflectionDepth;
uniform mat4 reflectionClipFromView;
uniform vec2 reflectionNearFar;
#endif
#if DEBUG_VIEW == 7
uniform mat4 worldFromReflectionView;
#endif
#endif
#ifdef PHONG
uniform float phongExponent;
uniform float phongStrength;
#endif

#ifdef WATERLINE
uniform sampler2D waterline; // which pixels are under water, and which on the line: waterline.frag
#endif

out vec4 fragment;

struct Transmitted {
    vec3 radiance; // along the refracted ray, at the surface, on its far side
    vec3 hitW;     // W, world
    float path;    // |A - U|, m
};

// The tangents, across and up, that a camera sees at a texel; its frustum may be oblique.
vec2 tangentsAt(mat4 clipFromView, vec2 texel)
{
    vec2 scale = vec2(clipFromView[0][0], clipFromView[1][1]);
    return (2.0 * texel - 1.0 + clipFromView[2].xy) / scale;
}

// The texel that a camera sees a point at. Behind the camera there is none; the nearest is the target's border.
vec2 texelOf(vec4 clip) { return clip.xy / max(clip.w, 1.0e-6) * 0.5 + 0.5; }

#ifndef UNDERWATER
// What the water lets through of the bed's light on its way to the surface.
vec3 letThrough(float path)
{
#ifdef LINEAR_ATTENUATION
    return vec3(linearAttenuation(path, attenuationLength));
#else
    return beerLambert(absorption, path);
#endif
}
#endif

#ifdef REFRACTION
vec2 refractionTexel(vec3 positionR) { return texelOf(refractionClipFromView * vec4(positionR, 1.0)); }

float refractionZ(vec3 positionR)
{
    float depth = texture(refractionDepth, refractionTexel(positionR)).r;
    return viewZFromDepth(depth, refractionNearFar.x, refractionNearFar.y);
}

#ifdef FLAT_CAMERA
uniform sampler2D refractionShown; // the point that a texel shows, world, weighted with how much of the texel shows any

// The target shows what a flat surface would: a point is looked up where it would seem to be.
vec2 flatTexel(vec3 pointW)
{
    vec3 seen = flatApparent(eye, pointW, waterLevel, ior);
    return refractionTexel((refractionViewFromWorld * vec4(seen, 1.0)).xyz);
}

// What the target shows at a place, and by how much that is beside what a flat surface would show there: only the
// corners of triangles are moved to where they would seem to be, so that the picture within them is a little off.
struct FlatLook {
    vec3 point;  // world; where the target shows nothing, one behind all that there is
    vec3 beside; // m
};

FlatLook lookFlat(vec2 texel)
{
    float z = viewZFromDepth(texture(refractionDepth, texel).r, refractionNearFar.x, refractionNearFar.y);
    vec2 tangent = tangentsAt(refractionClipFromView, texel);
    vec3 seen = (worldFromRefractionView * vec4(vec3(-tangent, 1.0) * z, 1.0)).xyz;
    FlatLook look = FlatLook(flatTrue(eye, seen, waterLevel, ior), vec3(0.0));
    vec4 shown = texture(refractionShown, texel);
    if (shown.w > 1.0e-3) {
        vec3 point = shown.xyz / shown.w;
        vec3 beside = point - look.point;
        // More than any triangle bends is the mean of two things at the edge of one.
        const float farthest = 0.5;
        if (dot(beside, beside) < farthest * farthest) look.beside = beside;
        look.point = point;
    }
    return look;
}
#endif

#if DEBUG_VIEW == 6
// The point whose picture is taken for W's, world: what the target shows at W's pixel. Alpha: 1, or 1/2 where that is no
// valid sample: W is behind the camera or beside its target, or the target is empty there.
vec4 shownFor(vec3 hitW)
{
#ifdef FLAT_CAMERA
    vec2 place = flatTexel(hitW - lookFlat(flatTexel(hitW)).beside);
    bool holds = all(greaterThanEqual(place, vec2(0.0))) && all(lessThanEqual(place, vec2(1.0))) &&
                 texture(refractionShown, place).w > 1.0e-3;
    return vec4(lookFlat(place).point, holds ? 1.0 : 0.5);
#endif
    vec3 w = (refractionViewFromWorld * vec4(hitW, 1.0)).xyz;
    vec2 texel = refractionTexel(w);
    bool inside = all(greaterThanEqual(texel, vec2(0.0))) && all(lessThanEqual(texel, vec2(1.0)));
    bool valid = w.z < 0.0 && inside && texture(refractionDepth, texel).r < 1.0;
    vec3 seen = seenThrough(vec3(w.xy, min(w.z, -1.0e-3)), refractionZ(w));
    return vec4((worldFromRefractionView * vec4(seen, 1.0)).xyz, valid ? 1.0 : 0.5);
}
#endif

#ifdef FLAT_CAMERA
// Section 7.1 in world space. Points are written (x, z, y), so that the third coordinate, which intersection.glsl
// compares, is the height: a refracted ray only goes down, and what lies lower is behind.
Transmitted lookupBed(vec3 refracted)
{
    vec3 u = surfaceW.xzy;
    vec3 r = refracted.xzy;
    FlatLook look = lookFlat(flatTexel(surfaceW));
    vec3 seen = look.point.xzy;
    vec3 hit = u;
    if (seen.z < u.z) { // else the bed stands out of the wave here
#ifdef ITERATIVE
        IntersectionState s = intersectionBegin(u, r, seen);
        for (int i = 1; i < refractionSteps; ++i) {
            look = lookFlat(flatTexel(s.W.xzy - look.beside));
            s = intersectionStepSeen(s, look.point.xzy);
        }
        s = intersectionEnd(s);
        hit = s.best;
        seen = s.bestA;
#else
        hit = planarIntersection(u, r, seen);
#endif
    }
    Transmitted t;
    t.hitW = hit.xzy;
    t.path = distance(seen, u);
    vec3 bed = texture(refractionColour, flatTexel(t.hitW - look.beside)).rgb;
    t.radiance = radianceThroughWater(bed, deepRadiance, letThrough(t.path)); // eq. 5
    return t;
}
#elif !defined(UNDERWATER)
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
    t.radiance = radianceThroughWater(bed, deepRadiance, letThrough(t.path)); // eq. 5
    return t;
}
#endif
#endif

#ifdef RAYCAST
#include "passes/raycast_bed.glsl"
#endif

#ifdef UNDERWATER
#include "passes/air_lookup.glsl"
#endif

#ifdef REFLECTION
#ifdef ITERATIVE_REFLECTION
// Section 7.1 in the mirrored camera's view space: where the reflected ray meets what that camera sees.
vec2 reflectionTexelAt(vec3 w) { return texelOf(reflectionClipFromView * vec4(w, 1.0)); }

float reflectionZ(vec3 w)
{
    float depth = texture(reflectionDepth, reflectionTexelAt(w)).r;
    return viewZFromDepth(depth, reflectionNearFar.x, reflectionNearFar.y);
}

vec2 reflectionTexel(vec3 reflected)
{
    vec3 u = (reflectionViewFromWorld * vec4(surfaceW, 1.0)).xyz;
    u.z = min(u.z, -1.0e-3);
    vec3 r = normalize(mat3(reflectionViewFromWorld) * reflected);
    vec3 up = mat3(reflectionViewFromWorld) * vec3(0.0, 1.0, 0.0);
    vec3 w = u;
    vec3 seen = seenThrough(u, reflectionZ(u));
    IntersectionState s = intersectionBegin(u, r, seen);
    MirrorChoice choice = mirrorBegin(u, r, up);
    for (int i = 0; i < reflectionSteps; ++i) {
        if (i > 0) {
            w = s.W;
            seen = seenThrough(w, reflectionZ(w));
            s = intersectionStepSeen(s, seen);
        }
        choice = mirrorConsider(choice, w, seen, -seen.z > 0.99 * reflectionNearFar.y);
    }
    return reflectionTexelAt(mirrorChosen(choice));
}
#else
vec2 reflectionTexel(vec3 reflected)
{
    return texelOf(reflectionClipFromWorld * vec4(surfaceW + reflectionDistance * reflected, 1.0));
}
#endif
#endif

#ifdef RAYCAST_REFLECTION
#include "passes/raycast_mirror.glsl"
#endif

#if DEBUG_VIEW == 7
// The point that the reflection's lookup shows, world, with alpha 1; where it shows none, the direction of what it does
// show (sky, or deep water) with alpha 2.
vec4 shownMirrored(vec3 reflected)
{
#ifdef RAYCAST_REFLECTION
    AfloatHit found = mirroredHit(reflected);
    return found.isFound > 0.5 ? vec4(found.point, 1.0) : vec4(reflected, 2.0);
#elif defined(REFLECTION)
    vec2 size = vec2(textureSize(reflectionDepth, 0));
    vec2 texel = clamp(reflectionTexel(reflected), 0.5 / size, 1.0 - 0.5 / size); // past its border, the border
    // The nearest sample's depth: a mean over an edge is the depth of nothing.
    float depth = texelFetch(reflectionDepth, ivec2(texel * size), 0).r;
    vec3 ray = vec3(tangentsAt(reflectionClipFromView, texel), -1.0);
    if (depth >= 1.0) return vec4(normalize(mat3(worldFromReflectionView) * ray), 2.0);
    vec3 seen = ray * -viewZFromDepth(depth, reflectionNearFar.x, reflectionNearFar.y);
    return vec4((worldFromReflectionView * vec4(seen, 1.0)).xyz, 1.0);
#else
    return vec4(reflected, 2.0);
#endif
}
#endif

vec3 reflectedRadiance(vec3 reflected)
{
#ifdef RAYCAST_REFLECTION
    AfloatHit found = mirroredHit(reflected);
    return found.isFound > 0.5 ? mirroredRadiance(found) : texture(skyMap, reflected).rgb;
#elif defined(REFLECTION)
    return texture(reflectionColour, reflectionTexel(reflected)).rgb;
#elif defined(UNDERWATER)
    return deepRadiance;
#else
    return texture(skyMap, reflected).rgb;
#endif
}

#if !defined(UNDERWATER) && !defined(NO_REFLECTION)
vec3 reflectedFrom(vec3 normal, vec3 toEye)
{
    vec3 reflected = reflectRay(-toEye, normal);
    reflected.y = abs(reflected.y); // what a steep wave mirrors of the water is mirrored there once more
    return reflected;
}

// What the surface lets through and what it mirrors, as shares, and the mirrored radiance, all of a pixel.
//
// FACETS: waves that a pixel cannot show still tilt its surface. Their slopes along the line of sight, which is where
// they matter (a grazing view sees the facets that lean towards it, so that far water mirrors more of the sky and less
// of the shore), are normal; a Gauss-Hermite rule of 3 or 5 of them stands for all. Each counts with the area that the
// eye sees of it, as in the masked slopes of Ross et al. 2005.
vec3 mirroredTowards(vec3 toEye, Surface surface, out vec2 shares)
{
    shares = fresnelShares(max(dot(toEye, surface.meanNormal), 0.0)); // E·N; a crest's far side is seen edge-on
#ifdef FACETS
#if FACETS == 3
    const vec2 rule[3] = vec2[3](vec2(0.0, 0.6666667), vec2(1.7320508, 0.1666667), vec2(-1.7320508, 0.1666667));
#else
    const vec2 rule[5] = vec2[5](vec2(0.0, 0.5333333), vec2(1.3556262, 0.2220759), vec2(-1.3556262, 0.2220759),
                                 vec2(2.8569700, 0.0112574), vec2(-2.8569700, 0.0112574));
#endif
    float deviation = sqrt(max(surface.roughness - sunRoughness * sunRoughness, 0.0));
    if (deviation > 0.003) { // below this all facets mirror the same texel
        vec2 slope = -surface.meanNormal.xz / surface.meanNormal.y;
        vec2 across = normalize(toEye.xz + vec2(1.0e-6, 0.0));
        vec3 sum = vec3(0.0);
        float reflected = 0.0, weights = 0.0;
        for (int i = 0; i < FACETS; ++i) {
            vec3 n = waveNormal(slope + rule[i].x * deviation * across);
            float facing = dot(toEye, n);
            if (facing <= 0.0) continue;
            float weight = rule[i].y * facing / n.y;
            float share = weight * fresnelShares(facing).y;
            sum += share * reflectedRadiance(reflectedFrom(n, toEye));
            reflected += share;
            weights += weight;
        }
        if (weights > 0.0) {
            float mean = reflected / weights;
            shares = vec2(1.0 - mean, mean);
            return sum / weights;
        }
    }
#endif
    return shares.y * reflectedRadiance(reflectedFrom(surface.meanNormal, toEye));
}
#endif

#ifdef UNDERWATER
void main()
{
    // No mean normal here: at the rim of Snell's window it would mix what no facet mirrors with what none lets through.
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
    float share = 0.0;
    vec3 above = vec3(0.0);
    if (fresnel < 1.0) above = ior * ior * lookupAir(refracted, hit, share); // radiance grows by n² into the denser medium
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
    const vec2 shares = vec2(1.0, 0.0);
    const vec3 mirrored = vec3(0.0);
#else
    vec2 shares;
    vec3 mirrored = mirroredTowards(toEye, surface, shares);
#endif
    float fresnel = shares.y;

#if defined(REFRACTION) || defined(RAYCAST)
    // What is mirrored is a mean over the pixel's facets. What is seen through them is that of the facet in its middle: one
    // of those that make up the mean, where a ray through a surface of the mean normal is none of them.
    vec3 refracted = refractRay(-toEye, surface.normal, 1.0 / ior);
#ifdef RAYCAST
    bool isFound;
    Transmitted transmitted = lookupBed(refracted, isFound);
#else
    Transmitted transmitted = lookupBed(refracted);
#endif
    vec3 below = transmitted.radiance;
    vec3 hit = transmitted.hitW;
    float path = transmitted.path;
#else
    vec3 below = deepRadiance;
    vec3 hit = surfaceW;
    float path = 0.0;
#endif
    vec3 radiance = mirrored + radianceThroughSurface(shares.x, ior) * below;
#ifdef NO_REFLECTION
    // nor the sun
#elif defined(PHONG)
    // Lipp takes Fresnel's cosine from the plain normal too; here it is that of the surface that mirrors.
    radiance += phongGlint(sunIrradiance, shares.y, surface.plainNormal, toEye, sunDirection, phongExponent, phongStrength);
#else
    // The sun itself is not in the reflection target: its image is spread over the waves that are too small to draw.
    float glintFresnel = fresnelShares(max(dot(toEye, normalize(toEye + sunDirection)), 0.0)).y;
    radiance += sunGlint(sunIrradiance, glintFresnel, surface.meanNormal, toEye, sunDirection, surface.roughness);
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

#if DEBUG_VIEW == 1
    fragment = vec4(vec3(fresnel), 1.0);
#elif DEBUG_VIEW == 2
    fragment = vec4(vec3(path), 1.0);
#elif DEBUG_VIEW == 3
    fragment = vec4(hit, 1.0);
#elif DEBUG_VIEW == 4
#ifdef UNDERWATER
    fragment = vec4(surface.normal, 1.0);
#else
    fragment = vec4(surface.meanNormal, 1.0);
#endif
#elif DEBUG_VIEW == 5
    fragment = vec4(surfaceW, 1.0);
#elif DEBUG_VIEW == 6
    fragment = vec4(hit, 0.5);
#ifdef RAYCAST
    fragment = vec4(hit.x, bedHeight(hit.xz), hit.z, isFound ? 1.0 : 0.5); // the picture is taken straight from above
#elif defined(REFRACTION)
    fragment = shownFor(hit);
#endif
#ifdef UNDERWATER
    if (share < 0.5) fragment.a = 0.5; // the sky was taken
#endif
#elif DEBUG_VIEW == 7
#ifdef NO_REFLECTION
    fragment = vec4(0.0); // nothing
#elif defined(UNDERWATER)
    fragment = shownMirrored(reflected);
#else
    fragment = shownMirrored(reflectedFrom(surface.meanNormal, toEye));
#endif
#else
    fragment = vec4(radiance, 1.0);
#endif
}
