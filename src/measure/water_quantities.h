// What the real-time frame used in each pixel of its water: the numbers that a reference's are held against.
//
//     const WaterQuantities used = readQuantities(renderer, camera, 1.5, reference.size);
//     const ErrorFigures figures = errorFigures(used, reference); // measure/water_errors.h
#pragma once

#include "render/renderer.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace tarn {

/// How much a texel of the refraction target covers across the line of sight.
struct TexelFootprint {
    vec3 eye{0.0f};            ///< of the refraction target's camera, world
    double edgePerMetre = 0.0; ///< of the longer edge of a texel in the target's middle
    double edge = 0.0;         ///< m, that of a map seen from far above, whatever the distance

    /// Metres, at a point of the world.
    double at(const vec3& point) const;
};

/// Rows run from top to bottom, like Image. Positions are in world space, m. All but the pictures are of the ray
/// through the pixel's centre, and zero where the pixel shows no water.
struct WaterQuantities {
    ivec2 size{0};
    vec3 eye{0.0f};
    std::vector<std::uint8_t> isWater;    ///< 0 or 1
    std::vector<vec3> surface;            ///< U
    std::vector<vec3> position;           ///< W: where the lookup takes the refracted ray's hit to be
    std::vector<vec3> picture;            ///< A: the point whose colour it takes for W's
    std::vector<std::uint8_t> hasSample;  ///< 1 where the target holds something at W's pixel
    std::vector<vec3> mirrored;           ///< the point that the reflection shows, or the direction of its sky
    std::vector<std::uint8_t> mirrorsSky; ///< 1 where it is the direction
    bool reflects = true;                 ///< water.reflects: else nothing is mirrored, and no error of it is known
    std::vector<float> fresnel;
    std::vector<float> waterPath; ///< m: |A - U|, or from the eye to U when that is under water
    TexelFootprint footprint;
    std::optional<CausticsMap> caustics; ///< nothing when the frame had none
    std::optional<HeightField> heights;  ///< what refracted rays were marched through; nothing by other methods
    Image display, linear;               ///< the final picture, as Renderer::readDisplay and readLinear give it

    WaterQuantities() = default;
    explicit WaterQuantities(ivec2 pictureSize);
    std::size_t pixels() const { return isWater.size(); }
};

/// Renders the frame once for each of the debug views, and as it is. Leaves that last one in the renderer. Throws Error
/// when that draws for two eyes: each has quantities of its own.
WaterQuantities readQuantities(Renderer& renderer, const Camera& camera, double time, ivec2 size);

} // namespace tarn
