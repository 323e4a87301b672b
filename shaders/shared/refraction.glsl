// Snell, Fresnel and Beer-Lambert: what a smooth water surface does to a ray.
//
// Directions are unit vectors in any one space. Radiance and irradiance are linear RGB.
//
// Differences from the text of Mihálik 2008:
// - Its shaders use the ratio 0.75 (n = 1.333) where the text says n = 1.33. Here the index of refraction is always
//   a parameter, and the ratio n1/n2 is computed from it.
// - Its listing in section 9.1 mixes `newrefrcol + F * (newreflcol - refrcol)`; equation 9 has the attenuated colour
//   in both places, and only that conserves energy: mix(newrefrcol, reflcol, F).
// - Equation 11 (the test for total internal reflection) lacks a square: 1 - n²(1 - (N·E)²) < 0.

// The refracted direction (Mihálik 2008, eq. 2; the vector form of Snell's law).
// incident: unit, the way the light goes; normal: unit, on the side that the ray comes from; eta: n1 / n2.
// vec3(0) under total internal reflection.
SHARED vec3 refractRay(vec3 incident, vec3 normal, float eta)
{
    float cosIncident = dot(normal, incident); // negative
    float k = 1.0 - eta * eta * (1.0 - cosIncident * cosIncident);
    if (k < 0.0) return vec3(0.0);
    return eta * incident - (eta * cosIncident + sqrt(k)) * normal;
}

// How Mihálik 2008, eq. 12, bends the ray from an eye under water: right to first order about the normal, of no
// particular length, and without total internal reflection.
// toEye: E, unit, from the surface; normal: N, unit, up out of the water.
SHARED vec3 refractRayOfPaper(vec3 toEye, vec3 normal, float ior)
{
    return ior * (-normal - toEye) + normal;
}

// The mirrored direction. The sign of the normal does not matter.
SHARED vec3 reflectRay(vec3 incident, vec3 normal)
{
    return incident - 2.0 * dot(normal, incident) * normal;
}

// Reflectance of unpolarised light, exact for a dielectric (Fresnel 1823).
// cosIncident: 0..1 between the normal and the ray, on the side that the light comes from; eta: n1 / n2.
// 1 under total internal reflection.
SHARED float fresnelExact(float cosIncident, float eta)
{
    // Interpolated normals can give a cosine a little outside 0..1.
    float cosI = clamp(cosIncident, 0.0, 1.0);
    float sin2T = eta * eta * (1.0 - cosI * cosI);
    // sin2T = 1 is the critical angle itself; leaving there keeps both divisors below positive.
    if (sin2T >= 1.0) return 1.0;
    float cosT = sqrt(1.0 - sin2T);
    float s = (eta * cosI - cosT) / (eta * cosI + cosT);
    float p = (cosI - eta * cosT) / (cosI + eta * cosT);
    return 0.5 * (s * s + p * p);
}

// Reflectance by Schlick 1994, as Mihálik 2008, eqs. 7 and 8, write it. Only for light from the air side.
// q: exponent, 5 in Schlick's paper. Must be positive: 0 to the power 0 is undefined in GLSL.
SHARED float fresnelSchlick(float cosTheta, float ior, float q)
{
    float r = (ior - 1.0) / (ior + 1.0);
    float f = r * r;
    return f + (1.0 - f) * pow(1.0 - clamp(cosTheta, 0.0, 1.0), q);
}

// The share of radiance that a path of `metres` in the water lets through (Mihálik 2008, eq. 4, per channel).
// absorption: 1/m. A path that comes out negative from rounding counts as none.
SHARED vec3 beerLambert(vec3 absorption, float metres)
{
    return exp(-absorption * max(metres, 0.0));
}

// Radiance after a stretch of water that glows with the radiance of infinitely deep water (Mihálik 2008, eqs. 5, 10).
// attenuation: beerLambert of the stretch.
SHARED vec3 radianceThroughWater(vec3 radiance, vec3 deepRadiance, vec3 attenuation)
{
    return deepRadiance + attenuation * (radiance - deepRadiance);
}

// Factor on radiance that leaves the water: the beam spreads to n² times its solid angle, so that L/n² is what a
// surface conserves (Nicodemus 1963). Light that enters is multiplied by transmittance · n² instead.
SHARED float radianceThroughSurface(float transmittance, float ior)
{
    return transmittance / (ior * ior);
}
