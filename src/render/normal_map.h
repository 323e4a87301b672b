// The water's normal map on the GPU: shaders/shared/normal_map.glsl, read by shaders/passes/water_surface.glsl.
#pragma once

#include "gl/program.h"
#include "gl/texture.h"
#include "scene/scene.h"

#include <array>

namespace tarn {

/// RGB: normals, -1..1; A: half the square of their slope. Mip levels hold the means, from which the shader knows how
/// much slope they have lost (Olano & Baker 2010, LEAN mapping).
gl::Texture normalMapTexture(const Image& image, float anisotropy);

/// What a program with NORMAL_MAP needs for a frame.
struct NormalMapInputs {
    const gl::Texture* map = nullptr; ///< null: no ripples
    float tile = 1.0f;                ///< m
    float bump = 1.0f;
    std::array<vec2, 4> offsets{}; ///< of the layers

    explicit operator bool() const { return map != nullptr; }
    void set(gl::Program& program) const;
};

/// @param map null where the scene has none
NormalMapInputs normalMapInputs(const WaterBody& water, const gl::Texture* map, double time);

} // namespace tarn
