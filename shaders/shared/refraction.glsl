// Snell, Fresnel and Beer-Lambert: what a smooth water surface does to a ray.
//
// Directions are unit vectors in any one space. Radiance and irradiance are linear RGB.
//
// Differences from the text of Mihálik 2008:
// - Its shaders use the ratio 0.75 (n = 1.333) where the text says n = 1.33. Here the index of refraction is always
//   a parameter, and the ratio n1/n2 is computed from it.
// - Its listing in section 9.1 mixes `newrefrcol + F * (newreflcol - refrcol)`; equation 9 has the attenuated colour
//   in both terms, and only that conserves energy: mix(newrefrcol, reflcol, F).
// - Equation 11 (the test for total internal reflection) lacks a square: 1 - n²(1 - (N·E)²) < 0.

// The refracted direction (Mihálik 2008, eq. 2; the vector form of Snell's law).
// incident: unit, the direction in which the light travels; normal: unit, on the side that the ray comes from; eta: n1 / n2.
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

// The fraction of radiance that a path of `metres` in the water transmits (Mihálik 2008, eq. 4, per channel).
// absorption: 1/m. A path that comes out negative from rounding counts as none.
SHARED vec3 beerLambert(vec3 absorption, float metres)
{
    return exp(-absorption * max(metres, 0.0));
}

// Lipp's attenuation (shader documentation, section 2): transmittance falls in proportion to the path, alike for all
// colours, to none at `fade` metres. fade: > 0.
SHARED float linearAttenuation(float metres, float fade)
{
    return 1.0 - clamp(metres / fade, 0.0, 1.0);
}

// Radiance after a stretch of water that glows with the radiance of infinitely deep water (Mihálik 2008, eqs. 5, 10).
// attenuation: beerLambert or linearAttenuation of the stretch.
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

// --- What an eye over flat water sees ------------------------------------------------------------------------------

// Horizontal distance that a ray from the eye to a point under flat water covers in the water.
// eyeHeight: h over the surface; depth: d under it; across: r, horizontal; m.
//
// With u the tangent of the ray's angle in the air, Snell's law makes it h u + d u / sqrt(n² + (n² - 1) u²) = r. The left
// side rises and is concave, so that Newton's method climbs to the root from any start below it; both starts are such,
// one close where the view is steep, the other where it is flat.
SHARED float flatSidestep(float eyeHeight, float depth, float across, float ior)
{
    float excess = ior * ior - 1.0;
    float u = across / (eyeHeight + depth / ior);
    if (excess > 1.0e-6) u = max(u, (across - depth / sqrt(excess)) / eyeHeight);
    for (int i = 0; i < 5; ++i) {
        float root2 = ior * ior + excess * u * u;
        float root = sqrt(root2);
        float slope = eyeHeight + depth * ior * ior / (root2 * root);
        u += (across - eyeHeight * u - depth * u / root) / slope;
    }
    return depth * u / sqrt(ior * ior + excess * u * u);
}

// The apparent position of a point under flat water: in the direction from which its light reaches the eye, at the distance
// that the light has travelled. Occlusion is preserved, since a bent ray becomes one straight line with the order of its
// points kept. Points above the water keep their position. World space; the eye must be above the water level.
SHARED vec3 flatApparent(vec3 eye, vec3 point, float waterLevel, float ior)
{
    float depth = waterLevel - point.y;
    float eyeHeight = max(eye.y - waterLevel, 1.0e-3);
    if (depth <= 0.0) return point;
    vec2 away = vec2(point.x - eye.x, point.z - eye.z);
    float across = length(away);
    float sidestep = flatSidestep(eyeHeight, depth, across, ior);
    float x = across - sidestep;
    vec2 side = away / max(across, 1.0e-6);
    vec3 toSurface = vec3(side.x * x, -eyeHeight, side.y * x);
    float inAir = length(toSurface);
    float inWater = sqrt(sidestep * sidestep + depth * depth);
    return eye + toSurface * ((inAir + inWater) / inAir);
}

// The inverse: the point whose apparent position is this.
SHARED vec3 flatTrue(vec3 eye, vec3 apparent, float waterLevel, float ior)
{
    if (apparent.y >= waterLevel) return apparent;
    float eyeHeight = max(eye.y - waterLevel, 1.0e-3);
    vec3 toApparent = apparent - eye;
    float far = length(toApparent);
    vec3 direction = toApparent / far;
    float inAir = eyeHeight / max(-direction.y, 1.0e-7);
    vec3 bent = refractRay(direction, vec3(0.0, 1.0, 0.0), 1.0 / ior);
    return eye + inAir * direction + max(far - inAir, 0.0) * bent;
}
