#include "plan/depth_complexity.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace tarn {

namespace {

struct Crossing {
    float height;
    enum class Kind { entersSolid, leavesSolid, sheet, cutOut } kind; ///< going down
};

/// The crossings of vertical lines with the scene, over a lattice of places.
class Lattice {
public:
    Lattice(vec2 lower, vec2 upper, int resolution)
        : lower_(lower), cell_((upper - lower) / static_cast<float>(resolution)), resolution_(resolution),
          lines_(static_cast<std::size_t>(resolution) * static_cast<std::size_t>(resolution))
    {}

    void add(const vec3& a, const vec3& b, const vec3& c, bool isSheet)
    {
        const vec2 ab(b.x - a.x, b.z - a.z), ac(c.x - a.x, c.z - a.z);
        const float area = ab.x * ac.y - ab.y * ac.x; // over zero when the face looks down: x, z turn the other way
        if (std::abs(area) < 1.0e-12f) return;
        const Crossing::Kind kind = isSheet       ? Crossing::Kind::sheet
                                    : area < 0.0f ? Crossing::Kind::entersSolid
                                                  : Crossing::Kind::leavesSolid;
        forLines(a, b, c, [&](vec2 position, std::vector<Crossing>& line) {
            const vec2 ap = position - vec2(a.x, a.z);
            const float u = (ap.x * ac.y - ap.y * ac.x) / area, v = (ab.x * ap.y - ab.y * ap.x) / area;
            if (u < 0.0f || v < 0.0f || u + v >= 1.0f) return;
            line.push_back({a.y + u * (b.y - a.y) + v * (c.y - a.y), kind});
        });
    }

    /// Foliage: a crown is made of cards that mostly stand upright, and is a layer wherever it is.
    void addCutOut(const vec3& a, const vec3& b, const vec3& c)
    {
        const float height = (a.y + b.y + c.y) / 3.0f;
        forLines(a, b, c, [&](vec2, std::vector<Crossing>& line) { line.push_back({height, Crossing::Kind::cutOut}); });
    }

    std::vector<std::vector<Crossing>>& lines() { return lines_; }

private:
    /// Calls a function with each line in a triangle's box.
    template <typename Visit> void forLines(const vec3& a, const vec3& b, const vec3& c, const Visit& visit)
    {
        const ivec2 first = cellOf({std::min({a.x, b.x, c.x}), std::min({a.z, b.z, c.z})});
        const ivec2 last = cellOf({std::max({a.x, b.x, c.x}), std::max({a.z, b.z, c.z})});
        for (int j = std::max(first.y, 0); j <= std::min(last.y, resolution_ - 1); ++j)
            for (int i = std::max(first.x, 0); i <= std::min(last.x, resolution_ - 1); ++i)
                visit(lower_ + (vec2(static_cast<float>(i), static_cast<float>(j)) + 0.5f) * cell_,
                      lines_[static_cast<std::size_t>(j) * static_cast<std::size_t>(resolution_) +
                             static_cast<std::size_t>(i)]);
    }

    ivec2 cellOf(vec2 position) const { return ivec2(glm::floor((position - lower_) / cell_)); }

    vec2 lower_, cell_;
    int resolution_;
    std::vector<std::vector<Crossing>> lines_;
};

Lattice latticeOf(const Scene& scene, vec2 lower, vec2 upper, int resolution)
{
    Lattice lattice(lower, upper, resolution);
    for (const Instance& instance : flatten(scene)) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const auto corner = [&](std::uint32_t index) {
            return vec3(instance.worldFromModel * vec4(mesh.vertices[index].position, 1.0f));
        };
        for (const MeshPart& part : mesh.parts) {
            const Material& material = scene.materials[static_cast<std::size_t>(part.material)];
            for (std::size_t i = part.firstIndex; i + 2 < part.firstIndex + part.indexCount; i += 3) {
                const vec3 a = corner(mesh.indices[i]), b = corner(mesh.indices[i + 1]),
                           c = corner(mesh.indices[i + 2]);
                if (material.alphaTested)
                    lattice.addCutOut(a, b, c);
                else
                    lattice.add(a, b, c, material.twoSided);
            }
        }
    }
    return lattice;
}

/// Layers that face the open, of the crossings of one line from the top down, under and over the level.
struct Layers {
    int under = 0, over = 0;
};

Layers layersOf(std::vector<Crossing>& line, float level)
{
    std::sort(line.begin(), line.end(), [](const Crossing& a, const Crossing& b) { return a.height > b.height; });
    Layers layers;
    int inside = 0;
    bool afterCutOut = false;
    for (const Crossing& crossing : line) {
        const bool isCutOut = crossing.kind == Crossing::Kind::cutOut;
        const bool opensHere = crossing.kind != Crossing::Kind::leavesSolid && inside == 0;
        if (opensHere && !(isCutOut && afterCutOut)) // many cards are one crown
            ++(crossing.height < level ? layers.under : layers.over);
        afterCutOut = isCutOut;
        if (crossing.kind == Crossing::Kind::entersSolid) ++inside;
        if (crossing.kind == Crossing::Kind::leavesSolid) inside = std::max(inside - 1, 0);
    }
    return layers;
}

} // namespace

DepthComplexity depthComplexity(const Scene& scene, const WaterBody& water, int resolution)
{
    const vec2 half = 0.5f * water.extent;
    std::size_t beds = 0, hiddenBeds = 0, standing = 0, stacked = 0;
    Lattice overWater = latticeOf(scene, water.centre - half, water.centre + half, resolution);
    for (std::vector<Crossing>& line : overWater.lines()) {
        const Layers layers = layersOf(line, water.level);
        beds += layers.under > 0;
        hiddenBeds += layers.under > 1;
    }
    const Bounds bounds = worldBounds(scene);
    if (bounds.empty()) return {};
    Lattice overAll =
        latticeOf(scene, vec2(bounds.lower.x, bounds.lower.z), vec2(bounds.upper.x, bounds.upper.z), resolution);
    for (std::vector<Crossing>& line : overAll.lines()) {
        const Layers layers = layersOf(line, water.level);
        standing += layers.over > 0;
        stacked += layers.over > 1;
    }
    const auto fraction = [](std::size_t part, std::size_t whole) {
        return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
    };
    return {fraction(hiddenBeds, beds), fraction(stacked, standing)};
}

} // namespace tarn
