// Geometry as it will stand in an OBJ file, and the solids that everything in the lake is put together from.
#pragma once

#include "noise.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace tarn::lake {

/// One corner of a face: indices into the mesh's three lists.
struct Corner {
    int position = 0, uv = 0, normal = 0;
};

/// A triangle or a quadrilateral, counter-clockwise from outside.
struct Face {
    std::array<Corner, 4> corners{};
    int count = 3;
    int material = 0;
};

/// Colours are linear and multiply the material's reflectance: they carry tint and baked ambient occlusion.
class Mesh {
public:
    std::vector<vec3> positions, colours, normals;
    std::vector<vec2> uvs;
    std::vector<Face> faces;

    /// Index of a material by name; faces added from now on get it.
    void use(const std::string& material);
    const std::vector<std::string>& materials() const { return materials_; }

    int addPosition(const vec3& position, const vec3& colour = vec3(1.0f));
    int addNormal(const vec3& normal);
    int addUv(vec2 uv);
    /// Adds one entry to each list.
    Corner add(const vec3& position, const vec3& normal, vec2 uv, const vec3& colour = vec3(1.0f));

    void triangle(const Corner& a, const Corner& b, const Corner& c);
    void quad(const Corner& a, const Corner& b, const Corner& c, const Corner& d);

    /// Everything of another mesh, moved by an affine map (rotation, uniform scale).
    void append(const Mesh& other, const mat4& worldFromModel);

    /// Applied to every colour with the position it belongs to.
    void tint(const std::function<vec3(const vec3& position, const vec3& colour)>& change);

    std::size_t triangles() const;

private:
    std::vector<std::string> materials_;
    int current_ = 0;
};

/// A round bar along a path, closed at both ends. UVs: u once round per `uvRound` repeats, v along in metres
/// times uvPerMetre.
struct TubeStyle {
    int sides = 8;
    float uvRound = 1.0f;
    float uvPerMetre = 0.5f;
    float uOffset = 0.0f;
    bool capStart = true, capEnd = true;
    std::function<vec3(const vec3& position)> colour = [](const vec3&) { return vec3(1.0f); };
};
struct TubeRing {
    vec3 centre;
    float radius;
};
void addTube(Mesh& mesh, const std::vector<TubeRing>& rings, const TubeStyle& style);

/// A box of the given edge lengths round the origin of a frame, grain (v of the texture) along its x axis.
/// `segments` cuts it along x, so that colours can vary along a plank.
struct BoxStyle {
    float uvPerMetre = 0.5f;
    vec2 uvOffset{0.0f};
    int segments = 1;
    std::function<vec3(const vec3& position)> colour = [](const vec3&) { return vec3(1.0f); };
};
void addBox(Mesh& mesh, const mat4& worldFromBox, const vec3& size, const BoxStyle& style);

/// A sphere of triangles: the icosahedron cut in four `levels` times. Unit radius.
struct IcoSphere {
    std::vector<vec3> positions;
    std::vector<std::array<int, 3>> triangles;
};
IcoSphere icoSphere(int levels);

/// Normals of a triangle mesh, weighted by area.
std::vector<vec3> smoothNormals(const std::vector<vec3>& positions, const std::vector<std::array<int, 3>>& triangles);

/// Normals of the corners of each triangle, smoothed only over faces whose normals are nearer than the angle
/// of this cosine: edges stay edges.
std::vector<std::array<vec3, 3>> creasedNormals(const std::vector<vec3>& positions,
                                                const std::vector<std::array<int, 3>>& triangles, float cosine);

/// UVs of a triangle seen along the axis that its normal is closest to: no stretching on any slope.
std::array<vec2, 3> boxUvs(const vec3& a, const vec3& b, const vec3& c, float perMetre);

/// Rotation by `angle` about y, then translation.
mat4 placed(const vec3& position, float angle, float scale = 1.0f);

} // namespace tarn::lake
