// The light of the scene as the viewer defines it (src/render/frame_light.cpp makes the same numbers for the GPU).
#pragma once

#include "optics/optics.h"
#include "scene/sky.h"

#include <array>
#include <vector>

namespace tarn::reference {

struct Light {
    SkyModel sky;
    bool hasWater;
    float ior;
    float level;
    vec3 absorption;
    vec3 sunDirection;                 ///< towards the middle of the sun
    vec3 sunIrradiance;                ///< facing it, above the water
    vec3 sunDirectionBelow;            ///< towards it from under flat water
    vec3 sunBelow;                     ///< irradiance just under flat water, facing the refracted sun
    vec3 skyBelow;                     ///< irradiance of the sky on an upward surface just under flat water
    vec3 deepRadiance;                 ///< radiance inside infinitely deep water
    std::array<vec4, 9> skyIrradiance; ///< spherical harmonics
    std::vector<blocks::LightTerm> punctualLights;

    /// @param water hasWater is its `present`
    Light(const Scene& scene, const WaterBody& water);

    bool hasSun() const { return sunDirection.y > 0.0f && sunIrradiance != vec3(0.0f); }
    vec3 skyOn(const vec3& normal) const { return optics::shIrradiance(skyIrradiance.data(), normal); }
};

/// Irradiance and glossy reflection of a source as scene.frag's `lit` has it.
/// @param toLight,toEye unit   @param irradiance on a surface that faces the light
vec3 litBy(const Material& material, const vec3& albedo, const vec3& normal, const vec3& toEye, const vec3& toLight,
           const vec3& irradiance);

/// Radiance that the scene's point and spot lights give a point; like the viewer's, their light goes through
/// everything.
vec3 litByPunctualLights(const Light& light, const Material& material, const vec3& albedo, const vec3& position,
                         const vec3& normal, const vec3& toEye);

} // namespace tarn::reference
