// The coordinates of the shadow maps and the caustics map: where the sun's light crosses the plane of the water level.
//
// A point is projected onto that plane along the light that reaches it: above the water along the sun's direction, below it
// along the refracted one. Both are parallel projections onto a level plane, so that a texel is an area of that plane whatever
// the sun's elevation, light keeps its coordinates from where it enters all the way down, and one coordinate finds both a
// point's shadow from the air and that from the water.
//
// World space, y up, m. toSun: unit, towards the sun in the point's medium (refractedSunDirection below the water level).

// The shear of light along x and z: metres sideways for each metre that it rises. 0 for a sun in the zenith; a sun on the
// horizon has none.
SHARED vec2 sunShear(vec3 toSun)
{
    return vec2(toSun.x, toSun.z) / toSun.y;
}

// x and z at which the light through a point crosses the water level.
SHARED vec2 sunPlane(vec3 point, float waterLevel, vec2 shear)
{
    return vec2(point.x, point.z) - shear * (point.y - waterLevel);
}

// How the height of a flat surface changes per metre of the plane's coordinates, x and z. On the plane with normal n
// through p: n·(p' - p) = 0 with x = u + shear y. A surface along the light has none; the limit keeps it finite and
// is steeper than anything that receives light worth a shadow.
// n: its normal; the sign does not matter.
SHARED vec2 sunPlaneGradient(vec3 n, vec2 shear)
{
    const float steepest = 8.0;
    float along = n.y + n.x * shear.x + n.z * shear.y;
    float floored = max(abs(along), 1.0e-6);
    vec2 gradient = -vec2(n.x, n.z) / (along < 0.0 ? -floored : floored);
    float size = length(gradient);
    return size > steepest ? gradient * (steepest / size) : gradient;
}

// Texture coordinates in a map that covers a rectangle of the plane, 0 to 1 inside it.
// rect: centre x, z and half extent x, z, m.
SHARED vec2 sunMapUv(vec4 rect, vec2 plane)
{
    return (plane - vec2(rect.x, rect.y)) / vec2(rect.z, rect.w) * 0.5 + 0.5;
}

// The same for the difference of two points.
SHARED vec2 sunMapUvDifference(vec4 rect, vec2 difference)
{
    return difference * (0.5 / vec2(rect.z, rect.w));
}

// The point of the plane at texture coordinates: sunMapUv's inverse.
SHARED vec2 sunMapPlane(vec4 rect, vec2 uv)
{
    return vec2(rect.x, rect.y) + (2.0 * uv - 1.0) * vec2(rect.z, rect.w);
}
