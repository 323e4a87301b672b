// From linear light to the display. Inputs are linear RGB after exposure; tone curves give linear 0..1.

// Beyond this a float's square overflows in toneAces, and every curve is at its end long before: half float's maximum.
const float toneLargest = 65504.0;

SHARED vec3 toneLinear(vec3 colour)
{
    return clamp(colour, vec3(0.0), vec3(1.0));
}

// Reinhard et al. 2002, eq. 3, per channel.
SHARED vec3 toneReinhard(vec3 colour)
{
    vec3 c = clamp(colour, vec3(0.0), vec3(toneLargest));
    return c / (vec3(1.0) + c);
}

// Narkowicz 2015: a rational fit of the Academy's ACES reference rendering for sRGB displays.
SHARED vec3 toneAces(vec3 colour)
{
    vec3 c = clamp(colour, vec3(0.0), vec3(toneLargest));
    vec3 curve = c * (2.51 * c + vec3(0.03)) / (c * (2.43 * c + vec3(0.59)) + vec3(0.14));
    return clamp(curve, vec3(0.0), vec3(1.0));
}

// sRGB (IEC 61966-2-1) of a linear 0..1 value.
SHARED float srgbFromLinear(float value)
{
    float v = clamp(value, 0.0, 1.0);
    return v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1.0 / 2.4) - 0.055;
}

// Linear value of an sRGB 0..1 value.
SHARED float linearFromSrgb(float value)
{
    float v = clamp(value, 0.0, 1.0);
    return v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
}

SHARED vec3 srgbColour(vec3 c)
{
    return vec3(srgbFromLinear(c.x), srgbFromLinear(c.y), srgbFromLinear(c.z));
}

SHARED vec3 linearColour(vec3 c)
{
    return vec3(linearFromSrgb(c.x), linearFromSrgb(c.y), linearFromSrgb(c.z));
}
