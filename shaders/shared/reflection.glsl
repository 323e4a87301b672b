// What a reflected ray meets, found in the mirrored camera's depth picture by the search of intersection.glsl (Mihálik
// 2008, section 7.1), whose candidates are judged by another rule.
//
// The least |A - W| would be that of a tree in front of the sky, which is a place like any other, but on the far plane:
// what counts here is the angle at U between A and the ray. What is seen to stand higher than the ray goes stands on the
// ground, which that camera, below the level, may see the back of and so not at all: no sky is taken then.
//
//     MirrorChoice c = mirrorBegin(U, R, up);
//     for each look of the search, at W, which shows A:  c = mirrorConsider(c, W, A, A is on the far plane);
//     use the pixel of mirrorChosen(c)
//
// All in the mirrored camera's view space; R and up are unit vectors, up the world's.

struct MirrorChoice {
    vec3 U;
    vec3 R;
    vec3 up;
    vec3 best;       // the W whose A lies nearest to the ray's direction
    vec3 bestThing;  // the same without the sky
    float least;     // squared chord between the directions A - U and R, of best
    float leastThing;
    bool isBlocked;  // a thing was seen to stand higher than the ray goes
};

SHARED MirrorChoice mirrorBegin(vec3 U, vec3 R, vec3 up)
{
    MirrorChoice choice;
    choice.U = U;
    choice.R = R;
    choice.up = up;
    choice.best = U;
    choice.bestThing = U;
    choice.least = 8.0; // more than any has
    choice.leastThing = 8.0;
    choice.isBlocked = false;
    return choice;
}

SHARED MirrorChoice mirrorConsider(MirrorChoice last, vec3 W, vec3 A, bool isSky)
{
    MirrorChoice choice = last;
    vec3 way = normalize(A - last.U);
    vec3 beside = way - last.R; // 1 - cosine would be rounding error alone for all small angles
    float miss = dot(beside, beside);
    if (miss < last.least) {
        choice.least = miss;
        choice.best = W;
    }
    if (isSky) return choice;
    if (miss < last.leastThing) {
        choice.leastThing = miss;
        choice.bestThing = W;
    }
    if (dot(way, last.up) > dot(last.R, last.up)) choice.isBlocked = true;
    return choice;
}

SHARED vec3 mirrorChosen(MirrorChoice choice)
{
    if (choice.isBlocked) return choice.bestThing;
    return choice.best;
}

// Squared chord between the ray's direction and that of what is shown at mirrorChosen's pixel.
SHARED float mirrorMiss(MirrorChoice choice)
{
    if (choice.isBlocked) return choice.leastThing;
    return choice.least;
}
