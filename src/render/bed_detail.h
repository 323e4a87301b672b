// How finely the triangles under water are cut.
#pragma once

#include "scene/scene.h"

namespace tarn {

/// The edge, m, that a tenth of the area under the water's level and inside its rectangle exceeds: each
/// triangle by its longest edge. 0 where nothing is under water.
///
/// RefractionOptions::CameraMode::flat bends the bed at its vertices and leaves what is between them straight, so that
/// it needs triangles that are small beside their distance.
float coarseEdgeUnderWater(const Scene& scene, const WaterBody& water);

/// What that camera bears: the lake has 2.2 m, and hits that are off by 3 mm in the median.
inline constexpr float longestBedEdge = 2.5f;

} // namespace tarn
