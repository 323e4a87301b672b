// The same things with more triangles: a lake whose geometry is 4, 16, 64 times as large, to measure how cost grows.
#pragma once

#include "mesh.h"

#include <functional>

namespace tarn::lake {

/// How much more than the shipped lake.
struct Refinement {
    int levels = 0; ///< each cuts every triangle in four

    /// From how many times the triangles; 1, 4, 16, 64 or 256.
    static Refinement times(int scale);
};

/// Cuts every triangle in four, as often as wanted. What is new stands at the middles of edges, moved by up to
/// `roughness` times the edge's length, or the shortest one's that it meets, by midpoint displacement (Fournier,
/// Fussell & Carpenter 1982): rough rock, bent leaves, and no flat pieces that a simplification would find for nothing.
/// Equal edges are moved alike, so that what was closed stays closed.
/// @param settle where a displaced vertex ought to stand instead, or empty: the ground knows its own shape
Mesh refined(const Mesh& mesh, Refinement refinement, float roughness,
             const std::function<vec3(const vec3& position)>& settle = {});

} // namespace tarn::lake
