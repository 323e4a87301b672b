// Smooths the caustics map along one axis, without loss (shared/caustics.glsl): the filter is the product of two.
// AXIS: ivec2(1, 0) or ivec2(0, 1); EACH_TAP: the cells from -RADIUS to RADIUS, counted from 0.
#include "shared/refraction.glsl"
#include "shared/caustics.glsl"

uniform sampler2D source;

out vec4 fragment;

vec3 tap(ivec2 cell, ivec2 last, int offset)
{
    return causticsFilterWeight(RADIUS, offset) * texelFetch(source, clamp(cell + offset * AXIS, ivec2(0), last), 0).rgb;
}

void main()
{
    ivec2 cell = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(source, 0) - 1;
    vec3 sum = vec3(0.0);
#define TAP(i) sum += tap(cell, last, i - RADIUS);
    EACH_TAP
#undef TAP
    fragment = vec4(sum, 1.0);
}
