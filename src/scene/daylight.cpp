#include "scene/daylight.h"

#include <algorithm>
#include <cmath>

namespace tarn::daylight {

namespace {

constexpr float angularRadius = 0.2665f; // of the sun's disc, degrees

float elevationDegrees(float sinElevation) { return glm::degrees(std::asin(std::clamp(sinElevation, -1.0f, 1.0f))); }

} // namespace

std::array<std::array<float, 5>, 3> perezCoefficients(float turbidity)
{
    const float T = turbidity;
    return {{{0.1787f * T - 1.4630f, -0.3554f * T + 0.4275f, -0.0227f * T + 5.3251f, 0.1206f * T - 2.5771f,
              -0.0670f * T + 0.3703f},
             {-0.0193f * T - 0.2592f, -0.0665f * T + 0.0008f, -0.0004f * T + 0.2125f, -0.0641f * T - 0.8989f,
              -0.0033f * T + 0.0452f},
             {-0.0167f * T - 0.2608f, -0.0950f * T + 0.0092f, -0.0079f * T + 0.2102f, -0.0441f * T - 1.6537f,
              -0.0109f * T + 0.0529f}}};
}

vec3 zenith(float turbidity, float sunZenithAngle)
{
    const float T = turbidity, theta = sunZenithAngle;
    const float chi = (4.0f / 9.0f - T / 120.0f) * (pi - 2.0f * theta);
    const float luminance = (4.0453f * T - 4.9710f) * std::tan(chi) - 0.2155f * T + 2.4192f;

    const vec4 powers(theta * theta * theta, theta * theta, theta, 1.0f);
    const vec3 turbidities(T * T, T, 1.0f);
    const vec3 x(glm::dot(powers, vec4(0.00166f, -0.00375f, 0.00209f, 0.0f)),
                 glm::dot(powers, vec4(-0.02903f, 0.06377f, -0.03202f, 0.00394f)),
                 glm::dot(powers, vec4(0.11693f, -0.21196f, 0.06052f, 0.25886f)));
    const vec3 y(glm::dot(powers, vec4(0.00275f, -0.00610f, 0.00317f, 0.0f)),
                 glm::dot(powers, vec4(-0.04214f, 0.08970f, -0.04153f, 0.00516f)),
                 glm::dot(powers, vec4(0.15346f, -0.26756f, 0.06670f, 0.26688f)));
    return {std::max(luminance, 0.0f), glm::dot(turbidities, x), glm::dot(turbidities, y)};
}

float perez(const std::array<float, 5>& c, float cosTheta, float gamma)
{
    const float cosGamma = std::cos(gamma);
    return (1.0f + c[0] * std::exp(c[1] / cosTheta)) *
           (1.0f + c[2] * std::exp(c[3] * gamma) + c[4] * cosGamma * cosGamma);
}

vec3 rgbFromxyY(float x, float y, float Y)
{
    const float safeY = std::max(y, 1e-4f); // chromaticities far outside the model's range
    const vec3 xyz(x / safeY * Y, Y, (1.0f - x - y) / safeY * Y);
    // IEC 61966-2-1: XYZ (D65) to linear sRGB.
    const vec3 rgb(3.2406f * xyz.x - 1.5372f * xyz.y - 0.4986f * xyz.z,
                   -0.9689f * xyz.x + 1.8758f * xyz.y + 0.0415f * xyz.z,
                   0.0557f * xyz.x - 0.2040f * xyz.y + 1.0570f * xyz.z);
    return glm::max(rgb, vec3(0.0f));
}

vec3 sunIrradiance(float turbidity, float sinElevation)
{
    const float visible = discAboveHorizon(sinElevation);
    if (visible <= 0.0f) return vec3(0.0f);

    // Illuminance above the atmosphere 128 klx, with the chromaticity of a black body of 5778 K.
    const vec3 extraterrestrial = 128.0f * vec3(1.113f, 0.975f, 0.912f);
    // One wavelength (µm) stands for each primary; ozone's coefficients there in 1/cm. Water vapour and the
    // mixed gases absorb beyond 0.69 µm, which the eye hardly sees.
    const vec3 wavelength(0.610f, 0.550f, 0.465f);
    const vec3 ozone(0.120f, 0.085f, 0.008f);
    constexpr float ozoneColumn = 0.35f; // cm
    const float angstromBeta = std::max(0.04608f * turbidity - 0.04586f, 0.0f);

    const float zenithDegrees = 90.0f - elevationDegrees(sinElevation);
    const float airMass = 1.0f / (std::max(sinElevation, 0.0f) + 0.15f * std::pow(93.885f - zenithDegrees, -1.253f));
    const vec3 depth = 0.008735f * glm::pow(wavelength, vec3(-4.08f)) +
                       angstromBeta * glm::pow(wavelength, vec3(-1.3f)) + ozone * ozoneColumn;
    return visible * extraterrestrial * glm::exp(-depth * airMass);
}

float discAboveHorizon(float sinElevation)
{
    return glm::smoothstep(-angularRadius, angularRadius, elevationDegrees(sinElevation));
}

float twilight(float sinElevation)
{
    // Preetham's model ends at the horizon. From there illuminance falls from some 700 lx to 3 lx at the end
    // of civil twilight (-6°), about e^-0.9 per degree, down to a moonless sky that is never quite black.
    const float elevation = elevationDegrees(sinElevation);
    return elevation >= 0.0f ? 1.0f : std::max(std::exp(0.9f * elevation), 1e-6f);
}

} // namespace tarn::daylight
