// Transmitted and mirrored fractions at the surface from above, by the method of the option water.fresnel. Needs blocks.glsl
// and refraction.glsl.
#include "shared/fresnel_table.glsl"

uniform float schlickExponent; // q of eq. 7
#ifdef FRESNEL_TABLE
uniform sampler2D fresnelTable; // FRESNEL_TABLE: whether its texels are blended
#endif

// The fractions of light that pass the surface and that are mirrored.
vec2 fresnelFractions(float cosine)
{
#ifdef FRESNEL_TABLE
    float uv = fresnelTableCoordinate(cosine, textureSize(fresnelTable, 0).x, FRESNEL_TABLE);
    return textureLod(fresnelTable, vec2(uv, 0.5), 0.0).rg;
#else
#ifdef EXACT_FRESNEL
    float f = fresnelExact(cosine, 1.0 / ior);
#else
    float f = fresnelSchlick(cosine, ior, schlickExponent);
#endif
    return vec2(1.0 - f, f);
#endif
}
