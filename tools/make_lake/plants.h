// Reeds, grass, weed on the bed, and the far forest: cards of cut-out pictures in world space.
#pragma once

#include "lake_shape.h"
#include "mesh.h"
#include "trees.h"
#include "views.h"

namespace tarn::lake {

Mesh makeReeds(const LakeShape& shape, const std::vector<View>& views, Random random);
Mesh makeGrass(const LakeShape& shape, const std::vector<View>& views, Random random);
Mesh makeWeed(const LakeShape& shape, const std::vector<View>& views, Random random);
Mesh makeForest(const LakeShape& shape, const Impostors& impostors, const std::vector<View>& views, Random random);

} // namespace tarn::lake
