#include "render/water_grid.h"

#include "render/visibility.h"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace tarn {

namespace {

constexpr int blocksPerSide = 16; // a draw call costs as much as some dozens of cells

int firstCell(int block, int cells, int blocks) { return block * cells / blocks; }

} // namespace

void WaterGrid::ensure(int size)
{
    if (size == size_) return;
    std::vector<vec2> vertices;
    vertices.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    for (int z = 0; z < size; ++z)
        for (int x = 0; x < size; ++x) vertices.emplace_back(static_cast<float>(x), static_cast<float>(z));
    std::vector<std::uint32_t> indices;
    indices.reserve(static_cast<std::size_t>(size - 1) * static_cast<std::size_t>(size - 1) * 6);
    const auto addCell = [&](int x, int z) {
        const auto corner = static_cast<std::uint32_t>(z * size + x);
        const auto below = corner + static_cast<std::uint32_t>(size);
        for (const std::uint32_t index : {corner, below, corner + 1, corner + 1, below, below + 1})
            indices.push_back(index);
    };
    const int cells = size - 1, blocks = std::min(blocksPerSide, cells);
    blocks_.clear();
    for (int blockZ = 0; blockZ < blocks; ++blockZ) {
        for (int blockX = 0; blockX < blocks; ++blockX) {
            Block block;
            block.firstIndex = static_cast<int>(indices.size());
            block.lower = {firstCell(blockX, cells, blocks), firstCell(blockZ, cells, blocks)};
            block.upper = {firstCell(blockX + 1, cells, blocks), firstCell(blockZ + 1, cells, blocks)};
            for (int z = block.lower.y; z < block.upper.y; ++z)
                for (int x = block.lower.x; x < block.upper.x; ++x) addCell(x, z);
            block.indexCount = static_cast<int>(indices.size()) - block.firstIndex;
            blocks_.push_back(block);
        }
    }
    vertices_ = gl::Buffer("water grid vertices");
    vertices_.upload(std::span<const vec2>(vertices));
    indices_ = gl::Buffer("water grid indices");
    indices_.upload(std::span<const std::uint32_t>(indices));
    grid_ = gl::VertexArray("water grid");
    grid_.attributes(vertices_, sizeof(vec2), {{0, 2, 0}});
    grid_.indices(indices_);
    size_ = size;
    indexCount_ = static_cast<int>(indices.size());
}

void WaterGrid::draw(int size, FrameReport::Pass& stats)
{
    ensure(size);
    grid_.drawIndexed(gl::Primitive::triangles, 0, indexCount_);
    stats.triangles += static_cast<std::size_t>(indexCount_) / 3;
    ++stats.drawCalls;
}

std::vector<WaterGrid::SeenBlock> WaterGrid::seenBlocks(int size, const Culling& culling)
{
    ensure(size);
    if (culling.occlusion) culling.occlusion->parts.count(blocks_.size());
    const auto position = [&](std::size_t axis, int line) {
        return static_cast<float>(optics64::gridPosition(culling.lines[axis], static_cast<double>(line)));
    };
    constexpr float room = 1.0e-3f; // m, for rounding
    std::vector<SeenBlock> seen;
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        const Block& block = blocks_[i];
        SeenBlock next{.index = i, .box = {}};
        next.box.lower = vec3(position(0, block.lower.x), culling.slab.lower.y, position(1, block.lower.y)) - room;
        next.box.upper = vec3(position(0, block.upper.x), culling.slab.upper.y, position(1, block.upper.y)) + room;
        if (culling.cull && !mayShow(culling.view, WaterCover{}, next.box)) continue;
        const vec3& eye = culling.view.eye;
        next.distance = glm::distance(eye, glm::clamp(eye, next.box.lower, next.box.upper));
        next.wasHidden = culling.occlusion && culling.occlusion->asks && culling.occlusion->parts.wasHidden(i) &&
                         OcclusionPass::canAsk(next.box, eye);
        seen.push_back(next);
    }
    std::sort(seen.begin(), seen.end(), [](const SeenBlock& a, const SeenBlock& b) {
        return a.distance != b.distance ? a.distance < b.distance : a.index < b.index;
    });
    return seen;
}

bool WaterGrid::askForHidden(const std::vector<SeenBlock>& seen, const Culling& culling) const
{
    Occlusion& occlusion = *culling.occlusion;
    std::size_t asked = 0;
    for (const SeenBlock& block : seen) {
        if (!block.wasHidden) continue;
        occlusion.boxes.ask(occlusion.parts.asked(block.index), block.box, culling.view.eye);
        ++asked;
    }
    occlusion.drawn += seen.size();
    occlusion.asked += asked;
    return asked > 0;
}

void WaterGrid::drawBlock(const SeenBlock& seen, Occlusion* occlusion, FrameReport::Pass& stats)
{
    const Block& block = blocks_[seen.index];
    std::optional<gl::VisibilityQuery::Condition> condition;
    std::optional<gl::VisibilityQuery::Scope> counting;
    if (seen.wasHidden) condition.emplace(occlusion->parts.asked(seen.index));
    if (occlusion) counting.emplace(occlusion->parts.drawn(seen.index));
    grid_.drawIndexed(gl::Primitive::triangles, block.firstIndex, block.indexCount);
    stats.triangles += static_cast<std::size_t>(block.indexCount) / 3;
    ++stats.drawCalls;
}

} // namespace tarn
