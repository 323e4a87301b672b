// Plane, box and sphere as meshes. Private to src/scene.
#pragma once

#include "scene/scene.h"

namespace tarn {

/// Centred on the origin, of primitive.size, with normals, texture coordinates (times uvScale) and tangents.
/// A plane lies in xz and faces +y, u along +x, v along -z; a box shows each face upright from outside; on a
/// sphere u runs once round from -z over -x, v from pole to pole.
Mesh buildPrimitive(const Primitive& primitive);

} // namespace tarn
