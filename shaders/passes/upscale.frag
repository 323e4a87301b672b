// A picture from one that was drawn smaller (frame.scale, frame.upscaler).
//
// EDGE: by a kernel that follows edges, shared/upscale.glsl; else bilinear. LINEAR: the source is radiance, which is
// filtered as 0 to 1 and brought back.
#include "shared/upscale.glsl"

uniform sampler2D source;
uniform vec2 sourcePerPixel; // texels of the source for one pixel of the picture
#ifdef LINEAR
uniform float exposure; // makes radiance relative to the display's white, so that edges are those that are seen
uniform int sideBySide; // pictures, 1 or 2, that do not mix at their seam
#endif

out vec4 fragment;

ivec2 lowest, highest; // texels that belong to this pixel's picture

vec3 texelAt(ivec2 at)
{
    vec3 value = texelFetch(source, clamp(at, lowest, highest), 0).rgb;
#ifdef LINEAR
    value = compressedRadiance(exposure * max(value, vec3(0.0)));
#endif
    return value;
}

void main()
{
    lowest = ivec2(0);
    highest = textureSize(source, 0) - 1;
    vec2 at = gl_FragCoord.xy * sourcePerPixel - 0.5; // in texels, of whose centres each is a whole number
#ifdef LINEAR
    int width = (highest.x + 1) / sideBySide;
    lowest.x = int(gl_FragCoord.x * sourcePerPixel.x) / width * width;
    highest.x = lowest.x + width - 1;
#endif
    vec2 base = floor(at);
    ivec2 b = ivec2(base);
    UpscaleTexels t;
    t.c00 = texelAt(b);
    t.c10 = texelAt(b + ivec2(1, 0));
    t.c01 = texelAt(b + ivec2(0, 1));
    t.c11 = texelAt(b + ivec2(1, 1));
#ifdef EDGE
    t.below0 = texelAt(b + ivec2(0, -1));
    t.below1 = texelAt(b + ivec2(1, -1));
    t.left0 = texelAt(b + ivec2(-1, 0));
    t.left1 = texelAt(b + ivec2(-1, 1));
    t.right0 = texelAt(b + ivec2(2, 0));
    t.right1 = texelAt(b + ivec2(2, 1));
    t.above0 = texelAt(b + ivec2(0, 2));
    t.above1 = texelAt(b + ivec2(1, 2));
    vec3 colour = edgeUpscaled(t, at - base);
#else
    vec3 colour = bilinearUpscaled(t, at - base);
#endif
#ifdef LINEAR
    colour = expandedRadiance(colour) / exposure;
#endif
    fragment = vec4(colour, 1.0);
}
