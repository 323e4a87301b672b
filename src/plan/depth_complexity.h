// Whether a map seen straight from above or below can hold what there is: its depth complexity.
#pragma once

#include "scene/scene.h"

namespace tarn {

/// What a map of heights would miss, of the places of a lattice over the scene.
struct DepthComplexity {
    /// Of the places with a bed under water: the share that has another layer, under what is seen from above.
    double bed = 0.0;
    /// Of the places where something stands over the water: the share that has more than one piece, one over the other.
    double aboveWater = 0.0;
};

/// A layer is a surface that faces water or air: what is sunk in the ground does not count, nor the two sides of one
/// solid. A two-sided sheet is one, and so is a crown of cut-outs, at all places that its cards' boxes cover. Other
/// triangles that stand upright cover no place.
/// @param resolution places along one edge of the lattice
DepthComplexity depthComplexity(const Scene& scene, const WaterBody& water, int resolution = 256);

} // namespace tarn
