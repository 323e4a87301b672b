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

// The end of a search, and the target's sample there.
struct TargetHit {
    vec3 hitW;  // W, world
    float path; // |A - U|, m
    vec2 texel; // whose colour is taken
    float gap;  // |A - W|, m: distance of the target's sample at W from the ray; only of a search that began at a guess
};

#ifdef FLAT_CAMERA
uniform sampler2D refractionPosition; // the point that a texel shows, world, weighted with its coverage

// The target is drawn as if through a flat surface: a point is looked up at its apparent position.
vec2 flatTexel(vec3 pointW)
{
    vec3 apparent = flatApparent(eye, pointW, waterLevel, ior);
    return refractionTexel((refractionViewFromWorld * vec4(apparent, 1.0)).xyz);
}

// The point of the bed that the target shows, and its offset from the one that a flat surface would show at these texture
// coordinates: only vertices are moved to their apparent positions, so that the picture within triangles is a little off.
struct BedSample {
    vec3 point;  // world; where the target is empty, one behind the whole scene
    vec3 offset; // m
};

BedSample sampleBed(vec2 texel)
{
    float z = viewZFromDepth(texture(refractionDepth, texel).r, refractionNearFar.x, refractionNearFar.y);
    vec2 tangent = tangentsAt(refractionClipFromView, texel);
    vec3 apparent = (worldFromRefractionView * vec4(vec3(-tangent, 1.0) * z, 1.0)).xyz;
    BedSample bed = BedSample(flatTrue(eye, apparent, waterLevel, ior), vec3(0.0));
    vec4 drawn = texture(refractionPosition, texel);
    if (drawn.w > 1.0e-3) {
        vec3 point = drawn.xyz / drawn.w;
        vec3 offset = point - bed.point;
        // No triangle bends by more; beyond that it is the mean of two surfaces across an edge.
        const float farthest = 0.5;
        if (dot(offset, offset) < farthest * farthest) bed.offset = offset;
        bed.point = point;
    }
    return bed;
}
#endif

#if DEBUG_VIEW == DEBUG_VIEW_POSITION_A
// For the debug view: the point whose picture is taken for that of W, world, which is the target's sample at W's pixel. Alpha:
// 1, or 1/2 if the sample is not valid: W is behind the camera or outside its target, or the target is empty there.
vec4 sampledPosition(vec3 hitW)
{
#ifdef FLAT_CAMERA
    vec2 uv = flatTexel(hitW - sampleBed(flatTexel(hitW)).offset);
    bool holds = all(greaterThanEqual(uv, vec2(0.0))) && all(lessThanEqual(uv, vec2(1.0))) &&
                 texture(refractionPosition, uv).w > 1.0e-3;
    return vec4(sampleBed(uv).point, holds ? 1.0 : 0.5);
#endif
    vec3 w = (refractionViewFromWorld * vec4(hitW, 1.0)).xyz;
    vec2 texel = refractionTexel(w);
    bool inside = all(greaterThanEqual(texel, vec2(0.0))) && all(lessThanEqual(texel, vec2(1.0)));
    bool valid = w.z < 0.0 && inside && texture(refractionDepth, texel).r < 1.0;
    vec3 A = depthSample(vec3(w.xy, min(w.z, -1.0e-3)), refractionZ(w));
    return vec4((worldFromRefractionView * vec4(A, 1.0)).xyz, valid ? 1.0 : 0.5);
}
#endif

#ifndef UNDERWATER
// The first depth sample, at U, gives the height of the bed. The second is taken where the ray would meet it if it were level,
// or at `guess` metres along the ray (0: no guess). A guess is a hit from elsewhere, up to that source's error; so the result is
// sampled once more, since it may lie behind what the target shows there.
#ifdef FLAT_CAMERA
void stepFlat(inout BedSample bed, inout IntersectionState s)
{
    bed = sampleBed(flatTexel(s.W.xzy - bed.offset));
    s = intersectionStepSampled(s, bed.point.xzy);
}

// In world space. Points are written (x, z, y), so that the third coordinate, which intersection.glsl compares, is the
// height: a refracted ray only goes down, and what lies lower is behind.
TargetHit searchTarget(vec3 refracted, float guess)
{
    vec3 u = surfaceW.xzy;
    vec3 r = refracted.xzy;
    BedSample bed = sampleBed(flatTexel(surfaceW));
    vec3 A = bed.point.xzy;
    vec3 hit = u;
    if (A.z < u.z || guess > 0.0) { // else the bed rises above the wave here
#ifdef ITERATIVE
        IntersectionState s = intersectionBegin(u, r, A);
        if (guess > 0.0) s = intersectionGuess(s, guess);
#define REFRACTION_STEP(i) stepFlat(bed, s);
        EACH_REFRACTION_STEP
#undef REFRACTION_STEP
        s = intersectionEnd(s);
        hit = s.best;
        A = s.bestA;
#else
        hit = planarIntersection(u, r, A);
#endif
    }
    TargetHit t = TargetHit(hit.xzy, distance(A, u), vec2(0.0), 0.0);
    if (guess > 0.0) {
        bed = sampleBed(flatTexel(t.hitW - bed.offset));
        t.gap = distance(bed.point, t.hitW);
    }
    t.texel = flatTexel(t.hitW - bed.offset);
    return t;
}
#else
// In the refraction camera's view space, whose eye is the origin.
TargetHit searchTarget(vec3 refracted, float guess)
{
    vec3 u = (refractionViewFromWorld * vec4(surfaceW, 1.0)).xyz;
    u.z = min(u.z, -1.0e-3); // the turned camera stands back from the water; this only guards the division
    vec3 r = normalize(mat3(refractionViewFromWorld) * refracted);
    vec3 A1 = depthSample(u, refractionZ(u));
#ifdef ITERATIVE
    IntersectionState s = intersectionBegin(u, r, A1);
    if (guess > 0.0) s = intersectionGuess(s, guess);
#define REFRACTION_STEP(i) s = intersectionStep(s, refractionZ(s.W));
    EACH_REFRACTION_STEP
#undef REFRACTION_STEP
    vec3 hit = s.best;
    vec3 A = s.bestA;
#else
    vec3 hit = planarIntersection(u, r, A1);
    vec3 A = A1;
#endif
    TargetHit t = TargetHit((worldFromRefractionView * vec4(hit, 1.0)).xyz, distance(A, u), refractionTexel(hit), 0.0);
    if (guess > 0.0) t.gap = distance(depthSample(hit, refractionZ(hit)), hit);
    return t;
}
#endif

// Radiance that reaches the surface from the end of a search (eq. 5).
Transmitted transmittedFrom(TargetHit found)
{
    vec3 bed = texture(refractionColour, found.texel).rgb;
    return Transmitted(radianceThroughWater(bed, deepRadiance, attenuationOver(found.path)), found.hitW, found.path);
}
#endif
