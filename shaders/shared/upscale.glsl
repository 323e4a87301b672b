// A picture from one that was drawn with fewer or more pixels (frame.scale).
//
// Fewer: AMD FidelityFX Super Resolution 1.0 (Lottes 2021, "EASU", edge-adaptive spatial upsampling), from its published
// description. Twelve texels about a pixel, the corners of a 4x4 square left away, are weighted by a window like Lanczos'.
// Where the picture has an edge the window is turned along it, made longer along it and narrower across it. The
// result stays between the darkest and the lightest of the four nearest texels, so that nothing rings. Values are those
// of the display, sRGB: what counts is the contrast that an eye sees.
//
// More: the mean over the area of a pixel.

// How bright a texel is, up to a factor: what edges are found in.
SHARED float upscaleLuma(vec3 colour)
{
    return colour.y + 0.5 * (colour.x + colour.z);
}

// Along one axis: 1 where the neighbours of a texel differ by as much as the larger of its two steps or more (a slope, a
// step), 0 where they are alike (a line of one texel, noise); squared.
SHARED float edgeStrength(float before, float here, float after)
{
    float steepest = max(abs(after - here), abs(here - before));
    float strength = clamp(abs(after - before) / max(steepest, 1.0e-5), 0.0, 1.0);
    return strength * strength;
}

// What one of the four nearest texels tells of the edge: its gradient in x and y, and in z the sum of both axes' strengths.
// All add up with bilinear weights.
SHARED vec3 edgeAt(float here, float left, float right, float below, float above)
{
    return vec3(right - left, above - below, edgeStrength(left, here, right) + edgeStrength(below, here, above));
}

// The window: the direction across the edge, how much an offset across and along it counts, and the depth of its negative
// lobe.
struct EdgeWindow {
    vec2 across;
    vec2 scale;
    float lobe;
};

// Of the sum of four edgeAt. A flat picture has no direction, and any will do.
SHARED EdgeWindow edgeWindow(vec3 edge)
{
    float squared = dot(vec2(edge.x, edge.y), vec2(edge.x, edge.y));
    EdgeWindow window;
    window.across = squared < 1.0 / 32768.0 ? vec2(1.0, 0.0) : vec2(edge.x, edge.y) / sqrt(max(squared, 1.0e-9));
    float strength = 0.5 * edge.z;
    strength = strength * strength;
    // A diagonal's texels are √2 apart.
    float stretch = 1.0 / max(abs(window.across.x), abs(window.across.y));
    window.scale = vec2(1.0 + (stretch - 1.0) * strength, 1.0 - 0.5 * strength);
    // 1/4 is Lanczos' window of two lobes; 1/2 ends after √2 texels and has hardly a negative lobe: noise stays soft.
    window.lobe = 0.5 - 0.29 * strength;
    return window;
}

// Weight of a texel at an offset from the pixel, in texels; not yet normalised. A product of two polynomials that come near
// Lanczos' window without sine or root: (25/16 (2/5 x² - 1)² - 9/16) (w x² - 1)², and 0 from where w x² is 1.
SHARED float edgeWeight(EdgeWindow window, vec2 offset)
{
    float across = dot(offset, window.across) * window.scale.x;
    float along = dot(offset, vec2(-window.across.y, window.across.x)) * window.scale.y;
    float squared = min(across * across + along * along, 1.0 / window.lobe);
    float base = 0.4 * squared - 1.0;
    float cut = window.lobe * squared - 1.0;
    return (1.5625 * base * base - 0.5625) * (cut * cut);
}

// The four texels about a pixel (c, by x and y), and their eight nearest neighbours.
struct UpscaleTexels {
    vec3 c00, c10, c01, c11;
    vec3 below0, below1, above0, above1; // of c00 and c10, of c01 and c11
    vec3 left0, left1, right0, right1;   // of c00 and c01, of c10 and c11
};

// Weights of the four texels in the order of their names. fraction: position of the pixel between them, 0 to 1
SHARED vec4 bilinearWeights(vec2 fraction)
{
    vec2 rest = vec2(1.0) - fraction;
    return vec4(rest.x * rest.y, fraction.x * rest.y, rest.x * fraction.y, fraction.x * fraction.y);
}

SHARED vec3 bilinearUpscaled(UpscaleTexels t, vec2 fraction)
{
    vec4 w = bilinearWeights(fraction);
    return w.x * t.c00 + w.y * t.c10 + w.z * t.c01 + w.w * t.c11;
}

