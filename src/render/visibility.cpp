#include "render/visibility.h"

#include "plan/frame_plan.h"

#include <algorithm>

namespace tarn {

std::vector<Chunk> listChunks(const Scene& scene, const std::vector<Instance>& instances)
{
    std::vector<Chunk> chunks;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instances[i].mesh)];
        for (const MeshPart& part : mesh.parts)
            chunks.push_back({static_cast<int>(i), instances[i].mesh, part.material, part.firstIndex,
                              part.indexCount, part.bounds.transformed(instances[i].worldFromModel)});
    }
    return chunks;
}

Medium mediumOf(const Bounds& boundsW, const WaterBody& water, float rim)
{
    const vec2 lower = water.centre - 0.5f * water.extent - rim, upper = water.centre + 0.5f * water.extent + rim;
    if (boundsW.lower.y >= water.level || boundsW.upper.x < lower.x || boundsW.lower.x > upper.x ||
        boundsW.upper.z < lower.y || boundsW.lower.z > upper.y)
        return Medium::air;
    const bool within = boundsW.lower.x >= lower.x && boundsW.upper.x <= upper.x && boundsW.lower.z >= lower.y &&
                        boundsW.upper.z <= upper.y;
    return within && boundsW.upper.y < water.level ? Medium::water : Medium::both;
}

WaterCover waterCover(const WaterBody& water)
{
    const Bounds slab = waterBounds(water);
    return {true, {slab.lower.x, slab.lower.z}, {slab.upper.x, slab.upper.z}, slab.lower.y, slab.upper.y};
}

bool WaterCover::hides(const vec3& eye, const Bounds& box) const
{
    if (!active || eye.y <= highest || box.upper.y >= lowest) return false;
    // The box's image on a horizontal plane, seen from the eye, is the convex hull of its corners' images; the
    // rectangle is convex, so the corners decide. The surface lies between two such planes.
    for (int corner = 0; corner < 8; ++corner) {
        const vec3 point((corner & 1) ? box.upper.x : box.lower.x, (corner & 2) ? box.upper.y : box.lower.y,
                         (corner & 4) ? box.upper.z : box.lower.z);
        for (const float height : {lowest, highest}) {
            const vec3 crossing = eye + (point - eye) * ((eye.y - height) / (eye.y - point.y));
            if (crossing.x < lower.x || crossing.x > upper.x || crossing.z < lower.y || crossing.z > upper.y)
                return false;
        }
    }
    return true;
}

namespace {

bool keptByPlane(const vec4& plane, const Bounds& box)
{
    const vec3 farthest(plane.x >= 0.0f ? box.upper.x : box.lower.x, plane.y >= 0.0f ? box.upper.y : box.lower.y,
                        plane.z >= 0.0f ? box.upper.z : box.lower.z);
    return dot(vec3(plane), farthest) + plane.w >= 0.0f;
}

/// A box around all that a box under flat water may seem to be (flatApparent). Light leaves the bed at no more than
/// 48.8 degrees from the vertical, so that its way in the water, laid out straight, is at most 1.52 times the depth.
Bounds seenThroughFlatWater(const Bounds& box, float level)
{
    const float depth = level - box.lower.y;
    if (depth <= 0.0f) return box;
    constexpr float reach = 1.55f;
    Bounds result = box;
    result.lower -= vec3(reach * depth, 0.0f, reach * depth);
    result.upper += vec3(reach * depth, 0.0f, reach * depth);
    result.upper.y = std::max(result.upper.y, level);
    return result;
}

float distanceTo(const vec3& eye, const Bounds& box)
{
    return glm::distance(eye, glm::clamp(eye, box.lower, box.upper));
}

} // namespace

std::vector<const Chunk*> visibleChunks(const std::vector<Chunk>& chunks, const std::vector<Material>& materials,
                                        const View& view, const WaterCover& cover, bool cull)
{
    struct Entry {
        bool alphaTested;
        float distance;
        const Chunk* chunk;
    };
    const Frustum frustum(view.clipFromWorld());
    std::vector<Entry> entries;
    entries.reserve(chunks.size());
    for (const Chunk& chunk : chunks) {
        const Bounds shown = view.flatWater ? seenThroughFlatWater(chunk.boundsW, *view.flatWater) : chunk.boundsW;
        const bool seen = frustum.intersects(shown) && keptByPlane(view.clipPlane, chunk.boundsW) &&
                          !cover.hides(view.eye, chunk.boundsW);
        if (cull && !seen) continue;
        const Material& material = materials[static_cast<std::size_t>(chunk.material)];
        entries.push_back({material.alphaTested, distanceTo(view.eye, chunk.boundsW), &chunk});
    }
    std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return a.alphaTested != b.alphaTested ? b.alphaTested : a.distance < b.distance;
    });
    std::vector<const Chunk*> visible;
    visible.reserve(entries.size());
    for (const Entry& entry : entries) visible.push_back(entry.chunk);
    return visible;
}

bool mayShow(const View& view, const WaterCover& cover, const Bounds& boxW)
{
    const Bounds shown = view.flatWater ? seenThroughFlatWater(boxW, *view.flatWater) : boxW;
    return Frustum(view.clipFromWorld()).intersects(shown) && keptByPlane(view.clipPlane, boxW) &&
           !cover.hides(view.eye, boxW);
}

} // namespace tarn
