// Where a refracted ray meets the bed, found in the refraction camera's depth picture (Mihálik 2008, section 7.1).
//
// All points are in that camera's view space: the eye at the origin, looking along -z. U is the point on the water,
// R the unit refracted direction, p the line U + s R. W is a point of p; A is the point of the bed that the camera
// sees behind (or in front of) W: A = W · zA / W.z, zA the view-space z of the depth picture at W's pixel.
//
//     IntersectionState s = intersectionBegin(U, R, depthSample(U, zA at U)); // the first sample; s.W is W1
//     for (int i = 1; i < steps; ++i)
//         s = intersectionStep(s, zA at the pixel of s.W);                    // one sample each; s.W is the next
//     use s.best (its pixel's colour), s.bestA (|bestA - U| is eq. 4's path), s.bestDistance
//
// The count is the paper's: n steps take n depth samples, at W0 = U, W1, ... W(n-1), and the W with the least |A - W| wins.
// s.W is the one that a further step would have sampled. The thesis says nothing of it, and its cameras ignore it here too;
// but it costs no sample, and with a camera of our own intersectionEnd takes it.
//
// Differences from the text (its eq. 3 is right; what follows are the listings of 7.1 and 9.1):
// - 7.1 calls RayIntersec(W_i, U, A_{i+1} - A_i, R). Its first line then starts at W_i, a point of p, and runs along
//   the bed: the "intersection" is W_i itself and the search never moves. It must start at A_i. 9.1 does
//   (A1, u1, A2 - A1, R1), but solves for the point of the bed's line; the two agree only in exact arithmetic, and
//   rounding then drifts off p. Equation 3 solves on p: its Q is A_{i+1} - A_i and its R is p's direction, while the
//   listings pass R where eq. 3 has Q.
// - "W between A_i and A_{i+1}" is tested in 7.1 as |A_{i+1} - A_i| < |W - A_i| + |A_{i+1} - W|, which rounding
//   makes true or false at random; 9.1 allows 10 %. All these points lie in the plane of p and the eye, so that the
//   test is exactly whether s lies between those of W_{i-1} and W_i. What is asked here is what that is for: that
//   the new s lies between the furthest W known in front of the bed and the nearest known behind it. It admits
//   extrapolation while both tries are on one side, which a smooth bed needs to converge fast.
// - The step that replaces a rejected intersection, W_i ± |A_{i+1} - W_i| R, has no bound: at a grazing angle,
//   |A - W| is many times the distance to go, and it leaps ever further. Here it stays inside the same interval, and
//   halves it where it would leave.
// - 9.1 takes that step along refrvec, which is in the main camera's space; it must be R1, in the refraction camera's.
// - 9.1 moves the point u between the cameras with w = 0, which drops the translation: right for the direction R, not
//   for a point. TexCoor projects with w = 0 as well, which a symmetric perspective projection happens to forgive
//   (only clip z depends on it). Both are products with w = 1 here, in the caller.
// - 9.1 has A = -(W.xy · depth / W.z, depth), 7.1 has A = (W.xy · Z / W.z, Z): the first is right for a positive
//   distance, the second for a negative z. Only z, negative, is used here.
// - 7.1 tests `i = 0`; it means W0 = A0 = U, where no line of the bed is known yet. That first step, which gives the
//   planar approximation W1, is intersectionBegin.

struct IntersectionState {
    vec3 U;
    vec3 R;
    vec3 W;             // the next point to sample
    float s;            // W = U + s R
    vec3 A;             // the last sample
    float inFront;      // s of the furthest W known in front of the bed
    float behind;       // s of the nearest W known behind it, or the end of the search
    vec3 best;          // the W with the least |A - W| so far
    vec3 bestA;
    float bestDistance; // |A - W| of it
};

