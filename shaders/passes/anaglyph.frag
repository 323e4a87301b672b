// Both eyes' displayed pictures, which lie side by side, as one anaglyph.
#include "shared/tonemap.glsl"
#include "shared/anaglyph.glsl"

uniform sampler2D beside; // sRGB, the left eye in the left half

out vec4 fragment;

vec3 lightAt(ivec2 cell) { return linearColour(texelFetch(beside, cell, 0).rgb); }

void main()
{
    ivec2 cell = ivec2(gl_FragCoord.xy);
    int width = textureSize(beside, 0).x / 2;
    vec3 both = anaglyphRedCyan(lightAt(cell), lightAt(cell + ivec2(width, 0)));
    fragment = vec4(srgbColour(both), 1.0);
}
