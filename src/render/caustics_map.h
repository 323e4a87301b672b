// The caustics texture on the processor's side.
#pragma once

#include "render/sun_views.h"

#include <vector>

namespace tarn {

/// The caustics texture and where it lies: what shaders/passes/scene.frag knows of it.
struct CausticsMap {
    CausticsRegion region;   ///< rows from its least z, columns from its least x
    int resolution = 0;      ///< texels
    std::vector<vec3> light; ///< irradiance relative to the sun's above the water, both through a level area
    LevelRect water;         ///< beside it no light enters
    float level = 0.0f;      ///< of the plane that both lie on, m
    vec3 toSun{0.0f};        ///< towards the sun under water: the light of a point crosses the plane along it
};

} // namespace tarn
