// Geometry as a file gives it: separate lists of positions, texture coordinates and normals, and corners that
// point into them. mesh_build.h makes a Mesh of it. Private to src/scene.
#pragma once

#include "base/math.h"

#include <cstdint>
#include <vector>

namespace tarn {

struct Corner {
    std::int32_t position = -1, uv = -1, normal = -1; ///< -1: none
    bool operator==(const Corner&) const = default;
};

struct MeshSource {
    std::vector<vec3> positions;
    std::vector<std::uint32_t> colours; ///< per position, or fewer: white
    std::vector<vec2> uvs;
    std::vector<vec3> normals;

    struct Face {
        std::uint32_t firstCorner, cornerCount;
        std::int32_t material;
        std::uint32_t smoothing; ///< group; 0: off
    };
    std::vector<Corner> corners;
    std::vector<Face> faces;
};

/// Cuts every face into triangles (ear clipping, so that concave ones keep their shape) and drops those
/// without three different corners. A triangle keeps its polygon's normal when that has no smoothing:
/// computeNormals must come first.
void triangulate(MeshSource& source);

/// Gives a normal to each corner that has none: the face's own where smoothing is off, else the mean over the
/// faces around the vertex that share its smoothing group, weighted by their angles there (Thürmer & Wüthrich
/// 1998).
void computeNormals(MeshSource& source);

/// Newell's normal of a polygon, its length twice the area: right for concave and slightly bent ones too.
vec3 newellNormal(const MeshSource& source, const MeshSource::Face& face);

} // namespace tarn
