// Caustics: light that the waves gather on what lies under water (Mihálik 2008, chapter 8), from the photon that enters the
// surface to the irradiance that the caustics map gives.
//
// Needs refraction.glsl. A photon carries the flux of one cell of a regular lattice on the water level. The map covers a
// rectangle of that plane (sunlight.glsl: sunMapUv); its texels hold flux, relative to what a texel gets above the water.
// Metres but where texels are named.

// --- A photon enters ---------------------------------------------------------------------------------------------

// Height above the water level at which a ray of the sun meets the waves: one step of Newton's method from the point where
// the ray crosses the level, exact for a surface of constant slope.
// height, slope: of the waves at that crossing; shear: sunShear above the water.
SHARED float photonEntryHeight(float height, vec2 slope, vec2 shear)
{
    // 0 where a ray runs along the surface. Below a fifth the wave's crest has shadowed the point long since, and a step
    // without a bound would leave the wave.
    const float least = 0.2;
    return height / max(1.0 - dot(slope, shear), least);
}

// Flux of a lattice cell relative to that of a texel: the ratio of their areas.
SHARED float photonFraction(float cellSize, float texelSize)
{
    return (cellSize / texelSize) * (cellSize / texelSize);
}

// Flux of a photon just under the surface.
// cosine: between the wave's normal and the sun's direction, > 0; ior: of the water.
SHARED float photonFlux(float cosine, float ior, float cellSize, float texelSize)
{
    return (1.0 - fresnelExact(cosine, 1.0 / ior)) * photonFraction(cellSize, texelSize);
}

// --- It travels --------------------------------------------------------------------------------------------------

// The point at a height on the line through W along the sun's direction. Points are written (x, z, y), as intersection.glsl
// compares them.
// shear: sunShear in the medium.
SHARED vec3 sunRayAtHeight(vec3 W, float height, vec2 shear)
{
    vec2 xz = vec2(W.x, W.y) + shear * (height - W.z);
    return vec3(xz, height);
}

// Flux of a photon after `path` metres of water.
SHARED vec3 photonLight(float flux, float path, vec3 absorption)
{
    return flux * beerLambert(absorption, path);
}

// --- It lands in the map -----------------------------------------------------------------------------------------

// Weight of a photon for the texel at an offset from it, in texels: the hat, whose values at the four texels around a
// photon sum to 1, so that spreading it keeps its energy.
SHARED float photonWeight(vec2 offset)
{
    return max(1.0 - abs(offset.x), 0.0) * max(1.0 - abs(offset.y), 0.0);
}

// Area of a triangle with these two edges. Where light folds back the orientation changes, and the area does not.
SHARED float triangleArea(vec2 a, vec2 b)
{
    return 0.5 * abs(a.x * b.y - a.y * b.x);
}

// Whether a triangle between three photons (area in texels) is added as a point: where light focuses, triangles shrink
// below what a texel's samples can find, and one that is found by chance would bring far too much.
SHARED bool isAddedAsPoint(float area)
{
    return area < 0.25;
}

// Weight of a cell in the filter of the caustics map: binomial, 1-2-1 (radius 1) or 1-4-6-4-1 (radius 2) in each
// direction; the weights of a row sum to 1, so that the filter keeps the energy.
SHARED float causticsFilterWeight(int radius, int offset)
{
    int k = offset < 0 ? -offset : offset;
    if (k > radius) return 0.0;
    if (radius <= 0) return 1.0;
    if (radius == 1) return k == 0 ? 0.5 : 0.25;
    return k == 0 ? 0.375 : (k == 1 ? 0.25 : 0.0625);
}

// --- A surface is lit --------------------------------------------------------------------------------------------

// Fraction of the map in the light at a point of the plane; the rest is that of flat water. 0 beside the map and beside the
// water's rectangle, where there are no waves and so no photons; 1 further inside than the border.
// mapRect, waterRect: centre and half extent, x and z; border: its width, no less than two texels.
SHARED float causticsFade(vec2 plane, vec4 mapRect, vec4 waterRect, float border, float texelSize)
{
    vec2 toMapEdge = vec2(mapRect.z, mapRect.w) - abs(plane - vec2(mapRect.x, mapRect.y));
    vec2 toWaterEdge = vec2(waterRect.z, waterRect.w) - abs(plane - vec2(waterRect.x, waterRect.y));
    vec2 toEdge = min(toMapEdge, toWaterEdge);
    return clamp(min(toEdge.x, toEdge.y) / max(border, 2.0 * texelSize), 0.0, 1.0);
}

// Irradiance on a surface that faces the refracted sun, from the map's value there. The map compares level areas: the
// sun's irradiance on one is its cosine times that on a surface that faces it, above the water and below.
// cosAbove, cosBelow: of the angles between the vertical and the sun's direction in either medium.
SHARED vec3 causticsIrradiance(vec3 relative, vec3 sunIrradiance, float cosAbove, float cosBelow)
{
    return relative * sunIrradiance * (cosAbove / cosBelow);
}
