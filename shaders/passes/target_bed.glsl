// The refraction target, and the bed by its depth (Mihálik 2008, section 7.1), for water.frag.
uniform sampler2D refractionColour;
uniform sampler2D refractionDepth;
uniform mat4 refractionViewFromWorld;
uniform mat4 refractionClipFromView;
uniform vec2 refractionNearFar;
uniform mat4 worldFromRefractionView;

vec2 refractionTexel(vec3 positionR) { return texelOf(refractionClipFromView * vec4(positionR, 1.0)); }

float refractionZ(vec3 positionR)
{
    float depth = texture(refractionDepth, refractionTexel(positionR)).r;
    return viewZFromDepth(depth, refractionNearFar.x, refractionNearFar.y);
}

// Where the search ends, and what the target shows there.
struct TargetHit {
    vec3 hitW;  // W, world
    float path; // |A - U|, m
    vec2 texel; // whose colour is taken
    float gap;  // |A - W|, m: how far off the ray the target's point at W is; known only to a search that began at a guess
};

#ifdef FLAT_CAMERA
uniform sampler2D refractionShown; // the point that a texel shows, world, weighted with how much of the texel shows any

// The target shows what a flat surface would: a point is looked up where it would seem to be.
vec2 flatTexel(vec3 pointW)
{
    vec3 seen = flatApparent(eye, pointW, waterLevel, ior);
    return refractionTexel((refractionViewFromWorld * vec4(seen, 1.0)).xyz);
}

// What the target shows at texture coordinates, and by how much that is beside what a flat surface would show there: only the
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

#if DEBUG_VIEW == DEBUG_VIEW_POSITION_A
// The point whose picture is taken for W's, world: what the target shows at W's pixel. Alpha: 1, or 1/2 where that is no
// valid sample: W is behind the camera or beside its target, or the target is empty there.
vec4 shownFor(vec3 hitW)
{
#ifdef FLAT_CAMERA
    vec2 uv = flatTexel(hitW - lookFlat(flatTexel(hitW)).beside);
    bool holds = all(greaterThanEqual(uv, vec2(0.0))) && all(lessThanEqual(uv, vec2(1.0))) &&
                 texture(refractionShown, uv).w > 1.0e-3;
    return vec4(lookFlat(uv).point, holds ? 1.0 : 0.5);
#endif
    vec3 w = (refractionViewFromWorld * vec4(hitW, 1.0)).xyz;
    vec2 texel = refractionTexel(w);
    bool inside = all(greaterThanEqual(texel, vec2(0.0))) && all(lessThanEqual(texel, vec2(1.0)));
    bool valid = w.z < 0.0 && inside && texture(refractionDepth, texel).r < 1.0;
    vec3 seen = seenThrough(vec3(w.xy, min(w.z, -1.0e-3)), refractionZ(w));
    return vec4((worldFromRefractionView * vec4(seen, 1.0)).xyz, valid ? 1.0 : 0.5);
}
#endif

#ifndef UNDERWATER
// A first look at U tells how the bed lies; the second is where it would be met were it level, or at a guess, metres along
// the ray. A guess is a hit already but for the error of what gave it, so that the end is looked at once more: it may lie
// behind what the target shows there.
#ifdef FLAT_CAMERA
void stepFlat(inout FlatLook look, inout IntersectionState s)
{
    look = lookFlat(flatTexel(s.W.xzy - look.beside));
    s = intersectionStepSeen(s, look.point.xzy);
}

// In world space. Points are written (x, z, y), so that the third coordinate, which intersection.glsl compares, is the
// height: a refracted ray only goes down, and what lies lower is behind.
TargetHit searchTarget(vec3 refracted, float guess)
{
    vec3 u = surfaceW.xzy;
    vec3 r = refracted.xzy;
    FlatLook look = lookFlat(flatTexel(surfaceW));
    vec3 seen = look.point.xzy;
    vec3 hit = u;
    if (seen.z < u.z || guess > 0.0) { // else the bed stands out of the wave here
#ifdef ITERATIVE
        IntersectionState s = intersectionBegin(u, r, seen);
        if (guess > 0.0) s = intersectionGuess(s, guess);
#define REFRACTION_STEP(i) stepFlat(look, s);
        EACH_REFRACTION_STEP
#undef REFRACTION_STEP
        s = intersectionEnd(s);
        hit = s.best;
        seen = s.bestA;
#else
        hit = planarIntersection(u, r, seen);
#endif
    }
    TargetHit t = TargetHit(hit.xzy, distance(seen, u), vec2(0.0), 0.0);
    if (guess > 0.0) {
        look = lookFlat(flatTexel(t.hitW - look.beside));
        t.gap = distance(look.point, t.hitW);
    }
    t.texel = flatTexel(t.hitW - look.beside);
    return t;
}
#else
// In the refraction camera's view space, whose eye is the origin.
TargetHit searchTarget(vec3 refracted, float guess)
{
    vec3 u = (refractionViewFromWorld * vec4(surfaceW, 1.0)).xyz;
    u.z = min(u.z, -1.0e-3); // the turned camera stands back from the water; this only guards the division
    vec3 r = normalize(mat3(refractionViewFromWorld) * refracted);
    vec3 firstSeen = seenThrough(u, refractionZ(u));
#ifdef ITERATIVE
    IntersectionState s = intersectionBegin(u, r, firstSeen);
    if (guess > 0.0) s = intersectionGuess(s, guess);
#define REFRACTION_STEP(i) s = intersectionStep(s, refractionZ(s.W));
    EACH_REFRACTION_STEP
#undef REFRACTION_STEP
    vec3 hit = s.best;
    vec3 seen = s.bestA;
#else
    vec3 hit = planarIntersection(u, r, firstSeen);
    vec3 seen = firstSeen;
#endif
    TargetHit t = TargetHit((worldFromRefractionView * vec4(hit, 1.0)).xyz, distance(seen, u), refractionTexel(hit), 0.0);
    if (guess > 0.0) t.gap = distance(seenThrough(hit, refractionZ(hit)), hit);
    return t;
}
#endif

// What the bed sends to the surface where a search has ended (eq. 5).
Transmitted transmittedFrom(TargetHit found)
{
    vec3 bed = texture(refractionColour, found.texel).rgb;
    return Transmitted(radianceThroughWater(bed, deepRadiance, letThrough(found.path)), found.hitW, found.path);
}
#endif
