#include "render/visibility.h"

#include "plan/frame_plan.h"

#include <algorithm>
#include <cmath>

namespace tarn {

namespace {

/// What a length in an instance's space is at most in the world.
float largestScale(const mat4& worldFromModel)
{
    const vec3 x(worldFromModel[0]), y(worldFromModel[1]), z(worldFromModel[2]);
    return std::sqrt(std::max({glm::dot(x, x), glm::dot(y, y), glm::dot(z, z)})); // rotation and scale only
}

} // namespace

Chunks listChunks(const Scene& scene, const std::vector<Instance>& instances, const std::vector<MeshDetail>& details)
{
    Chunks chunks;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instances[i].mesh)];
        for (const MeshPart& part : mesh.parts)
            chunks.all.push_back({static_cast<int>(i), instances[i].mesh, part.material, part.firstIndex,
                                  part.indexCount, part.bounds.transformed(instances[i].worldFromModel)});
    }
    chunks.full = chunks.all.size();
    if (details.empty()) return chunks;

    int firstFull = 0;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        const mat4& worldFromModel = instances[i].worldFromModel;
        const MeshDetail& detail = details[static_cast<std::size_t>(instances[i].mesh)];
        const auto parts = static_cast<int>(scene.meshes[static_cast<std::size_t>(instances[i].mesh)].parts.size());
        const int firstCoarse = static_cast<int>(chunks.all.size());
        const auto placed = [&](int node) {
            return node < 0 ? -1 : node < parts ? firstFull + node : firstCoarse + node - parts;
        };
        for (auto node = detail.nodes.begin() + parts; node != detail.nodes.end(); ++node)
            chunks.all.push_back({static_cast<int>(i),
                                  instances[i].mesh,
                                  node->material,
                                  node->firstIndex,
                                  node->indexCount,
                                  node->bounds.transformed(worldFromModel),
                                  node->error * largestScale(worldFromModel),
                                  {placed(node->finer[0]), placed(node->finer[1])}});
        for (const int root : detail.roots) chunks.coarsest.push_back(placed(root));
        firstFull += parts;
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

float allowedError(const View& view, const Chunk& chunk, const WaterBody* water, bool isUpright)
{
    if (view.geometryError <= 0.0f) return 0.0f;
    const float allowed =
        view.isParallel() ? view.geometryError : view.geometryError * distanceTo(view.eye, chunk.boundsW);
    if (!water) return allowed;
    switch (mediumOf(chunk.boundsW, *water, 0.0f)) {
    case Medium::air: return allowed;
    // Through a surface an eye in the air sees things nearer than they are, to 1/n of their distance straight below.
    case Medium::water: return view.flatWater ? allowed / water->ior : allowed;
    case Medium::both: break;
    }
    constexpr float beach = 0.1f; // slope of a gentle one: a height moves the shore ten times as far
    return isUpright ? allowed : allowed * beach;
}

namespace {

/// Goes down from the coarsest chunks, and stops where a view need not see more.
class VisibleChunks {
public:
    struct Entry {
        bool alphaTested;
        float distance;
        const Chunk* chunk;
    };

    VisibleChunks(const Chunks& chunks, const std::vector<Material>& materials, const View& view,
                  const WaterCover& cover, bool cull, const WaterBody* water)
        : chunks_(chunks), materials_(materials), view_(view), cover_(cover), frustum_(view.frustum()), cull_(cull),
          water_(water)
    {}

    std::vector<Entry> list()
    {
        entries_.reserve(chunks_.full);
        if (view_.geometryError > 0.0f && !chunks_.coarsest.empty())
            for (const int index : chunks_.coarsest) add(chunks_[index]);
        else
            for (std::size_t i = 0; i < chunks_.full; ++i) add(chunks_.all[i]);
        return std::move(entries_);
    }

private:
    bool isSeen(const Chunk& chunk) const
    {
        const Bounds shown = view_.flatWater ? seenThroughFlatWater(chunk.boundsW, *view_.flatWater) : chunk.boundsW;
        return frustum_.intersects(shown) && keptByPlane(view_.clipPlane, chunk.boundsW) &&
               !cover_.hides(view_.eye, chunk.boundsW);
    }

    void add(const Chunk& chunk)
    {
        if (cull_ && !isSeen(chunk)) return;
        const Material& material = materials_[static_cast<std::size_t>(chunk.material)];
        if (chunk.error > 0.0f && chunk.error > allowedError(view_, chunk, water_, material.alphaTested)) {
            for (const int finer : chunk.finer)
                if (finer >= 0) add(chunks_[finer]);
            return;
        }
        entries_.push_back({material.alphaTested, distanceTo(view_.eye, chunk.boundsW), &chunk});
    }

    const Chunks& chunks_;
    const std::vector<Material>& materials_;
    const View& view_;
    const WaterCover& cover_;
    const Frustum frustum_;
    const bool cull_;
    const WaterBody* water_;
    std::vector<Entry> entries_;
};

} // namespace

std::vector<const Chunk*> visibleChunks(const Chunks& chunks, const std::vector<Material>& materials, const View& view,
                                        const WaterCover& cover, bool cull, const WaterBody* water)
{
    using Entry = VisibleChunks::Entry;
    std::vector<Entry> entries = VisibleChunks(chunks, materials, view, cover, cull, water).list();
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        if (a.alphaTested != b.alphaTested) return b.alphaTested;
        return a.distance != b.distance ? a.distance < b.distance : a.chunk < b.chunk;
    });
    std::vector<const Chunk*> visible;
    visible.reserve(entries.size());
    for (const Entry& entry : entries) visible.push_back(entry.chunk);
    return visible;
}

bool mayShow(const View& view, const WaterCover& cover, const Bounds& boxW)
{
    const Bounds shown = view.flatWater ? seenThroughFlatWater(boxW, *view.flatWater) : boxW;
    return view.frustum().intersects(shown) && keptByPlane(view.clipPlane, boxW) && !cover.hides(view.eye, boxW);
}

} // namespace tarn
