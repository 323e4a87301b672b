// The sun's light on a point under water. Needs blocks.glsl, refraction.glsl and, with SHADOWS or CAUSTICS,
// sunlight.glsl and sun_maps.glsl.
#ifdef CAUSTICS
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
    // No waves, and so no photons, beside the water's rectangle: what is lit from there sees a flat surface.
    vec2 fromEdge = min(causticsRect.zw - abs(plane - causticsRect.xy), waterRect.zw - abs(plane - waterRect.xy));
    float inside = min(fromEdge.x, fromEdge.y);
    fromTexture = clamp(inside / max(causticsBorder.x, 2.0 * causticsBorder.y), 0.0, 1.0);
#endif
#ifdef SHADOWS
    vec2 gradient = sunPlaneGradient(cross(across, along), shear);
    float height = point.y + offBy * (1.0 + length(gradient));
    float visible = sunVisibility(submergedLayer, sunRect, plane, height, gradient, sunBiases.x);
    if (fromTexture < 1.0) sun *= sunVisibility(firstCascadeLayer, sunRect, plane, height, gradient, sunBiases.x);
#endif
#ifdef CAUSTICS
    // The texture holds light through a level area relative to the same above the water.
    vec2 scale = 0.5 / causticsRect.zw;
    vec3 light = textureGrad(causticsMap, (plane - causticsRect.xy) * scale + 0.5,
                             sunPlane(across, 0.0, shear) * scale, sunPlane(along, 0.0, shear) * scale).rgb;
    sun = mix(sun, light * sunIrradiance * (sunDirection.y / sunDirectionBelow.y), fromTexture);
#endif
#ifdef SHADOWS
    sun *= visible;
#endif
    return sun;
}
