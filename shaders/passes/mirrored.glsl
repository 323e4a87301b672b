// Radiance along a reflected ray: from the mirrored camera's picture (Mihálik 2008, section 7.1 and eq. 6), from a map of
// heights (Lipp), from both, or of the sky alone. For water.frag.
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
// Section 7.1 in the mirrored camera's view space: intersects the reflected ray with that camera's depth buffer.
vec2 reflectionTexelAt(vec3 w) { return texelOf(reflectionClipFromView * vec4(w, 1.0)); }

float reflectionZ(vec3 w)
{
    float depth = texture(reflectionDepth, reflectionTexelAt(w)).r;
    return viewZFromDepth(depth, reflectionNearFar.x, reflectionNearFar.y);
}

bool isMirroredSky(vec3 A) { return -A.z > 0.99 * reflectionNearFar.y; }

void stepMirrored(inout IntersectionState s, inout MirrorChoice choice)
{
    vec3 w = s.W;
    vec3 A = depthSample(w, reflectionZ(w));
    s = intersectionStepSampled(s, A);
    choice = mirrorConsider(choice, w, A, isMirroredSky(A));
}

// miss: squared chord between the ray's direction and that of the sample which is taken for it.
vec2 reflectionTexel(vec3 reflected, out float miss)
{
    vec3 u = (reflectionViewFromWorld * vec4(surfaceW, 1.0)).xyz;
    u.z = min(u.z, -1.0e-3);
    vec3 r = normalize(mat3(reflectionViewFromWorld) * reflected);
    vec3 up = mat3(reflectionViewFromWorld) * vec3(0.0, 1.0, 0.0);
    vec3 A = depthSample(u, reflectionZ(u));
    IntersectionState s = intersectionBegin(u, r, A);
    MirrorChoice choice = mirrorConsider(mirrorBegin(u, r, up), u, A, isMirroredSky(A));
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
// Whether a reflected ray is marched through the map, and its hit there. If there is a picture too, that is used wherever its
// sample lies on the ray: it shows tree crowns, which a map of heights cannot hold.
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
vec4 mirroredPositionAt(vec2 uv)
{
    vec2 size = vec2(textureSize(reflectionDepth, 0));
    vec2 texel = clamp(uv, 0.5 / size, 1.0 - 0.5 / size); // beyond the border, the border
    // The nearest sample's depth: a mean across an edge is the depth of neither side.
    float depth = texelFetch(reflectionDepth, ivec2(texel * size), 0).r;
    vec3 ray = vec3(tangentsAt(reflectionClipFromView, texel), -1.0);
    if (depth >= 1.0) return vec4(normalize(mat3(worldFromReflectionView) * ray), 2.0);
    vec3 hit = ray * -viewZFromDepth(depth, reflectionNearFar.x, reflectionNearFar.y);
    return vec4((worldFromReflectionView * vec4(hit, 1.0)).xyz, 1.0);
}
#endif

// For the debug view: the point whose radiance the lookup returns, world, with alpha 1; for sky or deep water its direction,
// with alpha 2.
vec4 mirroredPosition(vec3 reflected)
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
    return mirroredPositionAt(texel);
#else
    return vec4(reflected, 2.0);
#endif
}
#endif

vec3 reflectedRadiance(vec3 reflected)
{
    float miss = 0.0;
#ifdef REFLECTION
    vec3 radiance = texture(reflectionColour, reflectionTexel(reflected, miss)).rgb;
#elif defined(UNDERWATER)
    vec3 radiance = deepRadiance;
#else
    vec3 radiance = texture(skyMap, reflected).rgb;
#endif
#ifdef RAYCAST_REFLECTION
    AboveWaterHit found;
    if (isMirroredOnMap(reflected, miss, found) && found.isFound > 0.5) return mirroredRadiance(found);
#endif
    return radiance;
}
