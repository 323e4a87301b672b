// The camera that the refraction target is rendered from (Mihálik 2008, section 5.1, equations 1 and 2).
//
// Rays bend towards the normal as they enter the water, so that the main camera's frustum is not the part of
// the bed that is seen. The published remedy: take the ray along the middle of the frustum's bottom plane,
// its point O on the water, and turn the whole camera about O by the angle between that ray and its
// refraction. The turned camera's bottom ray then passes through O along the refracted ray. Everything in
// world space; metres, radians.
#pragma once

#include "base/math.h"

namespace tarn::optics {

struct RefractionCamera {
    vec3 eye;
    vec3 forward; ///< unit
    vec3 up;      ///< unit, perpendicular to forward
    vec3 pivot;   ///< O; the eye where nothing was turned
    float angle;  ///< that the camera was turned by; 0 where it was not
};

/// The turned camera. It is the main one, unturned, where the construction has no answer or none is needed:
/// - the eye is not above the water;
/// - the bottom ray does not fall (the camera looks up), or so little that O lies more than 10,000 times the
/// eye's
///   height away: no water is then in view, or only what is at the horizon;
/// - the bottom ray points straight down, where refraction does not turn it.
///
/// @param forward      unit
/// @param up           need not be perpendicular to forward, but must not be parallel to it
/// @param verticalFov  of the main camera, without extension
/// @param ior          of the water, relative to air
RefractionCamera refractionCamera(const vec3& eye, const vec3& forward, const vec3& up, float verticalFov, float level,
                                  float ior);

/// Factor on the tangents of a moved camera's field of view. The text gives two values, 1.5 "near the water"
/// and 1.2 "farther from it"; here `near` holds up to 1 m and `far` from 10 m of the eye's height, smoothly
/// in its logarithm between them (a step would pop as the camera rises).
/// @param height  of the eye above the level; the sign does not matter
float fovExtension(float height, float near, float far);

} // namespace tarn::optics
