#include "reference/light.h"

#include <algorithm>
#include <cmath>

namespace tarn::reference {

namespace {

std::vector<blocks::LightTerm> punctualLightsOf(const Scene& scene)
{
    std::vector<blocks::LightTerm> punctualLights;
    for (const PointLight& light : scene.pointLights)
        punctualLights.push_back({light.position, 1.0f, light.intensity, -2.0f, vec3(0.0f, -1.0f, 0.0f), 0.0f});
    for (const SpotLight& light : scene.spotLights)
        punctualLights.push_back({light.position, std::cos(light.innerAngle), light.intensity,
                                  std::cos(light.outerAngle), light.direction, 0.0f});
    // The viewer has room for so many, and says which it leaves out.
    if (punctualLights.size() > static_cast<std::size_t>(blocks::maxLights)) punctualLights.resize(blocks::maxLights);
    return punctualLights;
}

bool transmits(const Material& material) { return material.alphaTested && material.transmission != vec3(0.0f); }

} // namespace

Light::Light(const Scene& scene, const WaterBody& water)
    : sky(scene), hasWater(water.present), ior(water.ior), level(water.level), absorption(water.absorption),
      sunDirection(sky.sunDirection()), sunIrradiance(sky.sunIrradiance()), punctualLights(punctualLightsOf(scene))
{
    const vec3 up(0.0f, 1.0f, 0.0f);
    sunDirectionBelow = optics::refractedSunDirection(sunDirection, ior);
    sunBelow = optics::sunIrradianceBelow(sunIrradiance, sunDirection.y, ior);
    skyBelow = optics::skyIrradianceBelow(sky.irradiance(up));
    deepRadiance = optics::deepWaterRadiance(water.colour, sunBelow * sunDirectionBelow.y, skyBelow);
    for (std::size_t i = 0; i < 9; ++i) skyIrradiance[i] = vec4(sky.irradianceCoefficients()[i], 0.0f);
}

vec3 litBy(const Material& material, const vec3& albedo, const vec3& normal, const vec3& toEye, const vec3& toLight,
           const vec3& irradiance)
{
    const float along = glm::dot(normal, toLight);
    const float cosine = std::max(along, 0.0f);
    vec3 radiance = albedo / pi * cosine * irradiance;
    if (transmits(material)) radiance += albedo * material.transmission / pi * std::max(-along, 0.0f) * irradiance;
    if (material.specular != vec3(0.0f)) {
        const vec3 between = toLight + toEye;
        const float length = glm::length(between);
        const float cosHalf = length > 0.0f ? std::max(glm::dot(normal, between / length), 0.0f) : 0.0f;
        radiance += material.specular * irradiance * cosine * optics::blinnPhong(cosHalf, material.shininess);
    }
    return radiance;
}

vec3 litByPunctualLights(const Light& light, const Material& material, const vec3& albedo, const vec3& position,
                         const vec3& normal, const vec3& toEye)
{
    vec3 radiance(0.0f);
    for (const blocks::LightTerm& source : light.punctualLights) {
        const vec3 toLight = source.position - position;
        const float distance2 = std::max(glm::dot(toLight, toLight), 1.0e-6f);
        const vec3 direction = toLight / std::sqrt(distance2);
        const float cone = source.cosOuter < -1.5f ? 1.0f
                                                   : glm::smoothstep(source.cosOuter, source.cosInner,
                                                                     glm::dot(-direction, source.direction));
        radiance += litBy(material, albedo, normal, toEye, direction, source.intensity * (cone / distance2));
    }
    return radiance;
}

} // namespace tarn::reference
