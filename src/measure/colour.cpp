#include "measure/colour.h"

#include <cmath>

namespace tarn {

namespace {

using glm::dmat3;
using glm::dvec3;

/// X, Y, Z of luminance 1 at a chromaticity.
dvec3 tristimulus(double x, double y) { return {x / y, 1.0, (1.0 - x - y) / y}; }

dmat3 deriveRelativeFromRgb()
{
    // IEC 61966-2-1, table 1: the primaries and D65.
    const dmat3 primaries(tristimulus(0.64, 0.33), tristimulus(0.30, 0.60), tristimulus(0.15, 0.06));
    const dvec3 white = tristimulus(0.3127, 0.3290);
    const dvec3 luminances = glm::inverse(primaries) * white; // of the primaries that add up to white
    dmat3 result;
    for (int primary = 0; primary < 3; ++primary) result[primary] = primaries[primary] * luminances[primary] / white;
    return result;
}

// Where CIELAB's cube root gives way to a straight line, so that its slope stays finite at black.
constexpr float kneeRoot = 6.0f / 29.0f;
constexpr float kneeSlope = 3.0f * kneeRoot * kneeRoot;
constexpr float kneeOffset = 4.0f / 29.0f;

float labRoot(float t) { return t > kneeRoot * kneeRoot * kneeRoot ? std::cbrt(t) : t / kneeSlope + kneeOffset; }

float labCube(float root) { return root > kneeRoot ? root * root * root : kneeSlope * (root - kneeOffset); }

} // namespace

const mat3& relativeFromRgb()
{
    static const mat3 matrix(deriveRelativeFromRgb());
    return matrix;
}

const mat3& rgbFromRelative()
{
    static const mat3 matrix(glm::inverse(deriveRelativeFromRgb()));
    return matrix;
}

vec3 labFromRelative(const vec3& relative)
{
    const float x = labRoot(relative.x), y = labRoot(relative.y), z = labRoot(relative.z);
    return {116.0f * y - 16.0f, 500.0f * (x - y), 200.0f * (y - z)};
}

vec3 relativeFromLab(const vec3& lab)
{
    const float y = (lab.x + 16.0f) / 116.0f;
    return {labCube(y + lab.y / 500.0f), labCube(y), labCube(y - lab.z / 200.0f)};
}

} // namespace tarn
