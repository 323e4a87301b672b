// Levels of detail are what they claim to be: no farther off than they say, without cracks, all of the mesh.
#include "nearest_surface.h"
#include "test_scenes.h"

#include "scene/mesh_collapse.h"
#include "scene/mesh_detail.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <set>

namespace tarn::test {

namespace {

constexpr int cells = 64;       // along an edge of the ground
constexpr float spacing = 0.5f; // m

float hilly(float x, float z)
{
    return 0.8f * std::sin(0.31f * x) * std::cos(0.23f * z) + 0.03f * std::sin(2.9f * x + z);
}

Mesh ground(const std::function<float(float, float)>& height, int strips)
{
    return groundMesh(height, cells, spacing, strips);
}

std::vector<std::uint32_t> indicesOf(const Mesh& mesh, const MeshDetail& detail, const DetailNode& node)
{
    std::vector<std::uint32_t> all = mesh.indices;
    all.insert(all.end(), detail.indices.begin(), detail.indices.end());
    const auto first = all.begin() + node.firstIndex;
    return {first, first + node.indexCount};
}

const std::vector<Material> solid{Material{}};

std::vector<vec3> positionsOf(const Mesh& mesh)
{
    std::vector<vec3> positions;
    for (const Vertex& vertex : mesh.vertices) positions.push_back(vertex.position);
    return positions;
}

/// The parts that a node stands for.
void partsUnder(const MeshDetail& detail, int node, std::multiset<int>& parts, int count)
{
    if (node < count) parts.insert(node);
    for (const int finer : detail.nodes[static_cast<std::size_t>(node)].finer)
        if (finer >= 0) partsUnder(detail, finer, parts, count);
}

} // namespace

TEST(NearestSurface, IsAsNearAsTheNearestOfManyPoints)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    const auto place = [&] { return vec3(unit(random), unit(random), unit(random)); };
    std::vector<vec3> positions;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < 3 * 20; ++i) {
        positions.push_back(place());
        indices.push_back(i);
    }
    const NearestSurface surface(positions, indices);
    for (int trial = 0; trial < 50; ++trial) {
        const vec3 from = 1.5f * place();
        const NearestSurface::Point point = surface.nearest(from);
        float sampled = 1e9f; // of a fine lattice of weights on every triangle
        constexpr int n = 40;
        for (std::size_t t = 0; t < 20; ++t)
            for (int a = 0; a <= n; ++a)
                for (int b = 0; a + b <= n; ++b) {
                    const vec3 w = vec3(a, b, n - a - b) / static_cast<float>(n);
                    sampled =
                        std::min(sampled, glm::distance(from, w.x * positions[3 * t] + w.y * positions[3 * t + 1] +
                                                                  w.z * positions[3 * t + 2]));
                }
        EXPECT_LE(point.distance, sampled + 1e-5f);
        EXPECT_GE(point.distance, sampled - 0.1f) << "the lattice is finer than that";
        const vec3 there = point.weights.x * positions[3 * point.triangle] +
                           point.weights.y * positions[3 * point.triangle + 1] +
                           point.weights.z * positions[3 * point.triangle + 2];
        EXPECT_NEAR(glm::distance(from, there), point.distance, 1e-5f);
        EXPECT_NEAR(point.weights.x + point.weights.y + point.weights.z, 1.0f, 1e-5f);
    }
}

TEST(Collapse, TellsHowFarVerticesAndMiddlesOfEdgesAreOff)
{
    const Mesh mesh = ground(hilly, 1);
    const std::vector<vec3> positions = positionsOf(mesh);
    const std::vector<float> noTexture(mesh.vertices.size(), 0.0f);
    for (const std::size_t share : {2u, 8u}) {
        const std::size_t target = mesh.indices.size() / 3 / share;
        const Collapsed coarse = collapse(mesh.vertices, mesh.indices, noTexture, target, target, true);
        EXPECT_LE(coarse.indices.size() / 3, target);
        const NearestSurface surface(positions, coarse.indices);
        float farthest = 0.0f;
        for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
            const vec3 a = positions[mesh.indices[i]], b = positions[mesh.indices[i % 3 == 2 ? i - 2 : i + 1]];
            for (const vec3& p : {a, 0.5f * (a + b)}) farthest = std::max(farthest, surface.nearest(p).distance);
        }
        EXPECT_LE(farthest, coarse.worst + 1e-5f);
        EXPECT_GT(farthest, 0.3f * coarse.worst) << "a bound that is far from reached costs triangles";
    }
}

