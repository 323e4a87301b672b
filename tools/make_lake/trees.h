// Trees as models of their own: foot at the origin, y up. Wood is solid, foliage is clusters of cut-out cards
// whose normals point out of the crown, so that it is shaded as one soft body; the inside is baked dark.
#pragma once

#include "canvas.h"
#include "mesh.h"
#include "textures.h"

namespace tarn::lake {

struct SpruceShape {
    float height = 13.0f;
    float spread = 0.2f; ///< radius of the crown at its foot, per height
    float clear = 0.06f; ///< height of the lowest branches, per height
    int branches = 84;
};
Mesh makeSpruce(const SpruceShape& shape, Random random);

struct BroadShape {
    float height = 10.0f;
    float spread = 0.36f; ///< radius of the crown, per height
    float fork = 0.28f;   ///< where the trunk divides, per height
    int limbs = 6;
    int twigsPerLimb = 3;
    int cardsPerClump = 8;
    float clump = 0.16f; ///< radius of a clump of leaves, per height
    float droop = 0.0f;
    bool birch = false;
    vec3 tint{1.0f};
};
Mesh makeBroadleaf(const BroadShape& shape, Random random);

/// A low shrub: leaves to the ground, hardly any wood.
Mesh makeBush(float size, const vec3& tint, Random random);

/// Side views of trees for the far forest: one picture of 4 x 2 cells, `columns` wide cells first row first.
struct Impostors {
    Canvas picture;
    struct Cell {
        vec2 lower, upper; ///< texture coordinates
        vec2 size;         ///< width and height of the tree, m
    };
    std::vector<Cell> cells;
};
Impostors drawImpostors(const std::vector<const Mesh*>& trees, const FoliageTextures& textures);

} // namespace tarn::lake
