#include "scene/mesh_detail.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace tarn {

namespace {

constexpr float worthwhile = 0.75f;           // of the triangles must do for a node to be kept
constexpr std::uint32_t fewestTriangles = 64; // a draw call costs as much

/// The nodes of one mesh while they are made.
class DetailBuilder {
public:
    DetailBuilder(const Mesh& mesh, const std::vector<Material>& materials) : mesh_(mesh), materials_(materials)
    {
        for (const MeshPart& part : mesh.parts)
            detail_.nodes.push_back({part.material, part.firstIndex, part.indexCount, part.bounds});
    }

    MeshDetail build()
    {
        const auto parts = static_cast<int>(mesh_.parts.size());
        for (int begin = 0, end = 0; begin < parts; begin = end) {
            while (end < parts && mesh_.parts[at(end)].material == mesh_.parts[at(begin)].material) ++end;
            std::vector<int> level;
            for (int part = begin; part < end; ++part) level.push_back(part);
            while (level.size() > 1) level = pairedUp(level);
            if (!level.empty()) addChain(level.front());
        }
        return std::move(detail_);
    }

private:
    static std::size_t at(int index) { return static_cast<std::size_t>(index); }

    /// One node for each two of a level. Two that are not worth putting together become roots.
    std::vector<int> pairedUp(const std::vector<int>& level)
    {
        const std::size_t pairs = level.size() / 2;
        std::vector<Simplified> made(pairs);
        tbb::parallel_for(std::size_t{0}, pairs, [&](std::size_t i) {
            made[i] = coarser({level[2 * i], level[2 * i + 1]});
        });
        std::vector<int> next;
        for (std::size_t i = 0; i < pairs; ++i) {
            const std::array<int, 2> finer{level[2 * i], level[2 * i + 1]};
            if (const int node = added(finer, std::move(made[i])); node >= 0)
                next.push_back(node);
            else
                detail_.roots.insert(detail_.roots.end(), finer.begin(), finer.end());
        }
        if (level.size() % 2 == 1) next.push_back(level.back());
        return next;
    }

    /// Coarser and coarser nodes above one, alone.
    void addChain(int node)
    {
        while (detail_.nodes[at(node)].indexCount > 3 * fewestTriangles) {
            const int next = added({node, -1}, coarser({node, -1}));
            if (next < 0) break;
            node = next;
        }
        detail_.roots.push_back(node);
    }

    Simplified coarser(const std::array<int, 2>& finer) const
    {
        std::vector<std::uint32_t> indices;
        for (const int index : finer) {
            if (index < 0) continue;
            const DetailNode& node = detail_.nodes[at(index)];
            const bool isPart = node.firstIndex < mesh_.indices.size();
            const auto first = isPart ? mesh_.indices.begin() + node.firstIndex
                                      : detail_.indices.begin() + (node.firstIndex - mesh_.indices.size());
            indices.insert(indices.end(), first, first + node.indexCount);
        }
        const Material& material = materials_[at(detail_.nodes[at(finer[0])].material)];
        return halved(mesh_, indices, !material.alphaTested);
    }

    /// The new node's index, or -1 when it would be of no use.
    int added(const std::array<int, 2>& finer, Simplified made)
    {
        DetailNode node = detail_.nodes[at(finer[0])];
        node.finer = finer;
        std::uint32_t before = node.indexCount;
        if (finer[1] >= 0) {
            const DetailNode& second = detail_.nodes[at(finer[1])];
            before += second.indexCount;
            node.bounds.add(second.bounds);
            node.error = std::max(node.error, second.error);
        }
        if (static_cast<float>(made.indices.size()) > worthwhile * static_cast<float>(before)) return -1;
        node.error += made.error; // distances to what was off already
        node.firstIndex = static_cast<std::uint32_t>(mesh_.indices.size() + detail_.indices.size());
        node.indexCount = static_cast<std::uint32_t>(made.indices.size());
        detail_.indices.insert(detail_.indices.end(), made.indices.begin(), made.indices.end());
        detail_.nodes.push_back(node);
        return static_cast<int>(detail_.nodes.size()) - 1;
    }

    const Mesh& mesh_;
    const std::vector<Material>& materials_;
    MeshDetail detail_;
};

} // namespace

MeshDetail buildDetail(const Mesh& mesh, const std::vector<Material>& materials)
{
    return DetailBuilder(mesh, materials).build();
}

} // namespace tarn
