// The mean of what was drawn over the area of one pixel of the picture (frame.scale above 1). TAPS texels across and up hold
// that area, the outer ones in part if the scale is no whole number.
#include "shared/upscale.glsl"

uniform sampler2D drawn;
uniform vec2 drawnPerPixel; // at least 1

out vec4 fragment;

void main()
{
    vec2 lower = floor(gl_FragCoord.xy) * drawnPerPixel, upper = lower + drawnPerPixel;
    ivec2 first = ivec2(lower), last = textureSize(drawn, 0) - 1;
    vec4 sum = vec4(0.0);
    for (int y = 0; y < TAPS; ++y) {
        for (int x = 0; x < TAPS; ++x) {
            ivec2 at = first + ivec2(x, y);
            float weight = overlap(lower.x, upper.x, float(at.x)) * overlap(lower.y, upper.y, float(at.y));
            sum += weight * texelFetch(drawn, min(at, last), 0);
        }
    }
    fragment = sum / (drawnPerPixel.x * drawnPerPixel.y);
}
