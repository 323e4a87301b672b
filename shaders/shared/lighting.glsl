// Light on surfaces, in the water and off the water. Needs refraction.glsl.
//
// World space, y up. Radiance in kcd/m², irradiance in klx, linear RGB. All directions are unit vectors, those named
// `to…` point away from the surface.

const float lightPi = 3.14159265358979324;

// Diffuse transmittance of flat water (n = 1.33) for a uniform sky: 1 minus the cosine-weighted mean of Fresnel's
// reflectance, 0.066.
const float diffuseTransmittance = 0.934;

// Mean of 1/cos over the refracted sky, weighted with the irradiance it brings: 2 / (1 + cos 48.75°) for n = 1.33.
const float skyPathFactor = 1.2;

// --- The sky ---------------------------------------------------------------------------------------------------

// Spherical harmonics to order 2 without their constants, which the coefficients hold (Ramamoorthi & Hanrahan 2001).
SHARED float shBasis(int i, vec3 n)
{
    if (i == 0) return 1.0;
    if (i == 1) return n.y;
    if (i == 2) return n.z;
    if (i == 3) return n.x;
    if (i == 4) return n.x * n.y;
    if (i == 5) return n.y * n.z;
    if (i == 6) return 3.0 * n.z * n.z - 1.0;
    if (i == 7) return n.x * n.z;
    return n.x * n.x - n.y * n.y;
}

// Irradiance of the sky on a surface with normal n. c: coefficients already convolved with the cosine, xyz each.
// Order 2 can dip below zero opposite a bright spot; no light is the least there is.
SHARED vec3 shIrradiance(const vec4 c[9], vec3 n)
{
    vec3 sum = vec3(c[0]) + vec3(c[1]) * n.y + vec3(c[2]) * n.z + vec3(c[3]) * n.x + vec3(c[4]) * (n.x * n.y) +
               vec3(c[5]) * (n.y * n.z) + vec3(c[6]) * (3.0 * n.z * n.z - 1.0) + vec3(c[7]) * (n.x * n.z) +
               vec3(c[8]) * (n.x * n.x - n.y * n.y);
    return max(sum, vec3(0.0));
}

// Irradiance of the sky on an upward surface just under flat water. skyUp: the same just above it.
SHARED vec3 skyIrradianceBelow(vec3 skyUp)
{
    return diffuseTransmittance * skyUp;
}

// Irradiance of the sky on a surface `depth` metres under the water level. skyBelow: skyIrradianceBelow.
// An approximation: diffuse light falls off along its mean path, and a tilted surface sees a part of the bright
// upper hemisphere and of the dark lower one.
SHARED vec3 skyIrradianceAtDepth(vec3 skyBelow, vec3 absorption, float depth, vec3 n)
{
    return skyBelow * beerLambert(absorption, skyPathFactor * depth) * (0.5 + 0.5 * n.y);
}

// --- The sun in the water --------------------------------------------------------------------------------------

// Towards the sun as seen from under flat water. A sun below the horizon is taken to stand on it.
SHARED vec3 refractedSunDirection(vec3 toSun, float ior)
{
    float horizontal = length(vec2(toSun.x, toSun.z));
    float sinAir = toSun.y > 0.0 ? horizontal : 1.0;
    float sinWater = sinAir / ior;
    // Straight up there is no azimuth; the floor only keeps 0 / 0 away.
    vec2 azimuth = vec2(toSun.x, toSun.z) / max(horizontal, 1.0e-20);
    return vec3(azimuth.x * sinWater, sqrt(max(1.0 - sinWater * sinWater, 0.0)), azimuth.y * sinWater);
}

// Irradiance of the sun just under flat water on a surface that faces the refracted sun:
// E · T · cos(air) / cos(water). The beam narrows as it bends: the flux through a patch of surface stays, less F.
SHARED vec3 sunIrradianceBelow(vec3 sunIrradiance, float cosAir, float ior)
{
    if (cosAir <= 0.0) return vec3(0.0);
    float cosWater = sqrt(max(1.0 - (1.0 - cosAir * cosAir) / (ior * ior), 0.0));
    // Only n = 1 with the sun on the horizon gives a zero; the cosines' ratio is 1 there and F is 1.
    if (cosWater <= 0.0) return vec3(0.0);
    return sunIrradiance * ((1.0 - fresnelExact(cosAir, 1.0 / ior)) * cosAir / cosWater);
}

// Radiance inside infinitely deep water. colour: its diffuse reflectance; the rest: irradiance on a level surface
// just under the water, of the sun (sunIrradianceBelow · cos(water)) and of the sky (skyIrradianceBelow).
SHARED vec3 deepWaterRadiance(vec3 colour, vec3 sunDownwelling, vec3 skyDownwelling)
{
    return colour * (sunDownwelling + skyDownwelling) / lightPi;
}

// --- Highlights ------------------------------------------------------------------------------------------------

