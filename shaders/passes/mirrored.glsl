// What the surface mirrors of a ray: found in the mirrored camera's picture (Mihálik 2008, section 7.1 and eq. 6), in a map
// of heights (Lipp), in both, or the sky alone. For water.frag.
#ifdef RAYCAST_REFLECTION
#include "passes/raycast_mirror.glsl"
#endif

#ifdef REFLECTION
uniform sampler2D reflectionColour;
#ifdef ITERATIVE_REFLECTION
uniform mat4 reflectionViewFromWorld;
#else
uniform mat4 reflectionClipFromWorld;
uniform float reflectionDistance; // c of eq. 6
#endif
#if DEBUG_VIEW == DEBUG_VIEW_REFLECTION_HIT || defined(ITERATIVE_REFLECTION)
uniform sampler2D reflectionDepth;
uniform mat4 reflectionClipFromView;
uniform vec2 reflectionNearFar;
#endif
#if DEBUG_VIEW == DEBUG_VIEW_REFLECTION_HIT
uniform mat4 worldFromReflectionView;
#endif

#ifdef ITERATIVE_REFLECTION
// Section 7.1 in the mirrored camera's view space: where the reflected ray meets what that camera sees.
vec2 reflectionTexelAt(vec3 w) { return texelOf(reflectionClipFromView * vec4(w, 1.0)); }

float reflectionZ(vec3 w)
{
    float depth = texture(reflectionDepth, reflectionTexelAt(w)).r;
    return viewZFromDepth(depth, reflectionNearFar.x, reflectionNearFar.y);
}

bool isMirroredSky(vec3 seen) { return -seen.z > 0.99 * reflectionNearFar.y; }

void stepMirrored(inout IntersectionState s, inout MirrorChoice choice)
{
    vec3 w = s.W;
    vec3 seen = seenThrough(w, reflectionZ(w));
    s = intersectionStepSeen(s, seen);
    choice = mirrorConsider(choice, w, seen, isMirroredSky(seen));
}

// miss: squared chord between the ray's direction and that of what is shown for it.
vec2 reflectionTexel(vec3 reflected, out float miss)
{
    vec3 u = (reflectionViewFromWorld * vec4(surfaceW, 1.0)).xyz;
    u.z = min(u.z, -1.0e-3);
    vec3 r = normalize(mat3(reflectionViewFromWorld) * reflected);
    vec3 up = mat3(reflectionViewFromWorld) * vec3(0.0, 1.0, 0.0);
    vec3 seen = seenThrough(u, reflectionZ(u));
    IntersectionState s = intersectionBegin(u, r, seen);
    MirrorChoice choice = mirrorConsider(mirrorBegin(u, r, up), u, seen, isMirroredSky(seen));
#define REFLECTION_STEP(i) stepMirrored(s, choice);
    EACH_REFLECTION_STEP
#undef REFLECTION_STEP
    miss = mirrorMiss(choice);
    return reflectionTexelAt(mirrorChosen(choice));
}
#else
vec2 reflectionTexel(vec3 reflected, out float miss)
{
    miss = 0.0; // as published, nobody asks
    return texelOf(reflectionClipFromWorld * vec4(surfaceW + reflectionDistance * reflected, 1.0));
}
#endif
#endif

#ifdef RAYCAST_REFLECTION
// Whether a mirrored ray is marched through the map, and what it meets there. Where there is a picture too, that is taken
// where it shows what lies on the ray: it shows crowns that a map has no room for.
bool isMirroredOnMap(vec3 reflected, float miss, out AboveWaterHit found)
{
#ifdef REFLECTION
    const float onRay = 1.9e-5; // a quarter of a degree
    if (miss < onRay) return false;
    found = mirroredHit(reflected);
    return found.isFound > 0.5;
#else
    found = mirroredHit(reflected);
    return true;
#endif
}
#endif

#if DEBUG_VIEW == DEBUG_VIEW_REFLECTION_HIT
#ifdef REFLECTION
vec4 shownAt(vec2 uv)
{
    vec2 size = vec2(textureSize(reflectionDepth, 0));
    vec2 texel = clamp(uv, 0.5 / size, 1.0 - 0.5 / size); // past its border, the border
    // The nearest sample's depth: a mean over an edge is the depth of nothing.
    float depth = texelFetch(reflectionDepth, ivec2(texel * size), 0).r;
    vec3 ray = vec3(tangentsAt(reflectionClipFromView, texel), -1.0);
    if (depth >= 1.0) return vec4(normalize(mat3(worldFromReflectionView) * ray), 2.0);
    vec3 seen = ray * -viewZFromDepth(depth, reflectionNearFar.x, reflectionNearFar.y);
    return vec4((worldFromReflectionView * vec4(seen, 1.0)).xyz, 1.0);
}
#endif

// The point that the reflection's lookup shows, world, with alpha 1; where it shows none, the direction of what it does
// show (sky, or deep water) with alpha 2.
vec4 shownMirrored(vec3 reflected)
{
    float miss = 0.0;
#ifdef REFLECTION
    vec2 texel = reflectionTexel(reflected, miss);
#endif
#ifdef RAYCAST_REFLECTION
    AboveWaterHit found;
    if (isMirroredOnMap(reflected, miss, found))
        return found.isFound > 0.5 ? vec4(found.point, 1.0) : vec4(reflected, 2.0);
#endif
#ifdef REFLECTION
    return shownAt(texel);
#else
    return vec4(reflected, 2.0);
#endif
}
#endif

vec3 reflectedRadiance(vec3 reflected)
{
    float miss = 0.0;
#ifdef REFLECTION
    vec3 shown = texture(reflectionColour, reflectionTexel(reflected, miss)).rgb;
#elif defined(UNDERWATER)
    vec3 shown = deepRadiance;
#else
    vec3 shown = texture(skyMap, reflected).rgb;
#endif
#ifdef RAYCAST_REFLECTION
    AboveWaterHit found;
    if (isMirroredOnMap(reflected, miss, found) && found.isFound > 0.5) return mirroredRadiance(found);
#endif
    return shown;
}
