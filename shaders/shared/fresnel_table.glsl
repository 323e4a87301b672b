// Fresnel's reflectance looked up in a table over the cosine of incidence (Lipp, shader documentation of "Physically
// Correct perturbed planar Refractions & Reflections in Real Time", section 2). src/optics/fresnel_table.h fills it.
//
// Two ways to read it. Nearest texel, as published: each texel stands for the middle of its part of 0..1, which halves
// the error of standing for an end. Blended texels: the first and the last stand for 0 and 1 themselves, so that
// nothing is held constant at the ends, of which grazing incidence is the steepest.

// The cosine that a texel stands for.
SHARED float fresnelTableCosine(int texel, int size, bool blends)
{
    if (blends) return float(texel) / float(size - 1);
    return (float(texel) + 0.5) / float(size);
}

// Texture coordinate of a cosine: the texels' centres are at (i + 0.5) / size.
SHARED float fresnelTableCoordinate(float cosine, int size, bool blends)
{
    float c = clamp(cosine, 0.0, 1.0);
    if (blends) return (c * float(size - 1) + 0.5) / float(size);
    return c;
}