// Blinn-Phong lobe, a BRDF in 1/sr to be multiplied with Ks, normalised so that Ks is the reflectance for light that
// falls straight on (Giesen 2009); the usual (n + 8) / 8π is up to 7 % too bright.
// cosHalf: between the normal and the half vector.
SHARED float blinnPhong(float cosHalf, float shininess)
{
    float n = max(shininess, 0.0);
    float norm = (n + 2.0) * (n + 4.0) / (8.0 * lightPi * (n + exp2(-0.5 * n)));
    // GLSL leaves 0 to the power 0 undefined.
    return norm * pow(max(cosHalf, 1.0e-6), n);
}

// Variance of the slope, per axis, that the sun's disc (angular radius 0.2666°) alone gives a mirror: a uniform disc
// of radius r has variance r²/4 per axis, and a facet turns by half the angle. Keeps calm water's glint as wide as the
// sun and the lobe below finite.
const float sunDiscVariance = 1.35e-6;

// Solid angle of the disc, sr. No mirror, rough or smooth, shows it brighter than irradiance over this; the disc as
// slopes would at grazing angles, where a lobe of slopes is squeezed and a mirrored disc is not.
const float sunSolidAngle = 6.8e-5;

// cos · Lambda of Smith's masking for a Beckmann surface, rational fit by Walter et al. 2007 (eq. 15 there, as
// 1/G1 - 1). Multiplied by the cosine because Lambda alone is infinite at grazing angles.
// alpha: sqrt(2 · slope variance).
SHARED float smithCosLambda(float cosTheta, float alpha)
{
    float alphaSin = alpha * sqrt(max(1.0 - cosTheta * cosTheta, 0.0));
    // From here on Lambda is below the fit's error. Also catches sin = 0.
    if (cosTheta >= 1.6 * alphaSin) return 0.0;
    float a = cosTheta / alphaSin;
    return alphaSin * (1.0 - 1.259 * a + 0.396 * a * a) / (3.535 + 2.181 * a);
}

// Radiance of the sun mirrored by waves too small to model (Cook & Torrance 1982 with Beckmann's distribution of
// slopes, as Ross et al. 2005 use it for the sea; masking height-correlated, Heitz 2014).
// irradiance: of the sun on a surface facing it; fresnel: reflectance at the half vector; normal: of the modelled
// waves; slopeVariance: per axis, of the rest.
// Integrates to the mirror's reflectance over the directions of the sun, and stays finite at grazing angles: the
// usual division by the eye's cosine is contained in eyeTerm, which is at least alpha / 3.535 there.
SHARED vec3 sunGlint(vec3 irradiance, float fresnel, vec3 normal, vec3 toEye, vec3 toSun, float slopeVariance)
{
    float cosSun = dot(normal, toSun);
    if (cosSun <= 0.0) return vec3(0.0);
    // A wave's shading normal can turn away from the eye where its silhouette is coarser than its normals.
    float cosEye = max(dot(normal, toEye), 0.0);
    float variance = slopeVariance + sunDiscVariance;
    float alpha = sqrt(2.0 * variance);

    vec3 between = toEye + toSun;
    // An eye straight behind the surface has no half vector; below this the length is rounding error.
    if (dot(between, between) < 1.0e-8) return vec3(0.0);
    between = normalize(between);
    float cosHalf = dot(normal, between);
    // A facet this close to upright (a slope of 10,000) is no wave, and soon cos2 * cos2 would underflow to zero.
    if (cosHalf <= 1.0e-4) return vec3(0.0);
    // The sine from the cross product: 1 - cos² has no digits left where the lobe is narrow.
    vec3 sine = cross(normal, between);
    float cos2 = cosHalf * cosHalf;
    float slopes = exp(-0.5 * dot(sine, sine) / (cos2 * variance)) / (2.0 * lightPi * variance * cos2 * cos2);

    float eyeTerm = cosEye + smithCosLambda(cosEye, alpha);
    float masking = cosSun * eyeTerm + cosEye * smithCosLambda(cosSun, alpha);
    return irradiance * (fresnel * min(slopes * cosSun / (4.0 * masking), 1.0 / sunSolidAngle));
}

// Lipp's highlight of the sun (shader documentation, section 2): Phong's lobe about the mirrored light, with a strength,
// added to what the surface mirrors.
//
// Not on the honest scale. Lipp's light has a colour of the screen's 0..1, where 1 is what a white wall in the light
// shows; here that is the radiance of a white diffuse surface that faces the sun, irradiance / pi. The lobe keeps no
// energy: a larger exponent makes it narrower and not brighter, and the width has nothing to do with the waves.
// fresnel: reflectance of the surface; normal: of the waves, unsteepened; exponent: > 0.
SHARED vec3 phongGlint(vec3 irradiance, float fresnel, vec3 normal, vec3 toEye, vec3 toSun, float exponent, float strength)
{
    if (dot(normal, toSun) <= 0.0) return vec3(0.0);
    vec3 mirrored = reflectRay(-toSun, normal);
    // GLSL leaves 0 to a power undefined.
    float lobe = pow(clamp(dot(mirrored, toEye), 1.0e-6, 1.0), exponent);
    return irradiance * (fresnel * strength * lobe / lightPi);
}
