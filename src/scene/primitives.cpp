#include "scene/primitives.h"

#include "scene/mesh_build.h"

#include <cmath>

namespace tarn {

namespace {

/// Adds a grid of (columns + 1) × (rows + 1) points, surface(u, v) over 0..1, facing where u × v points.
template <typename Surface>
void addGrid(MeshSource& source, int columns, int rows, int material, const Surface& surface)
{
    const auto first = static_cast<std::int32_t>(source.positions.size());
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            const vec2 uv(static_cast<float>(column) / static_cast<float>(columns),
                          static_cast<float>(row) / static_cast<float>(rows));
            surface(uv);
        }
    }
    const auto corner = [&](int column, int row) {
        const std::int32_t i = first + row * (columns + 1) + column;
        return Corner{i, i, i};
    };
    const auto add = [&](const Corner& a, const Corner& b, const Corner& c) {
        // At a sphere's poles one side of the quad is a point.
        const auto at = [&](const Corner& k) { return source.positions[static_cast<std::size_t>(k.position)]; };
        if (at(a) == at(b) || at(b) == at(c) || at(c) == at(a)) return;
        source.faces.push_back({static_cast<std::uint32_t>(source.corners.size()), 3, material, 0});
        source.corners.insert(source.corners.end(), {a, b, c});
    };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const Corner a = corner(column, row), b = corner(column + 1, row);
            const Corner c = corner(column + 1, row + 1), d = corner(column, row + 1);
            add(a, b, c);
            add(a, c, d);
        }
    }
}

/// A flat rectangle around `centre`, spanned by full edge vectors.
void addRectangle(MeshSource& source, const Primitive& primitive, int segments, const vec3& centre, const vec3& edgeU,
                  const vec3& edgeV)
{
    const vec3 normal = glm::normalize(glm::cross(edgeU, edgeV));
    addGrid(source, segments, segments, primitive.material, [&](const vec2& uv) {
        source.positions.push_back(centre + (uv.x - 0.5f) * edgeU + (uv.y - 0.5f) * edgeV);
        source.normals.push_back(normal);
        source.uvs.push_back(uv * primitive.uvScale);
    });
}

void addBox(MeshSource& source, const Primitive& primitive)
{
    const vec3 x(primitive.size.x, 0.0f, 0.0f), y(0.0f, primitive.size.y, 0.0f), z(0.0f, 0.0f, primitive.size.z);
    const int segments = primitive.segments;
    addRectangle(source, primitive, segments, 0.5f * x, -z, y);
    addRectangle(source, primitive, segments, -0.5f * x, z, y);
    addRectangle(source, primitive, segments, 0.5f * y, x, -z);
    addRectangle(source, primitive, segments, -0.5f * y, x, z);
    addRectangle(source, primitive, segments, 0.5f * z, x, y);
    addRectangle(source, primitive, segments, -0.5f * z, -x, y);
}

/// Rings from pole to pole, twice as many segments around.
void addSphere(MeshSource& source, const Primitive& primitive)
{
    const int rings = std::max(primitive.segments, 3);
    const vec3 radii = 0.5f * primitive.size;
    addGrid(source, 2 * rings, rings, primitive.material, [&](const vec2& uv) {
        const float longitude = 2.0f * pi * uv.x, latitude = pi * (uv.y - 0.5f);
        // sin(π) and cos(π/2) are not quite zero in floats: poles and seam must be single points.
        const bool pole = uv.y == 0.0f || uv.y == 1.0f;
        const float around = pole ? 0.0f : std::cos(latitude);
        const float turn = uv.x == 1.0f ? 0.0f : longitude;
        const vec3 unit(-around * std::sin(turn), std::sin(latitude), -around * std::cos(turn));
        source.positions.push_back(unit * radii);
        source.normals.push_back(glm::normalize(unit / radii)); // of an ellipsoid
        source.uvs.push_back(uv * primitive.uvScale);
    });
}

} // namespace

Mesh buildPrimitive(const Primitive& primitive)
{
    MeshSource source;
    switch (primitive.kind) {
    case Primitive::Kind::plane:
        addRectangle(source, primitive, primitive.segments, vec3(0.0f), vec3(primitive.size.x, 0.0f, 0.0f),
                     vec3(0.0f, 0.0f, -primitive.size.z));
        break;
    case Primitive::Kind::box: addBox(source, primitive); break;
    case Primitive::Kind::sphere: addSphere(source, primitive); break;
    }
    return buildMesh(source, primitive.name);
}

} // namespace tarn
