// Every picture of the lake, drawn from noise and strokes. Ground pictures are neutral (mean reflectance 0.5
// in each channel): the vertex colours say what colour a place has, so that zones meet without an edge.
#pragma once

#include "canvas.h"

namespace tarn::lake {

inline constexpr float neutralMean = 0.5f;

/// sand, grass, forest, rock, pebbles, and normal maps of all but grass.
void writeGroundTextures(const std::filesystem::path& folder, std::uint32_t seed);

/// bark, birch, wood, paint, and normal maps of bark and wood.
void writeWoodTextures(const std::filesystem::path& folder, std::uint32_t seed);

/// Cut-out pictures of plants.
struct FoliageTextures {
    Canvas leaves;  ///< a clump of broad leaves, all over the square
    Canvas needles; ///< a spruce branch from the trunk (v = 0) to its tip (v = 1)
    Canvas reeds;   ///< stems from v = 0 upward, some with a plume
    Canvas blades;  ///< grass from v = 0 upward
};
FoliageTextures drawFoliage(std::uint32_t seed);
void writeFoliageTextures(const std::filesystem::path& folder, const FoliageTextures& textures);

} // namespace tarn::lake
