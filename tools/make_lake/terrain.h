// The ground as one mesh: fine along the shore, coarse on the hills, and the mountains behind it all.
#pragma once

#include "lake_shape.h"
#include "mesh.h"

#include <vector>

namespace tarn::lake {

/// Something standing on the ground that keeps the sky from it.
struct Shade {
    vec2 centre;
    float radius;
    float strength; ///< 0 to 1: how much of the sky it takes at its centre
};

Mesh makeTerrain(const LakeShape& shape, const std::vector<Shade>& shades, std::uint32_t seed);

/// A ring of far mountains from behind the hills outward.
Mesh makeMountains(std::uint32_t seed);

} // namespace tarn::lake
