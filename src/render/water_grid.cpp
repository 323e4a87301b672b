#include "render/water_grid.h"

#include <cstdint>
#include <vector>

namespace tarn {

void WaterGrid::ensure(int size)
{
    if (size == size_) return;
    std::vector<vec2> vertices;
    vertices.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    for (int z = 0; z < size; ++z)
        for (int x = 0; x < size; ++x)
            vertices.emplace_back(static_cast<float>(x), static_cast<float>(z));
    std::vector<std::uint32_t> indices;
    indices.reserve(static_cast<std::size_t>(size - 1) * static_cast<std::size_t>(size - 1) * 6);
    for (int z = 0; z + 1 < size; ++z) {
        for (int x = 0; x + 1 < size; ++x) {
            const auto corner = static_cast<std::uint32_t>(z * size + x);
            const auto below = corner + static_cast<std::uint32_t>(size);
            for (const std::uint32_t index : {corner, below, corner + 1, corner + 1, below, below + 1})
                indices.push_back(index);
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

void WaterGrid::draw(int size, FrameStats::Pass& stats)
{
    ensure(size);
    grid_.drawIndexed(gl::Primitive::triangles, 0, indexCount_);
    stats.triangles += static_cast<std::size_t>(indexCount_) / 3;
    ++stats.drawCalls;
}

} // namespace tarn
