#include "refine.h"

#include "random.h"

#include <algorithm>
#include <bit>
#include <unordered_map>

namespace tarn::lake {

namespace {

/// The middles of edges, each made once. An edge is a pair of indices into one of a mesh's lists.
class Middles {
public:
    template <typename Make> int of(int a, int b, const Make& make)
    {
        const auto low = static_cast<std::uint64_t>(std::min(a, b)), high = static_cast<std::uint64_t>(std::max(a, b));
        const auto [found, isNew] = known_.try_emplace(low << 32 | high, -1);
        if (isNew) found->second = make();
        return found->second;
    }

private:
    std::unordered_map<std::uint64_t, int> known_;
};

/// A number for a place.
std::uint64_t key(const vec3& place)
{
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis) // adding zero makes one of the two zeros
        key = key * 0x9e3779b97f4a7c15ull + std::bit_cast<std::uint32_t>(place[axis] + 0.0f);
    return key;
}

/// A vector in the unit ball that depends on the place alone: meshes that touch, touch afterwards too.
vec3 shift(const vec3& place)
{
    Random random(key(place));
    const float length = random.unit();
    return length * random.direction();
}

/// How far a vertex may be moved by: the shortest edge there, so that neither a blade of grass nor a mast is crumpled.
class Room {
public:
    explicit Room(const Mesh& mesh)
    {
        for (const Face& face : mesh.faces)
            for (int k = 0; k < face.count; ++k) {
                const vec3 a = place(mesh, face, k), b = place(mesh, face, (k + 1) % face.count);
                const float length = glm::distance(a, b);
                if (length > 0.0f) narrow(a, length), narrow(b, length);
            }
    }
    float at(const vec3& place) const { return shortest_.at(key(place)); }

private:
    static vec3 place(const Mesh& mesh, const Face& face, int k)
    {
        return mesh.positions[static_cast<std::size_t>(face.corners[static_cast<std::size_t>(k)].position)];
    }
    void narrow(const vec3& place, float length)
    {
        float& known = shortest_.try_emplace(key(place), length).first->second;
        known = std::min(known, length);
    }

    std::unordered_map<std::uint64_t, float> shortest_;
};

class Refiner {
public:
    Refiner(const Mesh& coarse, float roughness, const std::function<vec3(const vec3&)>& settle)
        : coarse_(coarse), room_(coarse), roughness_(roughness), settle_(settle)
    {
        for (std::size_t i = 0; i < coarse.positions.size(); ++i)
            fine_.addPosition(coarse.positions[i], coarse.colours[i]);
        fine_.normals = coarse.normals;
        fine_.uvs = coarse.uvs;
    }

    Mesh run()
    {
        for (const Face& face : coarse_.faces) {
            fine_.use(coarse_.materials()[static_cast<std::size_t>(face.material)]);
            cut(face.corners[0], face.corners[1], face.corners[2]);
            if (face.count == 4) cut(face.corners[0], face.corners[2], face.corners[3]);
        }
        return std::move(fine_);
    }

private:
    void cut(const Corner& a, const Corner& b, const Corner& c)
    {
        const Corner ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        fine_.triangle(a, ab, ca);
        fine_.triangle(ab, b, bc);
        fine_.triangle(ca, bc, c);
        fine_.triangle(ab, bc, ca);
    }

    Corner middle(const Corner& a, const Corner& b)
    {
        Corner corner;
        corner.position = positions_.of(a.position, b.position, [&] { return addPosition(a.position, b.position); });
        corner.uv = uvs_.of(a.uv, b.uv, [&] { return fine_.addUv(0.5f * (uv(a) + uv(b))); });
        corner.normal = normals_.of(a.normal, b.normal, [&] {
            fine_.normals.push_back(0.5f * (normal(a) + normal(b))); // a renderer interpolates in a straight line, too
            return static_cast<int>(fine_.normals.size()) - 1;
        });
        return corner;
    }

    int addPosition(int a, int b)
    {
        const vec3 from = coarse_.positions[static_cast<std::size_t>(a)],
                   to = coarse_.positions[static_cast<std::size_t>(b)];
        const vec3 half = 0.5f * (from + to);
        const float room = std::min({glm::distance(from, to), room_.at(from), room_.at(to)});
        const vec3 place = settle_ ? settle_(half) : half + roughness_ * room * shift(half);
        return fine_.addPosition(place, 0.5f * (coarse_.colours[static_cast<std::size_t>(a)] +
                                                coarse_.colours[static_cast<std::size_t>(b)]));
    }

    vec2 uv(const Corner& corner) const { return coarse_.uvs[static_cast<std::size_t>(corner.uv)]; }
    vec3 normal(const Corner& corner) const { return coarse_.normals[static_cast<std::size_t>(corner.normal)]; }

    const Mesh& coarse_;
    const Room room_;
    Mesh fine_;
    float roughness_;
    const std::function<vec3(const vec3&)>& settle_;
    Middles positions_, uvs_, normals_;
};

} // namespace

Refinement Refinement::times(int scale) { return {std::countr_zero(static_cast<unsigned>(scale)) / 2}; }

Mesh refined(const Mesh& mesh, Refinement refinement, float roughness, const std::function<vec3(const vec3&)>& settle)
{
    Mesh fine = mesh;
    for (int level = 0; level < refinement.levels; ++level) fine = Refiner(fine, roughness, settle).run();
    for (vec3& normal : fine.normals) normal /= std::max(glm::length(normal), 1e-6f);
    return fine;
}

} // namespace tarn::lake
