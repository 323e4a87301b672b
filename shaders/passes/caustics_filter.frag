// Smooths the caustics texture without loss (shared/sunlight.glsl).
#include "shared/sunlight.glsl"

uniform sampler2D source;
uniform int radius;

out vec4 fragment;

void main()
{
    ivec2 cell = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(source, 0) - 1;
    vec3 sum = vec3(0.0);
    for (int j = -radius; j <= radius; ++j)
        for (int i = -radius; i <= radius; ++i)
            sum += causticsFilterWeight(radius, i) * causticsFilterWeight(radius, j) *
                   texelFetch(source, clamp(cell + ivec2(i, j), ivec2(0), last), 0).rgb;
    fragment = vec4(sum, 1.0);
}
