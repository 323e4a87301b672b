// Fewer triangles for a surface, by drawing vertices into their neighbours, those first that are missed least.
#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tarn {

struct Collapsed {
    std::vector<std::uint32_t>
        indices;        ///< of the same vertices; more than wanted where none can go without folding the surface
    float worst = 0.0f; ///< what is missed most, m: no part of the surface lies farther off
};

/// Half-edge collapses. What has gone is remembered with the triangle that lies there now (Klein, Liebich & Straßer
/// 1996), and each collapse is judged by all that it moves: how far that lies from the triangles that take its place,
/// and how much colour, normal and texture of vertices differ there (vertex_shift.h). Where borders are kept, vertices
/// at one place with different normals or texture coordinates go together.
/// @param vertices those of the piece only   @param indices its triangles
/// @param locksBorder keep every edge that has no second triangle
/// @param metresPerUv of the texture at each vertex
/// @param target triangles to come down to; it stops earlier, but not before `enough`, where what follows is far worse
Collapsed collapse(std::span<const Vertex> vertices, std::span<const std::uint32_t> indices,
                   std::span<const float> metresPerUv, std::size_t enough, std::size_t target, bool locksBorder);

} // namespace tarn
