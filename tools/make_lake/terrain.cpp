#include "terrain.h"

#include "rtin.h"

#include <algorithm>

namespace tarn::lake {

namespace {

constexpr int cells = 1024;
constexpr float neutral = 0.5f; // mean of the ground textures (textures.h)
constexpr float cellSize = 2.0f * terrainHalfSize / real(cells);

/// Heights and shore distances on the fine grid, with what is derived from them.
class Survey {
public:
    explicit Survey(const LakeShape& shape) : grounds_(static_cast<std::size_t>((cells + 1) * (cells + 1)))
    {
        for (int z = 0; z <= cells; ++z)
            for (int x = 0; x <= cells; ++x) grounds_[index(x, z)] = shape.at(place(x, z));
    }

    static vec2 place(int x, int z) { return vec2(real(x), real(z)) * cellSize - vec2(terrainHalfSize); }
    const Ground& at(int x, int z) const { return grounds_[index(std::clamp(x, 0, cells), std::clamp(z, 0, cells))]; }
    float height(int x, int z) const { return at(x, z).height; }

    vec3 normal(int x, int z, int step) const
    {
        const float dx = height(x + step, z) - height(x - step, z), dz = height(x, z + step) - height(x, z - step);
        return glm::normalize(vec3(-dx, 2.0f * real(step) * cellSize, -dz));
    }

