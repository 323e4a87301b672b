#include "scene/sky.h"

#include "scene/daylight.h"
#include "scene/sky_picture.h"

#include <algorithm>
#include <cmath>

namespace tarn {

namespace {

constexpr float sunAngularRadius = 0.2665f * pi / 180.0f;

/// The basis of shaders/shared/lighting.glsl: real spherical harmonics of order 2 without their constants,
/// which the coefficients hold.
std::array<float, 9> basis(const vec3& n)
{
    return {1.0f, n.y, n.z, n.x, n.x * n.y, n.y * n.z, 3.0f * n.z * n.z - 1.0f, n.x * n.z, n.x * n.x - n.y * n.y};
}

/// What turns ∫ L(ω) basis_i(ω) dω into the coefficient of irradiance: the squared constant of the harmonic,
/// times the cosine lobe's π, 2π/3, π/4 for its band (Ramamoorthi & Hanrahan 2001, eq. 8).
std::array<float, 9> convolution()
{
    const float band0 = pi / (4.0f * pi);
    const float band1 = 2.0f * pi / 3.0f * 3.0f / (4.0f * pi);
    const float mixed = pi / 4.0f * 15.0f / (4.0f * pi);
    const float zonal = pi / 4.0f * 5.0f / (16.0f * pi);
    const float square = pi / 4.0f * 15.0f / (16.0f * pi);
    return {band0, band1, band1, band1, mixed, mixed, zonal, mixed, square};
}

/// Calls visit(direction, solid angle) for cells of equal solid angle that cover the sphere, or its upper
/// half.
template <typename Visit> void overSphere(int rows, bool upperHalf, Visit visit)
{
    const int columns = 2 * rows;
    const float lowest = upperHalf ? 0.0f : -1.0f;
    const float solidAngle = 2.0f * pi * (1.0f - lowest) / static_cast<float>(rows * columns);
    for (int row = 0; row < rows; ++row) {
        const float y = lowest + (1.0f - lowest) * (static_cast<float>(row) + 0.5f) / static_cast<float>(rows);
        const float radius = std::sqrt(1.0f - y * y);
        for (int column = 0; column < columns; ++column) {
            const float angle = 2.0f * pi * (static_cast<float>(column) + 0.5f) / static_cast<float>(columns);
            visit(vec3(radius * std::cos(angle), y, radius * std::sin(angle)), solidAngle);
        }
    }
}

/// The direction itself, or the nearest one on the horizon.
vec3 notBelowHorizon(const vec3& direction)
{
    if (direction.y >= 0.0f) return direction;
    const vec3 level(direction.x, 0.0f, direction.z);
    const float length = glm::length(level);
    return length > 1e-6f ? level / length : vec3(1.0f, 0.0f, 0.0f);
}

} // namespace

SkyModel::SkyModel(const Scene& scene) : sky_(scene.sky)
{
    if (scene.sun) {
        sunDirection_ = glm::normalize(scene.sun->direction);
        sunIrradiance_ = scene.sun->automatic ? daylight::sunIrradiance(sky_.turbidity, sunDirection_.y)
                                              : scene.sun->irradiance * daylight::discAboveHorizon(sunDirection_.y);
    }
    if (sky_.kind == Sky::Kind::picture && sky_.image != noImage)
        picture_ = linearPicture(scene.images.at(static_cast<std::size_t>(sky_.image)));
    if (sky_.kind == Sky::Kind::daylight) prepareDaylight();
    prepareIrradiance();
}

void SkyModel::prepareDaylight()
{
    const float sunZenith = std::acos(std::clamp(notBelowHorizon(sunDirection_).y, 0.0f, 1.0f));
    const auto coefficients = daylight::perezCoefficients(sky_.turbidity);
    const vec3 zenith = daylight::zenith(sky_.turbidity, sunZenith);
    for (std::size_t i = 0; i < 3; ++i) {
        perez_[i].c = coefficients[i];
        perez_[i].zenith = zenith[static_cast<int>(i)];
        perez_[i].normaliser = daylight::perez(coefficients[i], 1.0f, sunZenith);
    }
    perez_[0].zenith *= daylight::twilight(sunDirection_.y);

    vec3 skyIrradiance(0.0f);
    overSphere(64, true, [&](const vec3& direction, float solidAngle) {
        skyIrradiance += daylight(direction) * direction.y * solidAngle;
    });
    const vec3 received = skyIrradiance + sunIrradiance_ * std::max(sunDirection_.y, 0.0f);
    groundRadiance_ = sky_.groundAlbedo / pi * received;
}

void SkyModel::prepareIrradiance()
{
    coefficients_ = {};
    if (sky_.kind == Sky::Kind::constant) {
        coefficients_[0] = pi * sky_.radiance * sky_.lighting;
        return;
    }
    // A picture may hold lights of a few pixels; its own resolution finds them.
    const int rows = sky_.kind == Sky::Kind::picture ? std::clamp(picture_.height, 64, 1024) : 96;
    overSphere(rows, false, [&](const vec3& direction, float solidAngle) {
        const vec3 flux = radiance(direction) * solidAngle;
        const auto values = basis(direction);
        for (std::size_t i = 0; i < 9; ++i) coefficients_[i] += flux * values[i];
    });
    const auto factors = convolution();
    for (std::size_t i = 0; i < 9; ++i) coefficients_[i] *= factors[i] * sky_.lighting;
}

vec3 SkyModel::radiance(const vec3& direction) const
{
    switch (sky_.kind) {
    case Sky::Kind::constant: return sky_.radiance;
    case Sky::Kind::picture: return picture(direction);
    case Sky::Kind::daylight: break;
    }
    // The ground begins softly over the first degree and a half, as haze does it.
    const float ground = glm::smoothstep(0.0f, std::sin(glm::radians(1.5f)), -direction.y);
    if (ground >= 1.0f) return groundRadiance_;
    return glm::mix(daylight(direction), groundRadiance_, ground);
}

vec3 SkyModel::daylight(const vec3& direction) const
{
    // At the horizon itself the model divides by zero; half a degree above it, it has settled.
    const float cosTheta = std::max(direction.y, 0.01f);
    const float gamma = std::acos(std::clamp(glm::dot(direction, notBelowHorizon(sunDirection_)), -1.0f, 1.0f));
    vec3 Yxy;
    for (std::size_t i = 0; i < 3; ++i)
        Yxy[static_cast<int>(i)] =
            perez_[i].zenith * daylight::perez(perez_[i].c, cosTheta, gamma) / perez_[i].normaliser;
    return daylight::rgbFromxyY(Yxy.y, Yxy.z, std::max(Yxy.x, 0.0f));
}

vec3 SkyModel::picture(const vec3& direction) const
{
    if (picture_.floats.empty()) return sky_.radiance; // the picture was missing; a warning has said so
    const float c = std::cos(sky_.rotation), s = std::sin(sky_.rotation);
    const vec3 turned(c * direction.x - s * direction.z, direction.y, s * direction.x + c * direction.z);
    return sky_.radiance * samplePicture(picture_, turned);
}

vec3 SkyModel::sunDiscRadiance() const
{
    // 2π (1 − cos r), without the difference of nearly equal numbers.
    const float half = std::sin(0.5f * sunAngularRadius);
    const float solidAngle = 4.0f * pi * half * half;
    return sunIrradiance_ / solidAngle;
}

vec3 SkyModel::irradiance(const vec3& normal) const
{
    const auto values = basis(normal);
    vec3 sum(0.0f);
    for (std::size_t i = 0; i < 9; ++i) sum += coefficients_[i] * values[i];
    return glm::max(sum, vec3(0.0f)); // nine terms can ring below zero beside a strong light
}

} // namespace tarn
