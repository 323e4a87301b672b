// The light of sun and sky as everything in Tarn sees it: the viewer bakes it, the reference samples it.
#pragma once

#include "scene/scene.h"

#include <array>

namespace tarn {

/// The sky of a scene, made ready for evaluation.
/// Daylight: Preetham, Shirley & Smits 1999, luminance and chromaticity, converted to linear sRGB primaries.
class SkyModel {
public:
    explicit SkyModel(const Scene& scene);

    /// Radiance from a direction, without the sun's disc. `direction` is unit, towards the sky, world space.
    vec3 radiance(const vec3& direction) const;

    /// Irradiance of the sun on a surface facing it, above the water (0 without a sun or below the horizon).
    vec3 sunIrradiance() const { return sunIrradiance_; }
    vec3 sunDirection() const { return sunDirection_; }
    /// Radiance of the sun's disc, irradiance / its solid angle (angular radius 0.2665°).
    vec3 sunDiscRadiance() const;

    /// Irradiance of the sky on a surface of a given normal, from nine spherical-harmonic coefficients
    /// (Ramamoorthi & Hanrahan 2001), already convolved with the cosine and scaled by Sky::lighting:
    /// E(n) = Σ c_i · basis_i(n) with the basis of shaders/shared/lighting.glsl. Exact for a constant sky.
    const std::array<vec3, 9>& irradianceCoefficients() const { return coefficients_; }
    vec3 irradiance(const vec3& normal) const;

private:
    void prepareDaylight();
    void prepareIrradiance();
    vec3 daylight(const vec3& direction) const;
    vec3 picture(const vec3& direction) const;

    Sky sky_;
    Image picture_;
    vec3 sunDirection_{0.0f, 1.0f, 0.0f};
    vec3 sunIrradiance_{0.0f};
    vec3 groundRadiance_{0.0f};
    std::array<vec3, 9> coefficients_{};
    struct Perez {
        float zenith;
        std::array<float, 5> c;
        float normaliser;
    };
    std::array<Perez, 3> perez_{}; ///< Y, x, y
};

} // namespace tarn