TEST(Collapse, DoesNotTearWhatIsCutOutOfACard)
{
    // A flat square of quads without one in its corner, as where chunks cut a card.
    Mesh mesh;
    for (int j = 0; j <= 4; ++j)
        for (int i = 0; i <= 4; ++i) {
            const vec2 uv = 0.25f * vec2(ivec2(i, j));
            mesh.vertices.push_back({vec3(4.0f * uv, 0.0f), {0, 0, 1}, {1, 0, 0, 1}, uv});
        }
    for (std::uint32_t j = 0; j < 4; ++j)
        for (std::uint32_t i = 0; i < 4; ++i)
            if (i < 3 || j < 3)
                for (const std::uint32_t v :
                     {j * 5 + i, j * 5 + i + 1, j * 5 + i + 6, j * 5 + i, j * 5 + i + 6, j * 5 + i + 5})
                    mesh.indices.push_back(v);
    const std::vector<float> scales(mesh.vertices.size(), 4.0f);
    const Collapsed coarse = collapse(mesh.vertices, mesh.indices, scales, 8, 8, false);
    float area = 0.0f;
    for (std::size_t i = 0; i < coarse.indices.size(); i += 3) {
        const vec3 a = mesh.vertices[coarse.indices[i]].position;
        area += 0.5f * glm::length(glm::cross(mesh.vertices[coarse.indices[i + 1]].position - a,
                                              mesh.vertices[coarse.indices[i + 2]].position - a));
    }
    EXPECT_LE(coarse.indices.size() / 3, 8u);
    EXPECT_LT(coarse.worst, 1e-4f);
    EXPECT_NEAR(area, 15.0f, 1e-3f);
}

TEST(MeshDetail, NoNodeIsFartherOffThanItSays)
{
    const Mesh mesh = ground(hilly, 4);
    const MeshDetail detail = buildDetail(mesh, solid);
    const std::vector<vec3> positions = positionsOf(mesh);
    ASSERT_GT(detail.nodes.size(), 8u);
    for (std::size_t i = mesh.parts.size(); i < detail.nodes.size(); ++i) {
        const DetailNode& node = detail.nodes[i];
        const std::vector<std::uint32_t> coarse = indicesOf(mesh, detail, node);
        const NearestSurface surface(positions, coarse);
        std::multiset<int> parts;
        partsUnder(detail, static_cast<int>(i), parts, 4);
        float farthest = 0.0f;
        for (const int part : parts) {
            const DetailNode& full = detail.nodes[static_cast<std::size_t>(part)];
            const auto indices = indicesOf(mesh, detail, full);
            for (std::size_t k = 0; k + 2 < indices.size(); k += 3) {
                const vec3 a = positions[indices[k]], b = positions[indices[k + 1]], c = positions[indices[k + 2]];
                constexpr int steps = 6;
                for (int u = 0; u <= steps; ++u)
                    for (int v = 0; u + v <= steps; ++v) {
                        const vec3 w = vec3(u, v, steps - u - v) / static_cast<float>(steps);
                        farthest = std::max(farthest, surface.nearest(w.x * a + w.y * b + w.z * c).distance);
                    }
            }
        }
        EXPECT_LE(farthest, node.error + 1e-5f) << "node " << i << " of " << node.indexCount / 3 << " triangles";
        EXPECT_GT(node.error, 0.0f);
    }
}

TEST(MeshDetail, ErrorsGrowAndTrianglesShrinkTowardsTheRoots)
{
    const Mesh mesh = ground(hilly, 4);
    const MeshDetail detail = buildDetail(mesh, solid);
    for (const DetailNode& node : detail.nodes) {
        std::uint32_t below = 0;
        for (const int finer : node.finer) {
            if (finer < 0) continue;
            const DetailNode& under = detail.nodes[static_cast<std::size_t>(finer)];
            below += under.indexCount;
            EXPECT_GE(node.error, under.error);
            EXPECT_TRUE(glm::all(glm::lessThanEqual(node.bounds.lower, under.bounds.lower)));
            EXPECT_TRUE(glm::all(glm::greaterThanEqual(node.bounds.upper, under.bounds.upper)));
        }
        EXPECT_LE(node.indexCount, below == 0 ? node.indexCount : below * 3 / 4);
    }
    std::multiset<int> parts;
    for (const int root : detail.roots) partsUnder(detail, root, parts, 4);
    EXPECT_EQ(parts, (std::multiset<int>{0, 1, 2, 3}));
    ASSERT_EQ(detail.roots.size(), 1u);
    EXPECT_LT(detail.nodes[static_cast<std::size_t>(detail.roots[0])].indexCount, mesh.indices.size() / 8);
}

