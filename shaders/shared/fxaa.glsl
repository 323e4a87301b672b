// Fast approximate anti-aliasing: edges are found in the shown picture and blended along their run (Lottes 2009, "FXAA",
// NVIDIA; the steps are those of its version 3.11, 2011, quality). Values are those of the display, sRGB, 0 to 1.

const float fxaaLeastContrast = 0.0625;     // what no eye sees in the dark
const float fxaaRelativeContrast = 0.166;   // of the brightest neighbour
const float fxaaSubpixelStrength = 0.25;    // how much of what is smaller than a pixel is taken away: foliage is, docs/scale.md
const int fxaaSteps = 6;                    // of the search, in either direction

// Perceived brightness of a displayed colour (Rec. 601).
SHARED float fxaaLuma(vec3 colour)
{
    return dot(colour, vec3(0.299, 0.587, 0.114));
}

// How far a step of the search goes on, texels: ever farther, since a long edge needs less precision.
SHARED float fxaaStride(int step)
{
    return step < 1 ? 1.0 : step < 2 ? 1.5 : step < 4 ? 2.0 : step < 5 ? 4.0 : 8.0;
}

// Whether neighbours differ enough to smooth at all.
SHARED bool fxaaIsEdge(float darkest, float brightest)
{
    return brightest - darkest >= max(fxaaLeastContrast, fxaaRelativeContrast * brightest);
}

// How much a pixel stands out from its neighbours, as an offset of its sample towards them, texels: 0 on an edge of two even
// sides, up to fxaaSubpixelStrength for a lone pixel.
// sides, corners: sums of four   range: between the darkest and the brightest of the pixel and its sides
SHARED float fxaaSubpixelShift(float here, float sides, float corners, float range)
{
    float mean = (2.0 * sides + corners) / 12.0;
    float part = clamp(abs(mean - here) / max(range, 1.0e-5), 0.0, 1.0);
    float smoothed = part * part * (3.0 - 2.0 * part);
    return fxaaSubpixelStrength * smoothed * smoothed;
}

// Whether an edge runs across the picture rather than up: which second differences are larger. Rows from above to below.
SHARED bool fxaaRunsAcross(vec3 above, vec3 middle, vec3 below)
{
    float across = abs(above.x - 2.0 * middle.x + below.x) + 2.0 * abs(above.y - 2.0 * middle.y + below.y) +
                   abs(above.z - 2.0 * middle.z + below.z);
    float up = abs(above.x - 2.0 * above.y + above.z) + 2.0 * abs(middle.x - 2.0 * middle.y + middle.z) +
               abs(below.x - 2.0 * below.y + below.z);
    return across >= up;
}

// Offset of the sample across the edge, texels: a half at the end of its run, nothing in the middle. Only the pixels on the
// side that the step at the nearer end cuts into are moved.
// back, on: distances to the ends of the run, texels   isCut: the nearer end is such a step
SHARED float fxaaEdgeShift(float back, float on, bool isCut)
{
    return isCut ? 0.5 - min(back, on) / max(back + on, 1.0e-5) : 0.0;
}
