#include "mesh.h"

#include <algorithm>
#include <map>

namespace tarn::lake {

void Mesh::use(const std::string& material)
{
    const auto found = std::find(materials_.begin(), materials_.end(), material);
    current_ = static_cast<int>(found - materials_.begin());
    if (found == materials_.end()) materials_.push_back(material);
}

int Mesh::addPosition(const vec3& position, const vec3& colour)
{
    positions.push_back(position);
    colours.push_back(glm::clamp(colour, vec3(0.0f), vec3(1.0f)));
    return static_cast<int>(positions.size()) - 1;
}

int Mesh::addNormal(const vec3& normal)
{
    normals.push_back(glm::normalize(normal));
    return static_cast<int>(normals.size()) - 1;
}

int Mesh::addUv(vec2 uv)
{
    uvs.push_back(uv);
    return static_cast<int>(uvs.size()) - 1;
}

Corner Mesh::add(const vec3& position, const vec3& normal, vec2 uv, const vec3& colour)
{
    return {addPosition(position, colour), addUv(uv), addNormal(normal)};
}

void Mesh::triangle(const Corner& a, const Corner& b, const Corner& c) { faces.push_back({{a, b, c, a}, 3, current_}); }

void Mesh::quad(const Corner& a, const Corner& b, const Corner& c, const Corner& d)
{
    faces.push_back({{a, b, c, d}, 4, current_});
}

void Mesh::append(const Mesh& other, const mat4& worldFromModel)
{
    const int firstPosition = static_cast<int>(positions.size()), firstUv = static_cast<int>(uvs.size()),
              firstNormal = static_cast<int>(normals.size());
    const mat3 turn(worldFromModel);
    for (std::size_t i = 0; i < other.positions.size(); ++i)
        addPosition(vec3(worldFromModel * vec4(other.positions[i], 1.0f)), other.colours[i]);
    for (const vec3& normal : other.normals) addNormal(turn * normal);
    uvs.insert(uvs.end(), other.uvs.begin(), other.uvs.end());
    const int before = current_;
    for (Face face : other.faces) {
        use(other.materials_[static_cast<std::size_t>(face.material)]);
        face.material = current_;
        for (Corner& corner : face.corners) {
            corner.position += firstPosition;
            corner.uv += firstUv;
            corner.normal += firstNormal;
        }
        faces.push_back(face);
    }
    current_ = before;
}

void Mesh::tint(const std::function<vec3(const vec3&, const vec3&)>& change)
{
    for (std::size_t i = 0; i < positions.size(); ++i)
        colours[i] = glm::clamp(change(positions[i], colours[i]), vec3(0.0f), vec3(1.0f));
}

std::size_t Mesh::triangles() const
{
    std::size_t sum = 0;
    for (const Face& face : faces) sum += face.count == 4 ? 2u : 1u;
    return sum;
}

namespace {

/// A fan over a ring, for the end of a bar.
void addCap(Mesh& mesh, const std::vector<Corner>& ring, const TubeRing& end, const vec3& outward, bool reverse,
            const TubeStyle& style)
{
    const int normal = mesh.addNormal(outward);
    const int centre = mesh.addPosition(end.centre, style.colour(end.centre));
    const int centreUv = mesh.addUv({style.uOffset + 0.5f, 0.5f});
    const float spread = end.radius * style.uvPerMetre;
    std::vector<int> rim;
    for (int side = 0; side <= style.sides; ++side) {
        const float turn = 2.0f * pi * real(side) / real(style.sides);
        rim.push_back(mesh.addUv({style.uOffset + 0.5f + spread * std::cos(turn), 0.5f + spread * std::sin(turn)}));
    }
    for (int side = 0; side < style.sides; ++side) {
        const auto i = static_cast<std::size_t>(side);
        const Corner a{ring[i].position, rim[i], normal}, b{ring[i + 1].position, rim[i + 1], normal};
        const Corner middle{centre, centreUv, normal};
        if (reverse)
            mesh.triangle(middle, b, a);
        else
            mesh.triangle(middle, a, b);
    }
}

vec3 pathDirection(const std::vector<TubeRing>& rings, std::size_t i)
{
    const vec3& before = rings[i == 0 ? 0 : i - 1].centre;
    const vec3& after = rings[i + 1 == rings.size() ? i : i + 1].centre;
    return glm::normalize(after - before);
}

} // namespace

void addTube(Mesh& mesh, const std::vector<TubeRing>& rings, const TubeStyle& style)
{
    std::vector<std::vector<Corner>> corners(rings.size());
    vec3 side = std::abs(pathDirection(rings, 0).y) > 0.9f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 1.0f, 0.0f);
    float along = 0.0f;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        if (i > 0) along += glm::length(rings[i].centre - rings[i - 1].centre);
        const vec3 axis = pathDirection(rings, i);
        side = glm::normalize(side - axis * glm::dot(side, axis)); // carried along the path: it never twists
        const vec3 other = glm::cross(axis, side);
        const std::size_t before = i == 0 ? 0 : i - 1, after = i + 1 == rings.size() ? i : i + 1;
        const float length = std::max(1e-4f, glm::length(rings[after].centre - rings[before].centre));
        const float taper = (rings[before].radius - rings[after].radius) / length;
        for (int s = 0; s <= style.sides; ++s) {
            const float turn = 2.0f * pi * real(s) / real(style.sides);
            const vec3 outward = std::cos(turn) * side + std::sin(turn) * other;
            Corner corner;
            if (s < style.sides) {
                const vec3 position = rings[i].centre + rings[i].radius * outward;
                corner.position = mesh.addPosition(position, style.colour(position));
                corner.normal = mesh.addNormal(outward + taper * axis);
            } else {
                corner = corners[i].front();
            }
            corner.uv =
                mesh.addUv({style.uOffset + style.uvRound * real(s) / real(style.sides), along * style.uvPerMetre});
            corners[i].push_back(corner);
        }
    }
    for (std::size_t i = 0; i + 1 < rings.size(); ++i)
        for (std::size_t s = 0; s < static_cast<std::size_t>(style.sides); ++s)
            mesh.quad(corners[i][s], corners[i][s + 1], corners[i + 1][s + 1], corners[i + 1][s]);
    if (style.capStart) addCap(mesh, corners.front(), rings.front(), -pathDirection(rings, 0), true, style);
    if (style.capEnd) addCap(mesh, corners.back(), rings.back(), pathDirection(rings, rings.size() - 1), false, style);
}