TEST(MeshDetail, LevelsMeetWithoutACrack)
{
    const Mesh mesh = ground(hilly, 8);
    const MeshDetail detail = buildDetail(mesh, solid);
    // Edges with one triangle, of the whole and of every mixture of a node with the full detail around it.
    using Edge = std::pair<std::uint32_t, std::uint32_t>;
    const auto openEdges = [&](const std::vector<std::uint32_t>& indices) {
        std::map<Edge, int> count;
        for (std::size_t i = 0; i < indices.size(); ++i) {
            const std::uint32_t a = indices[i], b = indices[i % 3 == 2 ? i - 2 : i + 1];
            ++count[{std::min(a, b), std::max(a, b)}];
        }
        std::set<Edge> open;
        for (const auto& [edge, triangles] : count)
            if (triangles == 1) open.insert(edge);
        return open;
    };
    const std::set<Edge> outline = openEdges(mesh.indices);
    EXPECT_EQ(outline.size(), static_cast<std::size_t>(4 * cells));
    for (std::size_t i = mesh.parts.size(); i < detail.nodes.size(); ++i) {
        std::multiset<int> coarse;
        partsUnder(detail, static_cast<int>(i), coarse, 8);
        std::vector<std::uint32_t> mixed = indicesOf(mesh, detail, detail.nodes[i]);
        for (int part = 0; part < 8; ++part) {
            if (coarse.contains(part)) continue;
            const auto full = indicesOf(mesh, detail, detail.nodes[static_cast<std::size_t>(part)]);
            mixed.insert(mixed.end(), full.begin(), full.end());
        }
        EXPECT_EQ(openEdges(mixed), outline) << "node " << i;
    }
}

TEST(MeshDetail, WhatIsFlatCostsNothingButItsColoursDo)
{
    const auto flat = [](float, float) { return 0.0f; };
    const Mesh plain = ground(flat, 1);
    const MeshDetail detail = buildDetail(plain, solid);
    ASSERT_GT(detail.nodes.size(), 1u);
    EXPECT_LT(detail.nodes.back().error, 1e-4f);

    Mesh speckled = ground(flat, 1);
    for (std::uint32_t i = 0; i < speckled.vertices.size(); ++i)
        speckled.vertices[i].colour = (i * 2654435761u >> 13) % 2 ? 0xffffffffu : 0xff000000u; // as good as by chance
    const MeshDetail told = buildDetail(speckled, solid);
    ASSERT_GT(told.nodes.size(), 2u);
    EXPECT_GT(told.nodes.back().error, 0.5f * spacing) << "black and white a step apart are not the same";
}

TEST(MeshDetail, CardsOfLeavesKeepTheirOutlines)
{
    // Sixteen bent cards of 8 x 8 quads that nothing joins.
    Mesh mesh;
    mesh.name = "leaves";
    for (int card = 0; card < 16; ++card) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (int j = 0; j <= 8; ++j)
            for (int i = 0; i <= 8; ++i) {
                const float u = static_cast<float>(i) / 8.0f, v = static_cast<float>(j) / 8.0f;
                const vec3 position(u + 1.5f * static_cast<float>(card), v, 0.02f * u * (1.0f - u));
                mesh.vertices.push_back({position, {0, 0, 1}, {1, 0, 0, 1}, {u, v}});
                mesh.bounds.add(position);
            }
        for (std::uint32_t j = 0; j < 8; ++j)
            for (std::uint32_t i = 0; i < 8; ++i)
                for (const std::uint32_t v :
                     {j * 9 + i, j * 9 + i + 1, j * 9 + i + 10, j * 9 + i, j * 9 + i + 10, j * 9 + i + 9})
                    mesh.indices.push_back(first + v);
    }
    mesh.parts = {{0, 0, static_cast<std::uint32_t>(mesh.indices.size()), mesh.bounds}};
    std::vector<Material> foliage(1);
    foliage[0].alphaTested = true;
    const MeshDetail detail = buildDetail(mesh, foliage);
    const DetailNode& coarsest = detail.nodes.back();
    EXPECT_LT(coarsest.indexCount, mesh.indices.size() / 8);
    EXPECT_LT(coarsest.error, 0.05f);
    float area = 0.0f;
    const auto indices = indicesOf(mesh, detail, coarsest);
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const vec3 a = mesh.vertices[indices[i]].position;
        area += 0.5f * glm::length(glm::cross(mesh.vertices[indices[i + 1]].position - a,
                                              mesh.vertices[indices[i + 2]].position - a));
    }
    EXPECT_NEAR(area, 16.0f, 0.32f) << "a crown keeps its cover";
}

} // namespace tarn::test
