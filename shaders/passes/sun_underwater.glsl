// The sun's light on a point under water. Needs blocks.glsl, refraction.glsl, with SHADOWS or CAUSTICS sunlight.glsl, and
// with SHADOWS sun_maps.glsl.
#ifdef CAUSTICS
#include "shared/caustics.glsl"

uniform sampler2D causticsMap;
#endif

// Irradiance on a surface that faces the refracted sun: what waves gather where the caustics texture knows it, and what a
// flat surface lets through elsewhere. Photons carry the shadows of what stands over the water with them.
// across, along: from this point to that of the next pixel, m. offBy: how far from the true bed the point may be, m.
vec3 sunUnderwater(vec3 point, vec3 across, vec3 along, float offBy)
{
    vec3 sun = sunBelow * beerLambert(absorption, (waterLevel - point.y) / max(sunDirectionBelow.y, 0.05));
#if defined(SHADOWS) || defined(CAUSTICS)
    vec2 shear = sunShear(sunDirectionBelow);
    vec2 plane = sunPlane(point, waterLevel, shear);
#endif
    float fromTexture = 0.0;
#ifdef CAUSTICS
    fromTexture = causticsFade(plane, causticsRect, waterRect, causticsBorder.x, causticsBorder.y);
#endif
#ifdef SHADOWS
    vec2 gradient = sunPlaneGradient(cross(across, along), shear);
    float height = point.y + offBy * (1.0 + length(gradient));
    float visible = sunVisibility(submergedLayer, sunRect, plane, height, gradient, sunBiases.x);
    if (fromTexture < 1.0) sun *= sunVisibility(firstCascadeLayer, sunRect, plane, height, gradient, sunBiases.x);
#endif
#ifdef CAUSTICS
    // From the map's centre, with the scale of the derivatives.
    vec3 relative = textureGrad(causticsMap, sunMapUvDifference(causticsRect, plane - causticsRect.xy) + 0.5,
                                sunMapUvDifference(causticsRect, sunPlane(across, 0.0, shear)),
                                sunMapUvDifference(causticsRect, sunPlane(along, 0.0, shear))).rgb;
    sun = mix(sun, causticsIrradiance(relative, sunIrradiance, sunDirection.y, sunDirectionBelow.y), fromTexture);
#endif
#ifdef SHADOWS
    sun *= visible;
#endif
    return sun;
}
