// From linear radiance to the display: exposure, tone curve, sRGB. Debug views are given colours that a person can read.
// DISPLAY: which.
#include "shared/debug_views.glsl"
#include "shared/tonemap.glsl"
#ifdef LUMA
#include "shared/fxaa.glsl"
#endif

in vec2 uv;

uniform sampler2D hdrColour;
uniform float exposure;
#ifdef GLOW
uniform sampler2D glowColour;
#endif

out vec4 fragment;

vec3 heat(float x) // black, blue, green, yellow, white over 0 to 1
{
    x = clamp(x, 0.0, 1.0) * 4.0;
    return vec3(smoothstep(2.0, 3.0, x), smoothstep(1.0, 2.0, x), smoothstep(0.0, 1.0, x) - smoothstep(1.0, 2.0, x) +
                                                                      smoothstep(3.0, 4.0, x));
}

void main()
{
    vec4 value = texture(hdrColour, uv);
#if DISPLAY == DISPLAY_RADIANCE
    vec3 exposed = value.rgb * exposure;
#ifdef GLOW
    exposed += texture(glowColour, uv).rgb; // an effect of the lens, on the display's scale
#endif
    vec3 mapped = TONE_CURVE(exposed);
#elif DISPLAY == DISPLAY_LENGTH // more than ten metres are bright
    vec3 mapped = heat(value.r / (value.r + 10.0)) * value.a;
#elif DISPLAY == DISPLAY_POSITION // one cycle of colour a metre, there and back so that no rounding shows
    vec3 mapped = value.a > 1.5 ? 0.5 * value.rgb + 0.5 : abs(2.0 * fract(value.rgb) - 1.0) * value.a;
#elif DISPLAY == DISPLAY_DIRECTION
    vec3 mapped = (0.5 * value.rgb + 0.5) * value.a;
#elif DISPLAY == DISPLAY_RELATIVE // 1 is half grey
    vec3 mapped = value.rgb / (value.rgb + 1.0) * value.a;
#elif DISPLAY == DISPLAY_FRACTION
    vec3 mapped = clamp(value.rrr, 0.0, 1.0) * value.a;
#else
#error present.frag has no colours for this display
#endif
#if DISPLAY == DISPLAY_RADIANCE
    fragment = vec4(srgbColour(mapped), 1.0);
#ifdef LUMA // for fxaa.frag
    fragment.a = fxaaLuma(fragment.rgb);
#endif
#else
    fragment = vec4(mapped, 1.0);
#endif
}