    /// Share of the sky that the ground round about leaves open.
    float openness(int x, int z) const
    {
        constexpr int directions[8][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
        float sum = 0.0f;
        for (const auto& direction : directions) {
            float steepest = 0.0f;
            for (const int reach : {1, 2, 4, 8, 16, 32}) {
                const float rise = height(x + reach * direction[0], z + reach * direction[1]) - height(x, z);
                const float run =
                    real(reach) * cellSize * std::sqrt(real(std::abs(direction[0]) + std::abs(direction[1])));
                steepest = std::max(steepest, rise / run);
            }
            sum += 1.0f / (1.0f + steepest * steepest); // cos² of the horizon's height
        }
        return sum / 8.0f;
    }

private:
    static std::size_t index(int x, int z)
    {
        return static_cast<std::size_t>(z) * static_cast<std::size_t>(cells + 1) + static_cast<std::size_t>(x);
    }
    std::vector<Ground> grounds_;
};

/// Longest leg of a triangle that a place may have, m.
float wantedLeg(const Ground& ground)
{
    const float d = ground.shore;
    if (std::abs(d) < 4.5f || (ground.kind.cliff > 0.3f && d > 0.0f && d < 8.0f)) return 0.6f;
    if (d > -19.0f && d < 13.0f) return 1.2f;
    if (d < 36.0f) return 2.4f;
    return d < 70.0f ? 4.8f : 9.5f;
}

float tolerance(const Ground& ground)
{
    return 0.03f + 0.012f * std::abs(ground.shore) + 0.0001f * ground.shore * ground.shore;
}

enum class Zone { sand, pebbles, grass, forest, rock };
constexpr const char* zoneNames[] = {"sand", "pebbles", "grass", "forest", "rock"};
constexpr float tilesPerMetre[] = {1.0f / 3.0f, 1.0f / 2.5f, 1.0f / 3.0f, 1.0f / 3.5f, 1.0f / 4.0f};

/// What the ground is made of, as shares that add up to 1 in the order of Zone.
std::array<float, 5> composition(const Noise& noise, vec2 p, const Ground& ground, const vec3& normal)
{
    const float jitter = noise.fractal(p / 2.3f, 3), broad = noise.fractal(p / 11.0f, 3);
    const float steep = smoothStep(0.82f, 0.66f, normal.y + 0.05f * jitter);
    std::array<float, 5> share{};
    const float cliff = ground.kind.cliff * smoothStep(0.25f, 0.6f, ground.kind.cliff + 0.2f * jitter) *
                        smoothStep(9.0f, 4.0f, std::abs(ground.shore) + 2.0f * broad) *
                        std::max(smoothStep(0.96f, 0.86f, normal.y), smoothStep(1.2f, 0.4f, ground.height));
    share[4] = std::max(steep, cliff);
    const float rest = 1.0f - share[4];
    if (ground.height < 0.35f + 0.25f * jitter + 0.35f * ground.kind.beach && ground.shore < 8.0f + 3.0f * broad) {
        const float stony = smoothStep(0.55f, 0.15f, ground.kind.beach + 0.35f * broad + 0.1f * jitter) *
                            smoothStep(-6.0f, -2.5f, ground.shore + 2.0f * jitter);
        const float turf = ground.height > 0.0f
                               ? smoothStep(0.05f, 0.32f, ground.height - 0.5f * ground.kind.beach + 0.25f * jitter)
                               : 0.0f;
        share[2] = rest * turf;
        share[1] = rest * (1.0f - turf) * stony;
        share[0] = rest * (1.0f - turf) * (1.0f - stony);
    } else {
        share[3] = rest * smoothStep(13.0f, 21.0f, ground.shore + 9.0f * broad + 3.0f * jitter);
        share[2] = rest - share[3];
    }
    return share;
}

/// Reflectance of a place (linear): its zones' colours, drifting slowly, darker where it is wet.
vec3 reflectance(const Noise& noise, vec2 p, const Ground& ground, const std::array<float, 5>& share)
{
    const float slow = noise.fractal(p / 17.0f + 4.0f, 3), fast = noise.fractal(p / 3.7f, 3);
    const float sunk = smoothStep(0.8f, 5.5f, -ground.height + 0.5f * slow);
    const vec3 sand = mix(vec3(0.47f, 0.395f, 0.275f), vec3(0.40f, 0.345f, 0.25f), 0.5f + 0.5f * fast);
    const vec3 mud(0.155f, 0.14f, 0.10f);
    const vec3 meadow =
        mix(vec3(0.040f, 0.066f, 0.018f), vec3(0.098f, 0.100f, 0.034f), saturate(0.42f + 0.9f * slow + 0.7f * fast));
    const std::array<vec3, 5> colours{
        mix(sand, mud, 0.85f * sunk),
        mix(vec3(0.24f, 0.215f, 0.175f) * (1.0f + 0.25f * fast), mud, 0.8f * sunk),
        meadow,
        mix(vec3(0.062f, 0.050f, 0.033f), vec3(0.036f, 0.050f, 0.019f), saturate(0.55f + 1.2f * fast + 0.6f * slow)),
        mix(vec3(0.105f, 0.10f, 0.092f), vec3(0.20f, 0.188f, 0.168f), saturate(0.5f + 1.3f * fast)) *
            mix(1.0f, 0.6f, sunk),
    };
    vec3 colour(0.0f);
    for (std::size_t zone = 0; zone < 5; ++zone) colour += share[zone] * colours[zone];
    const float wet = smoothStep(0.20f, 0.06f, ground.height + 0.05f * fast);
    return colour * mix(1.0f, 0.70f, wet);
}

float shadeAt(vec2 p, const std::vector<Shade>& shades)
{
    float open = 1.0f;
    for (const Shade& shade : shades) {
        const vec2 d = p - shade.centre;
        const float q = glm::dot(d, d) / (shade.radius * shade.radius);
        if (q < 1.0f) open *= 1.0f - shade.strength * (1.0f - q) * (1.0f - q);
    }
    return std::max(open, 0.25f);
}

} // namespace

Mesh makeTerrain(const LakeShape& shape, const std::vector<Shade>& shades, std::uint32_t seed)
{
    const Survey survey(shape);
    const Noise noise(seed);
    Rtin rtin(cells, [&](int x, int z) { return survey.height(x, z); });
    const auto triangles = rtin.triangulate([&](int x, int z, float leg, float error) {
        const Ground& ground = survey.at(x, z);
        return leg * cellSize > 1.01f * wantedLeg(ground) || error > tolerance(ground);
    });

    Mesh mesh;
    std::vector<int> vertexOf(static_cast<std::size_t>((cells + 1) * (cells + 1)), -1);
    std::vector<std::array<float, 5>> shares;
    const auto vertex = [&](ivec2 g) {
        int& slot = vertexOf[static_cast<std::size_t>(g.y * (cells + 1) + g.x)];
        if (slot >= 0) return slot;
        const Ground& ground = survey.at(g.x, g.y);
        const vec2 p = Survey::place(g.x, g.y);
        const vec3 normal = survey.normal(g.x, g.y, wantedLeg(ground) < 1.0f ? 1 : (wantedLeg(ground) < 4.0f ? 2 : 4));
        shares.push_back(composition(noise, p, ground, normal));
        const float light = survey.openness(g.x, g.y) * shadeAt(p, shades);
        slot = mesh.addPosition(vec3(p.x, ground.height, p.y),
                                reflectance(noise, p, ground, shares.back()) / neutral * light);
        mesh.addNormal(normal);
        return slot;
    };
    for (const auto& triangle : triangles) {
        const std::array<int, 3> v{vertex(triangle[0]), vertex(triangle[1]), vertex(triangle[2])};
        std::size_t zone = 0;
        float best = -1.0f;
        for (std::size_t z = 0; z < 5; ++z) {
            float sum = 0.0f;
            for (const int corner : v) sum += shares[static_cast<std::size_t>(corner)][z];
            if (sum > best) best = sum, zone = z;
        }
        mesh.use(zoneNames[zone]);
        const auto at = [&](std::size_t k) { return mesh.positions[static_cast<std::size_t>(v[k])]; };
        const auto uvs = boxUvs(at(0), at(1), at(2), tilesPerMetre[zone]);
        std::array<Corner, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) corners[k] = {v[k], mesh.addUv(uvs[k]), v[k]};
        mesh.triangle(corners[0], corners[1], corners[2]);
    }
    return mesh;
}

Mesh makeMountains(std::uint32_t seed)
{
    // Rings of a polar grid. The distance makes them pale: the haze is part of their colour.
    const Noise noise(seed);
    constexpr int around = 160, rings = 9;
    Mesh mesh;
    mesh.use("mountains");
    std::vector<vec3> positions;
    std::vector<std::array<int, 3>> triangles;
    for (int ring = 0; ring < rings; ++ring) {
        const float t = real(ring) / real(rings - 1), radius = mix(330.0f, 880.0f, t);
        for (int k = 0; k < around; ++k) {
            const float turn = 2.0f * pi * real(k) / real(around);
            const vec2 p = radius * vec2(std::cos(turn), std::sin(turn));
            const float north = 0.5f - 0.5f * std::sin(turn + 0.5f);
            const float crest = noise.ridges(p / 260.0f, 4);
            const float rise = smoothStep(0.0f, 0.62f, t) * mix(1.0f, 0.35f, smoothStep(0.7f, 1.0f, t));
            positions.emplace_back(p.x, 5.0f + rise * (50.0f + 165.0f * crest * (0.45f + 0.75f * north)), p.y);
        }
    }
    for (int ring = 0; ring + 1 < rings; ++ring) {
        for (int k = 0; k < around; ++k) {
            const int a = ring * around + k, b = ring * around + (k + 1) % around, c = a + around, d = b + around;
            triangles.push_back({a, b, d});
            triangles.push_back({a, d, c});
        }
    }
    const std::vector<vec3> normals = smoothNormals(positions, triangles);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const vec3 bare = mix(vec3(0.20f, 0.21f, 0.22f), vec3(0.10f, 0.13f, 0.10f),
                              smoothStep(0.72f, 0.9f, normals[i].y) * smoothStep(190.0f, 90.0f, positions[i].y));
        mesh.addPosition(positions[i], bare / neutral);
        mesh.addNormal(normals[i]);
    }
    for (const auto& t : triangles) {
        const auto at = [&](std::size_t k) { return positions[static_cast<std::size_t>(t[k])]; };
        const auto uvs = boxUvs(at(0), at(1), at(2), 1.0f / 210.0f);
        mesh.triangle({t[0], mesh.addUv(uvs[0]), t[0]}, {t[1], mesh.addUv(uvs[1]), t[1]},
                      {t[2], mesh.addUv(uvs[2]), t[2]});
    }
    return mesh;
}

} // namespace tarn::lake