void addBox(Mesh& mesh, const mat4& worldFromBox, const vec3& size, const BoxStyle& style)
{
    const mat3 turn(worldFromBox);
    const vec3 h = 0.5f * size;
    // Rings of four corners along x; the sides are quads between rings, the ends one quad each.
    const std::array<vec2, 4> section{vec2(-h.y, -h.z), vec2(h.y, -h.z), vec2(h.y, h.z), vec2(-h.y, h.z)};
    const std::array<vec3, 4> outward{vec3(0, 0, -1), vec3(0, 1, 0), vec3(0, 0, 1), vec3(0, -1, 0)};
    std::vector<std::array<int, 4>> rings;
    const auto world = [&](float x, int k) {
        const vec2 yz = section[static_cast<std::size_t>(k)];
        return vec3(worldFromBox * vec4(x, yz.x, yz.y, 1.0f));
    };
    for (int ring = 0; ring <= style.segments; ++ring) {
        const float x = mix(-h.x, h.x, real(ring) / real(style.segments));
        std::array<int, 4> positions{};
        for (int k = 0; k < 4; ++k) {
            const vec3 p = world(x, k);
            positions[static_cast<std::size_t>(k)] = mesh.addPosition(p, style.colour(p));
        }
        rings.push_back(positions);
    }
    float across = 0.0f;
    for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t next = (k + 1) % 4;
        const float width = glm::length(section[next] - section[k]);
        const int normal = mesh.addNormal(turn * outward[k]);
        for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
            const float v0 = size.x * real(static_cast<int>(r)) / real(style.segments);
            const float v1 = size.x * real(static_cast<int>(r + 1)) / real(style.segments);
            const auto corner = [&](std::size_t ring, std::size_t c, float u, float v) {
                return Corner{rings[ring][c], mesh.addUv(style.uvOffset + style.uvPerMetre * vec2(u, v)), normal};
            };
            mesh.quad(corner(r, k, across, v0), corner(r, next, across + width, v0),
                      corner(r + 1, next, across + width, v1), corner(r + 1, k, across, v1));
        }
        across += width;
    }
    for (const bool start : {true, false}) {
        const std::size_t ring = start ? 0 : rings.size() - 1;
        const int normal = mesh.addNormal(turn * vec3(start ? -1 : 1, 0, 0));
        const auto corner = [&](std::size_t c) {
            return Corner{rings[ring][c], mesh.addUv(style.uvOffset + style.uvPerMetre * section[c]), normal};
        };
        if (start)
            mesh.quad(corner(3), corner(2), corner(1), corner(0));
        else
            mesh.quad(corner(0), corner(1), corner(2), corner(3));
    }
}

