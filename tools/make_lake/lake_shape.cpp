#include "lake_shape.h"

#include <array>

namespace tarn::lake {

namespace {

struct ShorePoint {
    float radius;       ///< m from the middle of the lake
    float beach, cliff; ///< the rest is bank
    float shelf;        ///< width of the shallow part, m
    float hill;         ///< height of the hills behind, m
};

// Every 22.5° from east (+x) through south (+z).
constexpr std::array<ShorePoint, 16> shorePoints{{
    {57.0f, 0.0f, 0.0f, 7.0f, 44.0f},  // E
    {59.0f, 0.2f, 0.0f, 8.0f, 40.0f},  // ESE
    {52.0f, 0.1f, 0.0f, 7.0f, 36.0f},  // SE
    {43.0f, 0.5f, 0.0f, 10.0f, 38.0f}, // SSE: the pier
    {37.0f, 1.0f, 0.0f, 15.0f, 38.0f}, // S: the beach
    {41.0f, 1.0f, 0.0f, 17.0f, 40.0f}, // SSW
    {50.0f, 0.5f, 0.0f, 12.0f, 46.0f}, // SW
    {61.0f, 0.2f, 0.0f, 13.0f, 48.0f}, // WSW: the reeds
    {65.0f, 0.2f, 0.0f, 14.0f, 52.0f}, // W
    {57.0f, 0.0f, 0.1f, 7.0f, 56.0f},  // WNW
    {49.0f, 0.0f, 1.0f, 3.0f, 60.0f},  // NW: the cliff
    {45.0f, 0.0f, 1.0f, 3.0f, 62.0f},  // NNW
    {47.0f, 0.0f, 0.2f, 5.0f, 60.0f},  // N
    {43.0f, 0.0f, 0.8f, 3.0f, 56.0f},  // NNE: a rocky head
    {51.0f, 0.1f, 0.1f, 6.0f, 52.0f},  // NE
    {61.0f, 0.7f, 0.0f, 11.0f, 48.0f}, // ENE: a small beach
}};

constexpr float deepest = 7.6f;

/// Catmull-Rom round the table.
template <typename Member> float around(float angle, Member member)
{
    const float position = angle / (2.0f * pi) * 16.0f + 16.0f;
    const float whole = std::floor(position), t = position - whole;
    const auto value = [&](int offset) {
        return shorePoints[static_cast<std::size_t>((static_cast<int>(whole) + offset) % 16)].*member;
    };
    const float a = value(-1), b = value(0), c = value(1), d = value(2);
    return b + 0.5f * t * (c - a + t * (2.0f * a - 5.0f * b + 4.0f * c - d + t * (3.0f * (b - c) + d - a)));
}

/// The larger of two heights with a rounded edge between them.
float smoothMax(float a, float b, float width)
{
    const float h = saturate(0.5f + 0.5f * (a - b) / width);
    return mix(b, a, h) + width * h * (1.0f - h);
}

} // namespace

float LakeShape::mainShore(vec2 p, ShoreKind& kind) const
{
    const float radius = glm::length(p), angle = std::atan2(p.y, p.x);
    kind.beach = saturate(around(angle, &ShorePoint::beach));
    kind.cliff = saturate(around(angle, &ShorePoint::cliff)) * (1.0f - kind.beach);
    kind.bank = 1.0f - kind.beach - kind.cliff;
    const float here = around(angle, &ShorePoint::radius);
    const float change = (around(angle + 0.02f, &ShorePoint::radius) - here) / 0.02f;
    const float rough = mix(1.0f, 0.35f, kind.beach);
    const float wander = rough * (2.6f * noise_.fractal(p / 15.0f, 3) + 0.7f * noise_.fractal(p / 3.1f, 2));
    return (radius - here) / std::sqrt(1.0f + change * change / (here * here)) + wander;
}

float LakeShape::basin(vec2 p, float shore, const ShoreKind& kind) const
{
    const float angle = std::atan2(p.y, p.x), inside = -shore;
    const float shelf = around(angle, &ShorePoint::shelf);
    const float shelfDepth = 1.05f * kind.beach + 1.0f * kind.bank + 2.8f * kind.cliff;
    const float along = saturate(inside / shelf);
    const float lip = 0.25f * noise_.at(p / 7.0f) * smoothStep(2.0f, 9.0f, inside);
    const float slopeLength = mix(17.0f, 10.0f, kind.cliff);
    const float fall = smoothStep(shelf * 0.85f, shelf + slopeLength, inside);
    const float floor = deepest + 0.8f * noise_.fractal(p / 18.0f, 3);
    const float shelfShape = shelfDepth * (1.0f - std::pow(1.0f - along, 1.5f));
    const float grain = 0.05f * noise_.fractal(p / 1.7f, 2) * smoothStep(0.3f, 4.0f, inside);
    return -mix(shelfShape + lip * along, floor, fall) + grain;
}

float LakeShape::land(vec2 p, float shore, const ShoreKind& kind) const
{
    const float angle = std::atan2(p.y, p.x);
    const float beach = 0.085f * std::min(shore, 7.0f) + 0.55f * smoothStep(4.5f, 9.0f, shore);
    const float bank = 0.85f * (1.0f - std::exp(-shore / 1.9f)) + 0.02f * std::min(shore, 12.0f);
    // A cliff of blocks: each stands out or back and is a little higher or lower; three ledges.
    const vec2 warped = p + 0.8f * vec2(noise_.at(p / 2.3f), noise_.at(p / 2.3f + 7.0f));
    const Cell block = noise_.cell(warped / 3.4f), chip = noise_.cell(warped / 1.5f);
    const float face = shore + 2.1f * (block.id - 0.5f) + 0.9f * (chip.id - 0.5f);
    const float top = 6.2f + 2.2f * noise_.at(p / 12.0f) + 1.3f * (block.id - 0.5f);
    const float step = 0.30f * smoothStep(0.2f, 0.9f, face) + 0.38f * smoothStep(1.9f, 2.6f, face) +
                       0.32f * smoothStep(3.5f, 4.4f, face);
    const float crumble = 0.35f * (chip.id - 0.5f) + 0.18f * noise_.fractal(p / 0.9f, 2);
    const float cliff =
        (top * step + crumble * smoothStep(0.0f, 0.6f, step)) * smoothStep(0.0f, 0.5f, shore) + 0.12f * shore;
    const float edge = beach * kind.beach + bank * kind.bank + std::min(cliff, top + 1.5f) * kind.cliff;

    const float roll = 0.75f + 0.45f * noise_.fractal(p / 85.0f, 3) + 0.12f * noise_.fractal(p / 24.0f, 2);
    const float rise = std::pow(smoothStep(8.0f, 215.0f, shore), 1.15f);
    const float hills = around(angle, &ShorePoint::hill) * roll * rise;
    const float meadow = 0.9f * noise_.fractal(p / 21.0f, 3) * smoothStep(6.0f, 26.0f, shore) +
                         0.045f * std::min(shore, 60.0f) * smoothStep(3.0f, 20.0f, shore);
    const float grain = 0.05f * noise_.fractal(p / 1.7f, 2) * smoothStep(0.3f, 4.0f, shore);
    return edge + hills + meadow + grain;
}

float LakeShape::island(vec2 p, float& shore) const
{
    // An ellipse turned by 25°, 12 x 8.5 m, steep to the north, with a spit to the south.
    const vec2 d = p - islandCentre;
    const vec2 q(0.906f * d.x + 0.423f * d.y, -0.423f * d.x + 0.906f * d.y);
    const float wander = 1.5f * noise_.fractal(p / 6.0f, 3) + 0.35f * noise_.at(p / 1.8f);
    const float reach = 1.0f + 0.3f * smoothStep(0.3f, 1.0f, q.y / 8.5f);
    shore = 9.5f * (glm::length(vec2(q.x / 12.0f, q.y / (8.5f * reach))) - 1.0f) + wander;
    const float steep = smoothStep(3.0f, -4.0f, q.y);
    if (shore < 0.0f) {
        const float in = -shore;
        return mix(0.28f, 0.85f, steep) * (1.0f - std::exp(-in / 1.2f)) * 1.5f + 0.13f * std::min(in, 8.0f) +
               0.25f * noise_.fractal(p / 2.5f, 2) * saturate(in);
    }
    const float shelf = mix(0.14f, 1.1f, steep);
    return -shelf * shore - 0.02f * shore * shore + 0.1f * noise_.fractal(p / 2.1f, 2) * saturate(shore);
}

Ground LakeShape::at(vec2 p) const
{
    Ground ground;
    ground.shore = mainShore(p, ground.kind);
    const float bottom = basin(p, std::min(ground.shore, 0.0f), ground.kind);
    ground.height = ground.shore > 0.0f ? land(p, ground.shore, ground.kind) : bottom;
    if (glm::length(p - islandCentre) > 32.0f) return ground;

    float fromIsland = 0.0f;
    const float islandHeight = island(p, fromIsland);
    ground.height = smoothMax(islandHeight, ground.height, 0.6f);
    if (-fromIsland > ground.shore) {
        ground.shore = -fromIsland;
        ground.kind = {0.3f, 0.7f, 0.0f};
    }
    return ground;
}

vec3 LakeShape::normal(vec2 p, float step) const
{
    const float dx = height(p + vec2(step, 0.0f)) - height(p - vec2(step, 0.0f));
    const float dz = height(p + vec2(0.0f, step)) - height(p - vec2(0.0f, step));
    return glm::normalize(vec3(-dx, 2.0f * step, -dz));
}

vec2 LakeShape::shoreAlong(vec2 origin, float angleDegrees) const
{
    const float angle = glm::radians(angleDegrees);
    const vec2 direction(std::cos(angle), std::sin(angle));
    float distance = 0.0f;
    while (distance < 150.0f && height(origin + distance * direction) < 0.0f) distance += 0.05f;
    return origin + distance * direction;
}

} // namespace tarn::lake
