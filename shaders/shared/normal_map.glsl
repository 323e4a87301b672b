// Ripples from a picture of normals, in four layers that drift over the water (Lipp, shader documentation of "Physically
// Correct perturbed planar Refractions & Reflections in Real Time", section 2, after Sousa 2005).
//
// The picture's red, green and blue hold x, y (up) and z of unit normals, 0..1 for -1..1; it repeats at its edges. The
// layers' normals are averaged, then made steeper by making y smaller.
//
// What differs from the listing: it makes the surface of the map alone, here the map's slope is added to that of the
// waves, as the heights of two surfaces add. And where the listing's bump factor is 0, a level surface has no normal at
// all; here slopes are limited to 50.

// A layer's normal from its colour.
SHARED vec3 normalMapNormal(vec3 colour)
{
    return 2.0 * colour - 1.0;
}

// Slope dy/dx, dy/dz of the surface that the layers' normals add up to. The sum's length does not matter.
// bump: factor on y, 1 plain to 0 steepest.
SHARED vec2 normalMapSlope(vec3 sum, float bump)
{
    float up = max(bump * sum.y, 0.02 * length(sum));
    return -vec2(sum.x, sum.z) / max(up, 1.0e-6);
}

// Variance of the slope, per axis, that averaging over texels has taken away from one layer.
// texel: mean of the normals, and in w that of half the slopes' squares.
SHARED float normalMapFilteredVariance(vec4 texel)
{
    vec2 slope = normalMapSlope(vec3(texel), 1.0);
    return max(texel.w - 0.5 * dot(slope, slope), 0.0);
}

// The same of the mean of four layers, from the sum of theirs: they lie beside each other as if by chance.
SHARED float normalMapSlopeVariance(float filteredVariances, float bump)
{
    float steeper = max(bump, 0.02);
    return filteredVariances / (16.0 * steeper * steeper);
}
