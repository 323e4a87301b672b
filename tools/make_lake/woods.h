// Which trees there are, and where each of them stands.
#pragma once

#include "lake_shape.h"
#include "mesh.h"
#include "terrain.h"
#include "trees.h"
#include "views.h"

namespace tarn::lake {

struct Species {
    std::string name;
    Mesh mesh;
    float crown; ///< radius, m
    bool conifer;
};
std::vector<Species> growSpecies(std::uint32_t seed);

struct StandingTree {
    std::size_t species;
    vec3 foot;
    float turn, scale;
};
std::vector<StandingTree> plantTrees(const LakeShape& shape, const std::vector<Species>& species,
                                     const std::vector<View>& views, Random random);

/// What the trees take from the ground's sky.
std::vector<Shade> treeShades(const std::vector<StandingTree>& trees, const std::vector<Species>& species);

} // namespace tarn::lake