// How far along p the point lies that is nearest to the line a + t q; their intersection when they meet (Mihálik 2008,
// eq. 3). -1 when the lines are parallel: |R × Q|² is then rounding error of the order of (1e-7 |Q|)², and the limit
// lies well above that square and well below any angle that a pixel can tell from zero (1e-5 rad).
SHARED float distanceAlongRay(vec3 U, vec3 R, vec3 a, vec3 q)
{
    vec3 n = cross(R, q);
    float n2 = dot(n, n);
    if (n2 <= 1.0e-10 * dot(q, q)) return -1.0;
    return dot(cross(a - U, q), n) / n2;
}

// The point of the ray nearest to the line (eq. 3), or its origin when they are parallel.
SHARED vec3 closestOnRay(vec3 origin, vec3 dir, vec3 lineA, vec3 lineDir)
{
    return origin + max(distanceAlongRay(origin, dir, lineA, lineDir), 0.0) * dir;
}

// The point A that the depth buffer holds at W's pixel. viewZ: negative, from the depth picture.
SHARED vec3 depthSample(vec3 W, float viewZ)
{
    return W * (viewZ / W.z);
}

// The first approximation (Mihálik 2008, Fig. 7): as far along R as the bed is behind U.
SHARED vec3 planarIntersection(vec3 U, vec3 R, vec3 A1)
{
    return U + length(A1 - U) * R;
}

// Where p leaves what the camera can project: 1/1000 of U's distance in front of the plane of the eye. A ray that
// does not come back ends at 1e6 m, beyond every scene and with its square still a small float.
SHARED float intersectionReach(vec3 U, vec3 R)
{
    const float farthest = 1.0e6;
    if (R.z <= 0.0) return farthest;
    return min(0.999 * -U.z / R.z, farthest);
}

SHARED IntersectionState intersectionBegin(vec3 U, vec3 R, vec3 A1)
{
    IntersectionState state;
    state.U = U;
    state.R = R;
    state.A = A1;
    state.inFront = 0.0;
    state.behind = intersectionReach(U, R);
    state.best = U;
    state.bestA = state.A;
    state.bestDistance = length(state.A - U);
    state.s = min(state.bestDistance, state.behind);
    state.W = U + state.s * R;
    return state;
}

// Replaces the planar approximation by a point that is known from elsewhere: `s` along p.
SHARED IntersectionState intersectionGuess(IntersectionState begun, float s)
{
    IntersectionState state = begun;
    state.s = clamp(s, state.inFront, state.behind);
    state.W = state.U + state.s * state.R;
    return state;
}

// A: the point that the camera sees along its ray through last.W, whatever the projection.
SHARED IntersectionState intersectionStepSampled(IntersectionState last, vec3 A)
{
    IntersectionState state = last;
    float gap = length(A - last.W);
    if (gap < last.bestDistance) {
        state.best = last.W;
        state.bestA = A;
        state.bestDistance = gap;
    }

    // The smaller |z| on one line through the eye is in front.
    bool isInFront = last.W.z > A.z;
    if (isInFront)
        state.inFront = last.s;
    else
        state.behind = last.s;

    float s = distanceAlongRay(last.U, last.R, last.A, A - last.A);
    if (s < state.inFront || s > state.behind) {
        // No intersection within the interval: the paper's step by the gap, or half the interval.
        s = isInFront ? last.s + gap : last.s - gap;
        if (s < state.inFront || s > state.behind) s = 0.5 * (state.inFront + state.behind);
    }
    state.s = s;
    state.W = last.U + s * last.R;
    state.A = A;
    return state;
}

// The step for a perspective camera, from the view-space z of the depth picture at last.W's pixel.
SHARED IntersectionState intersectionStep(IntersectionState last, float viewZ)
{
    return intersectionStepSampled(last, depthSample(last.W, viewZ));
}

// After the last sample: the point that a further step would have sampled becomes the best if it continues the best, that
// is, if the bed's line has met p within twice the remaining gap. One that is further off lies on a line across some edge.
// After a single sample this is the planar approximation.
SHARED IntersectionState intersectionEnd(IntersectionState last)
{
    IntersectionState state = last;
    if (length(last.W - last.best) > 2.0 * last.bestDistance) return state;
    state.best = last.W;
    state.bestA = last.W;
    return state;
}