IcoSphere icoSphere(int levels)
{
    const float g = 0.5f * (1.0f + std::sqrt(5.0f));
    IcoSphere sphere{{{-1, g, 0},
                      {1, g, 0},
                      {-1, -g, 0},
                      {1, -g, 0},
                      {0, -1, g},
                      {0, 1, g},
                      {0, -1, -g},
                      {0, 1, -g},
                      {g, 0, -1},
                      {g, 0, 1},
                      {-g, 0, -1},
                      {-g, 0, 1}},
                     {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
    for (vec3& p : sphere.positions) p = glm::normalize(p);
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<int, int>, int> middles;
        const auto middle = [&](int a, int b) {
            const auto key = std::minmax(a, b);
            const auto [entry, isNew] =
                middles.try_emplace({key.first, key.second}, static_cast<int>(sphere.positions.size()));
            if (isNew)
                sphere.positions.push_back(glm::normalize(sphere.positions[static_cast<std::size_t>(a)] +
                                                          sphere.positions[static_cast<std::size_t>(b)]));
            return entry->second;
        };
        std::vector<std::array<int, 3>> finer;
        for (const auto& [a, b, c] : sphere.triangles) {
            const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
        }
        sphere.triangles = std::move(finer);
    }
    return sphere;
}

std::vector<vec3> smoothNormals(const std::vector<vec3>& positions, const std::vector<std::array<int, 3>>& triangles)
{
    std::vector<vec3> normals(positions.size(), vec3(0.0f));
    for (const auto& triangle : triangles) {
        const auto at = [&](std::size_t k) { return positions[static_cast<std::size_t>(triangle[k])]; };
        const vec3 normal = glm::cross(at(1) - at(0), at(2) - at(0));
        for (const int corner : triangle) normals[static_cast<std::size_t>(corner)] += normal;
    }
    for (vec3& normal : normals) normal = glm::normalize(normal);
    return normals;
}

std::vector<std::array<vec3, 3>> creasedNormals(const std::vector<vec3>& positions,
                                                const std::vector<std::array<int, 3>>& triangles, float cosine)
{
    std::vector<vec3> faceNormals; // their length is twice the area
    std::vector<std::vector<std::size_t>> facesAt(positions.size());
    for (std::size_t face = 0; face < triangles.size(); ++face) {
        const auto at = [&](std::size_t k) { return positions[static_cast<std::size_t>(triangles[face][k])]; };
        faceNormals.push_back(glm::cross(at(1) - at(0), at(2) - at(0)));
        for (const int corner : triangles[face]) facesAt[static_cast<std::size_t>(corner)].push_back(face);
    }
    std::vector<std::array<vec3, 3>> normals(triangles.size());
    for (std::size_t face = 0; face < triangles.size(); ++face) {
        const vec3 own = glm::normalize(faceNormals[face]);
        for (std::size_t k = 0; k < 3; ++k) {
            vec3 sum(0.0f);
            for (const std::size_t other : facesAt[static_cast<std::size_t>(triangles[face][k])])
                if (glm::dot(own, glm::normalize(faceNormals[other])) > cosine) sum += faceNormals[other];
            normals[face][k] = glm::normalize(sum);
        }
    }
    return normals;
}

std::array<vec2, 3> boxUvs(const vec3& a, const vec3& b, const vec3& c, float perMetre)
{
    const vec3 n = glm::cross(b - a, c - a);
    const vec3 size = glm::abs(n);
    std::array<vec2, 3> uvs;
    std::size_t i = 0;
    for (const vec3& p : {a, b, c}) {
        vec2 uv(p.x, -p.z);
        if (size.x > size.y && size.x >= size.z)
            uv = vec2(n.x > 0.0f ? -p.z : p.z, p.y);
        else if (size.z > size.y)
            uv = vec2(n.z > 0.0f ? p.x : -p.x, p.y);
        uvs[i++] = perMetre * uv;
    }
    return uvs;
}

mat4 placed(const vec3& position, float angle, float scale)
{
    const mat4 moved = glm::translate(mat4(1.0f), position);
    return glm::scale(glm::rotate(moved, angle, vec3(0.0f, 1.0f, 0.0f)), vec3(scale));
}

} // namespace tarn::lake
