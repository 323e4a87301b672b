// Boulders, stones on the bed and the sunken trunk, each where it lies: world space, so that they carry the
// wet band at the water line and the shade of the ground.
#pragma once

#include "lake_shape.h"
#include "mesh.h"
#include "terrain.h"
#include "views.h"

namespace tarn::lake {

struct Boulder {
    vec3 centre;
    vec3 radii;
    float turn;
    int levels = 2;    ///< of icoSphere
    bool crag = false; ///< a block of the cliff, with sharp edges
};

/// Where boulders lie. Hand-placed ones by the cameras first, then a scatter by kind of shore.
std::vector<Boulder> placeBoulders(const LakeShape& shape, const std::vector<View>& views, Random random);
Mesh makeBoulders(const std::vector<Boulder>& boulders, const LakeShape& shape, std::uint32_t seed);

Mesh makeStones(const LakeShape& shape, Random random);

/// A fallen spruce on the slope from the shelf to the deep.
Mesh makeSunkenTrunk(const LakeShape& shape, Random random);

} // namespace tarn::lake
