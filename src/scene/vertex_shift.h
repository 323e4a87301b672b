// What colour, normal and texture make of a point that a simplified surface shows in place of a vertex.
#pragma once

#include "scene/scene.h"

#include <array>

namespace tarn {

/// By how much that seems to move the vertex, m: a texture slides; a brightness that is off is as bad as a thing of the
/// size of the patch that is off.
/// @param corners of the triangle that is shown   @param weights of them, at the point
/// @param metresPerUv of the texture round about; 0: it has none
float seemingShift(const Vertex& truth, const std::array<const Vertex*, 3>& corners, const vec3& weights,
                   float metresPerUv);

} // namespace tarn
