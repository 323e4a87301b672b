#include "render/bed_detail.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace tarn {

namespace {

struct Triangle {
    float edge, area;
};

bool isUnderWater(const vec3& a, const vec3& b, const vec3& c, const WaterBody& water)
{
    if (std::min({a.y, b.y, c.y}) >= water.level) return false;
    const vec2 lower = water.centre - 0.5f * water.extent, upper = water.centre + 0.5f * water.extent;
    return std::max({a.x, b.x, c.x}) > lower.x && std::min({a.x, b.x, c.x}) < upper.x &&
           std::max({a.z, b.z, c.z}) > lower.y && std::min({a.z, b.z, c.z}) < upper.y;
}

} // namespace

float coarseEdgeUnderWater(const Scene& scene, const WaterBody& water)
{
    std::vector<Triangle> triangles;
    double total = 0.0;
    for (const Instance& instance : flatten(scene)) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        if (mesh.bounds.transformed(instance.worldFromModel).lower.y >= water.level) continue;
        const auto corner = [&](std::uint32_t index) {
            return vec3(instance.worldFromModel * vec4(mesh.vertices[index].position, 1.0f));
        };
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const vec3 a = corner(mesh.indices[i]), b = corner(mesh.indices[i + 1]), c = corner(mesh.indices[i + 2]);
            if (!isUnderWater(a, b, c, water)) continue;
            const float area = 0.5f * glm::length(glm::cross(b - a, c - a));
            triangles.push_back({std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)}), area});
            total += static_cast<double>(area);
        }
    }
    std::sort(triangles.begin(), triangles.end(), [](const Triangle& a, const Triangle& b) { return a.edge > b.edge; });
    double coarser = 0.0;
    for (const Triangle& triangle : triangles) {
        coarser += static_cast<double>(triangle.area);
        if (coarser >= 0.1 * total) return triangle.edge;
    }
    return 0.0f;
}

} // namespace tarn
