// Spreads the highlight over the two diagonals (shared/blur.glsl).
#include "shared/blur.glsl"

uniform sampler2D source;

out vec4 fragment;

void main()
{
    ivec2 cell = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(source, 0) - 1;
    vec3 sum = vec3(0.0);
    for (int k = -glowReach; k <= glowReach; ++k) {
        sum += glowWeight(k, k) * texelFetch(source, clamp(cell + ivec2(k, k), ivec2(0), last), 0).rgb;
        if (k != 0) sum += glowWeight(k, -k) * texelFetch(source, clamp(cell + ivec2(k, -k), ivec2(0), last), 0).rgb;
    }
    fragment = vec4(sum, 1.0);
}