// The edge that the four texels tell of together.
SHARED vec3 edgeAmong(UpscaleTexels t, vec2 fraction)
{
    float l00 = upscaleLuma(t.c00), l10 = upscaleLuma(t.c10), l01 = upscaleLuma(t.c01), l11 = upscaleLuma(t.c11);
    vec4 w = bilinearWeights(fraction);
    return w.x * edgeAt(l00, upscaleLuma(t.left0), l10, upscaleLuma(t.below0), l01) +
           w.y * edgeAt(l10, l00, upscaleLuma(t.right0), upscaleLuma(t.below1), l11) +
           w.z * edgeAt(l01, upscaleLuma(t.left1), l11, l00, upscaleLuma(t.above0)) +
           w.w * edgeAt(l11, l01, upscaleLuma(t.right1), l10, upscaleLuma(t.above1));
}

// Weighted texels: colours and weights, and their mean position relative to the pixel.
struct UpscaleSum {
    vec4 colours;
    vec2 offsets;
};

SHARED UpscaleSum withTexel(UpscaleSum sum, EdgeWindow window, vec3 colour, vec2 offset)
{
    float weight = edgeWeight(window, offset);
    sum.colours += weight * vec4(colour, 1.0);
    sum.offsets += weight * offset;
    return sum;
}

// The published filter is exact for a constant; the last term makes it so for what is linear, too: where the mean position of
// the texels is not the pixel, the colour is taken back by as much as it changes over that distance.
SHARED vec3 edgeUpscaled(UpscaleTexels t, vec2 fraction)
{
    EdgeWindow window = edgeWindow(edgeAmong(t, fraction));
    vec2 to = vec2(0.0) - fraction; // from the pixel to c00
    UpscaleSum sum;
    sum.colours = vec4(0.0);
    sum.offsets = vec2(0.0);
    sum = withTexel(sum, window, t.c00, to);
    sum = withTexel(sum, window, t.c10, to + vec2(1.0, 0.0));
    sum = withTexel(sum, window, t.c01, to + vec2(0.0, 1.0));
    sum = withTexel(sum, window, t.c11, to + vec2(1.0, 1.0));
    sum = withTexel(sum, window, t.below0, to + vec2(0.0, -1.0));
    sum = withTexel(sum, window, t.below1, to + vec2(1.0, -1.0));
    sum = withTexel(sum, window, t.left0, to + vec2(-1.0, 0.0));
    sum = withTexel(sum, window, t.left1, to + vec2(-1.0, 1.0));
    sum = withTexel(sum, window, t.right0, to + vec2(2.0, 0.0));
    sum = withTexel(sum, window, t.right1, to + vec2(2.0, 1.0));
    sum = withTexel(sum, window, t.above0, to + vec2(0.0, 2.0));
    sum = withTexel(sum, window, t.above1, to + vec2(1.0, 2.0));
    vec2 meanOffset = sum.offsets / sum.colours.w;
    vec3 right = mix(t.c10 - t.c00, t.c11 - t.c01, fraction.y);
    vec3 up = mix(t.c01 - t.c00, t.c11 - t.c10, fraction.x);
    vec3 colour = vec3(sum.colours) / sum.colours.w - meanOffset.x * right - meanOffset.y * up;
    vec3 darkest = min(min(t.c00, t.c10), min(t.c01, t.c11));
    vec3 lightest = max(max(t.c00, t.c10), max(t.c01, t.c11));
    return clamp(colour, darkest, lightest);
}

// Radiance as 0 to 1, for a picture that has not gone through the tone curve: no texel outshines all others (Karis 2013,
// "Tone mapping"). colour: exposed, not negative.
SHARED vec3 compressedRadiance(vec3 colour)
{
    return colour / (1.0 + max(colour.x, max(colour.y, colour.z)));
}

SHARED vec3 expandedRadiance(vec3 compressed)
{
    return compressed / max(1.0 - max(compressed.x, max(compressed.y, compressed.z)), 1.0 / 65504.0);
}

// How much of the texel from `texel` to `texel` + 1 lies between two ends, 0 to 1: its weight in a mean over an area.
SHARED float overlap(float lower, float upper, float texel)
{
    return clamp(min(upper, texel + 1.0) - max(lower, texel), 0.0, 1.0);
}
