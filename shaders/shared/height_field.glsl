// Intersection of a ray with a height field: the bed as heights over a rectangle.
//
// Lipp steps along the ray. Of the step that ends under the ground he takes the intersection of two straight lines: the ray,
// and the ground between its heights at the step's ends. That misses what is thinner than a step. patchCrossing below
// intersects the ground between four neighbouring heights itself; with a pyramid of largest heights, which tells where a ray
// passes over everything, no patch is skipped (Tevs et al. 2008).

// How many steps Lipp takes for each unit of a refracted ray: 10 where it runs level, 3 where it goes straight down.
// rayY: the unit direction's y, -1 to 0.
SHARED float refractionStepsPerUnit(float rayY)
{
    return mix(10.0, 3.0, clamp(-rayY, 0.0, 1.0));
}

// Of a reflected ray: 4 where it runs level, half of one where it goes straight up. rayY: 0 to 1.
SHARED float reflectionStepsPerUnit(float rayY)
{
    return mix(0.5, 4.0, 1.0 - clamp(rayY, 0.0, 1.0));
}

// The fraction of a step at which the ray's line meets the ground's: both run straight between their heights before and
// after it. The listing divides by cpy - cpy + depth - olddepth; the derivation above it has cpoy - cpy, which is right.
// The ray must be over the ground before the step and not over it after; else the result is no fraction.
SHARED float crossingFraction(float rayBefore, float groundBefore, float rayAfter, float groundAfter)
{
    return (rayBefore - groundBefore) / (rayBefore - rayAfter + groundAfter - groundBefore);
}

// Height of the bilinear patch between four heights, at a position in 0..1.
// corners: at (0, 0), (1, 0), (0, 1) and (1, 1).
SHARED float patchHeight(vec4 corners, vec2 position)
{
    return mix(mix(corners.x, corners.y, position.x), mix(corners.z, corners.w, position.x), position.y);
}

// Metres along a ray to its first intersection with the patch, or -1 if it leaves the cell without one. 0 if it starts under
// the patch.
// from: the ray's start, in the cell's own coordinates (0..1), and its height; along: how these change for each metre;
// within: metres to where the ray leaves the cell.
SHARED float patchCrossing(vec4 corners, vec3 from, vec3 along, float within)
{
    vec2 position = vec2(from.x, from.y);
    vec2 direction = vec2(along.x, along.y);
    float twist = corners.x - corners.y - corners.z + corners.w;
    // Height over the patch as a function of the metres t: a t² + b t + c.
    float c = from.z - patchHeight(corners, position);
    if (c <= 0.0) return 0.0;
    float b = along.z - (corners.y - corners.x + twist * position.y) * direction.x -
              (corners.z - corners.x + twist * position.x) * direction.y;
    float a = -twist * direction.x * direction.y;
    float discriminant = b * b - 4.0 * a * c;
    if (discriminant < 0.0) return -1.0;
    // c / q is the root that stays where a is zero, and loses no digits (Press et al. 2007, section 5.6).
    float q = -0.5 * (b + (b < 0.0 ? -1.0 : 1.0) * sqrt(discriminant));
    float first = q == 0.0 ? -1.0 : c / q;
    float second = a == 0.0 ? -1.0 : q / a;
    float least = min(first, second);
    float root = least >= 0.0 ? least : max(first, second);
    return root >= 0.0 && root <= within ? root : -1.0;
}
