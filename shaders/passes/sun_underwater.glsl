// The sun's light on a point under water. Needs blocks.glsl, refraction.glsl, with SHADOWS or CAUSTICS sunlight.glsl, and
// with SHADOWS sun_maps.glsl.
#ifdef CAUSTICS
#include "shared/caustics.glsl"

uniform sampler2D causticsMap;
#endif

// Irradiance on a surface that faces the refracted sun: from the caustics map where it reaches, and that under flat water
// elsewhere. Photons are shadowed by what stands over the water already.
// across, along: from this point to that of the next pixel, m. positionError: distance that the point may be from the true
// bed, m.
vec3 sunUnderwater(vec3 point, vec3 across, vec3 along, float positionError)
{
    vec3 sun = sunBelow * beerLambert(absorption, (waterLevel - point.y) / max(sunDirectionBelow.y, 0.05));
#if defined(SHADOWS) || defined(CAUSTICS)
    vec2 shear = sunShear(sunDirectionBelow);
    vec2 plane = sunPlane(point, waterLevel, shear);
#endif
    float causticsFraction = 0.0;
#ifdef CAUSTICS
    causticsFraction = causticsFade(plane, causticsRect, waterRect, causticsBorder.x, causticsBorder.y);
#endif
#ifdef SHADOWS
    vec2 gradient = sunPlaneGradient(cross(across, along), shear);
    float height = point.y + positionError * (1.0 + length(gradient));
    float visible = sunVisibility(submergedLayer, sunRect, plane, height, gradient, sunBiases.x);
    if (causticsFraction < 1.0) sun *= sunVisibility(firstCascadeLayer, sunRect, plane, height, gradient, sunBiases.x);
#endif
#ifdef CAUSTICS
    // From the map's centre, with the scale of the derivatives.
    vec3 relative = textureGrad(causticsMap, sunMapUvDifference(causticsRect, plane - causticsRect.xy) + 0.5,
                                sunMapUvDifference(causticsRect, sunPlane(across, 0.0, shear)),
                                sunMapUvDifference(causticsRect, sunPlane(along, 0.0, shear))).rgb;
    sun = mix(sun, causticsIrradiance(relative, sunIrradiance, sunDirection.y, sunDirectionBelow.y), causticsFraction);
#endif
#ifdef SHADOWS
    sun *= visible;
#endif
    return sun;
}
