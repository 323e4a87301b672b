// What a reflected ray meets, found in the mirrored camera's depth picture by the search of intersection.glsl (Mihálik
// 2008, section 7.1), whose candidates are judged by another rule.
//
// By the least |A - W| a tree in front of the sky would win over the sky, whose point A lies on the far plane. So candidates
// are compared by the angle at U between A and the ray. If some geometry reaches higher than the ray, it stands on ground
// that hides the sky, though this camera, below the water level, may see only the ground's back and so not draw it: then no
// sky is taken.
//
//     MirrorChoice c = mirrorBegin(U, R, up);
//     for each depth sample A of the search, at W:  c = mirrorConsider(c, W, A, A is on the far plane);
//     use the pixel of mirrorChosen(c)
//
// All in the mirrored camera's view space; R and up are unit vectors, up the world's.

struct MirrorChoice {
    vec3 U;
    vec3 R;
    vec3 up;
    vec3 best;       // the W whose A lies nearest to the ray's direction
    vec3 bestGeometry;  // the same, among samples that are not sky
    float leastMiss;     // squared chord between the directions A - U and R, of best
    float leastGeometryMiss;
    bool isBlocked;    // some geometry reaches higher than the ray
};

SHARED MirrorChoice mirrorBegin(vec3 U, vec3 R, vec3 up)
{
    MirrorChoice choice;
    choice.U = U;
    choice.R = R;
    choice.up = up;
    choice.best = U;
    choice.bestGeometry = U;
    choice.leastMiss = 8.0; // more than any has
    choice.leastGeometryMiss = 8.0;
    choice.isBlocked = false;
    return choice;
}

SHARED MirrorChoice mirrorConsider(MirrorChoice last, vec3 W, vec3 A, bool isSky)
{
    MirrorChoice choice = last;
    vec3 toSample = normalize(A - last.U);
    vec3 difference = toSample - last.R; // 1 - cosine would be rounding error alone for all small angles
    float miss = dot(difference, difference);
    if (miss < last.leastMiss) {
        choice.leastMiss = miss;
        choice.best = W;
    }
    if (isSky) return choice;
    if (miss < last.leastGeometryMiss) {
        choice.leastGeometryMiss = miss;
        choice.bestGeometry = W;
    }
    if (dot(toSample, last.up) > dot(last.R, last.up)) choice.isBlocked = true;
    return choice;
}

SHARED vec3 mirrorChosen(MirrorChoice choice)
{
    if (choice.isBlocked) return choice.bestGeometry;
    return choice.best;
}

// Squared chord between the ray's direction and that of the sample at mirrorChosen's pixel.
SHARED float mirrorMiss(MirrorChoice choice)
{
    if (choice.isBlocked) return choice.leastGeometryMiss;
    return choice.leastMiss;
}
