#include "trees.h"

namespace tarn::lake {

namespace {

constexpr vec3 upward{0.0f, 1.0f, 0.0f};

struct Clump {
    vec3 centre;
    float radius;
};

struct Crown {
    vec3 centre;
    vec3 radii;
    /// 0 in the middle, 1 at the skin.
    float depth(const vec3& p) const { return glm::length((p - centre) / radii); }
};

/// A square of leaves; `out` is the way it faces, more or less.
void addCard(Mesh& mesh, const Crown& crown, const vec3& centre, const vec3& out, float size, const vec3& tint,
             Random& random)
{
    const vec3 facing = glm::normalize(out + 0.75f * random.direction());
    vec3 side = glm::cross(facing, std::abs(facing.y) > 0.95f ? vec3(1, 0, 0) : upward);
    side = glm::normalize(side);
    const vec3 other = glm::cross(facing, side);
    const float roll = random.angle(), half = 0.5f * size;
    const vec3 u = half * (std::cos(roll) * side + std::sin(roll) * other), v = glm::cross(facing, u);
    const bool mirrored = random.unit() < 0.5f;
    const vec3 tone = tint * random.range(0.80f, 1.06f), stray = 0.3f * random.direction();
    const auto corner = [&](float a, float b) {
        const vec3 p = centre + a * u + b * v;
        const vec3 fromCrown = glm::normalize((p - crown.centre) / crown.radii);
        const float deep = smoothStep(0.25f, 1.05f, crown.depth(p));
        const float low = mix(0.72f, 1.0f, smoothStep(-0.9f, 0.5f, fromCrown.y * crown.depth(p)));
        const vec3 normal = 0.6f * fromCrown + 0.45f * out + 0.45f * upward + stray;
        const float ownShade =
            mix(0.70f, 1.0f, smoothStep(-0.8f, 0.6f, glm::dot(out, glm::normalize(fromCrown + upward))));
        return mesh.add(p, normal, {0.5f + (mirrored ? -0.5f : 0.5f) * a, 0.5f + 0.5f * b},
                        tone * (mix(0.40f, 1.0f, deep) * low * ownShade));
    };
    const Corner a = corner(-1, -1), b = corner(1, -1), c = corner(1, 1), d = corner(-1, 1);
    mesh.quad(a, b, c, d);
}

void addClump(Mesh& mesh, const Crown& crown, const Clump& clump, int cards, float size, const vec3& tint,
              Random& random)
{
    const vec3 tone = tint * random.range(0.82f, 1.1f);
    for (int k = 0; k < cards; ++k) {
        // Evenly round the clump, fewer underneath.
        const float y = 1.0f - 1.7f * (real(k) + 0.5f) / real(cards);
        const float turn = 2.39996f * real(k) + random.angle() * 0.15f, r = std::sqrt(std::max(0.0f, 1.0f - y * y));
        const vec3 out(r * std::cos(turn), y, r * std::sin(turn));
        addCard(mesh, crown, clump.centre + random.range(0.45f, 1.1f) * clump.radius * out * vec3(1.0f, 0.8f, 1.0f),
                out, size * random.range(0.8f, 1.2f), tone, random);
    }
}

/// A bent bar from a to b that sags or rises in the middle.
void addLimb(Mesh& mesh, const vec3& a, const vec3& b, float radiusA, float radiusB, float bend, int sides, float light)
{
    std::vector<TubeRing> rings;
    for (const float t : {0.0f, 0.45f, 1.0f}) {
        if (sides < 4 && t > 0.0f && t < 1.0f) continue; // twigs are straight
        rings.push_back({mix(a, b, t) + vec3(0.0f, bend * t * (1.0f - t), 0.0f), mix(radiusA, radiusB, t)});
    }
    TubeStyle style{.sides = sides, .uvRound = 0.5f, .uvPerMetre = 0.6f, .capStart = false, .capEnd = false};
    style.colour = [light](const vec3&) { return vec3(light); };
    addTube(mesh, rings, style);
}

void addTrunk(Mesh& mesh, const vec3& fork, float foot)
{
    std::vector<TubeRing> rings;
    for (const float t : {-0.12f, 0.0f, 0.12f, 0.5f, 1.0f}) {
        const float flare = 1.0f + 0.55f * smoothStep(0.14f, -0.05f, t);
        rings.push_back({{fork.x * t * t, t * fork.y, fork.z * t * t}, foot * flare * (1.0f - 0.35f * t)});
    }
    TubeStyle style{.sides = 8, .uvRound = 1.0f, .uvPerMetre = 0.5f, .capStart = false, .capEnd = false};
    style.colour = [&](const vec3& p) {
        return vec3(mix(0.95f, 0.5f, smoothStep(0.7f, 1.4f, p.y / fork.y)) * smoothStep(-0.5f, 0.5f, p.y));
    };
    addTube(mesh, rings, style);
}

} // namespace

Mesh makeBroadleaf(const BroadShape& shape, Random random)
{
    Mesh mesh;
    mesh.use(shape.birch ? "birch" : "bark");
    const float h = shape.height, foot = (shape.birch ? 0.0135f : 0.021f) * h;
    const vec3 fork(0.03f * h * random.sign(), shape.fork * h, 0.03f * h * random.sign());
    addTrunk(mesh, fork, foot);
    const Crown crown{{0.5f * fork.x, 0.5f * (shape.fork + 0.92f) * h, 0.5f * fork.z},
                      {shape.spread * h, 0.5f * (1.06f - shape.fork) * h, shape.spread * h}};

    // A leader goes on to the top; limbs leave it in a spiral, twigs leave the limbs, each ends in a clump.
    const vec3 top(fork.x + 0.03f * h * random.sign(), 0.86f * h, fork.z + 0.03f * h * random.sign());
    addLimb(mesh, fork, top, 0.62f * foot, 0.15f * foot, 0.0f, 6, 0.5f);
    std::vector<Clump> clumps{{top, shape.clump * h}};
    float turn = random.angle();
    for (int limb = 0; limb < shape.limbs; ++limb) {
        const float s = (real(limb) + 0.3f * random.unit()) / real(shape.limbs);
        const vec3 start = mix(fork, top, 0.75f * s);
        turn += 2.39996f + 0.3f * random.sign();
        const float reach = shape.spread * h * (0.82f - 0.42f * s * s) * random.range(0.85f, 1.1f);
        const vec3 out(std::cos(turn), 0.0f, std::sin(turn));
        const vec3 end = start + reach * out + vec3(0.0f, h * (mix(0.14f, 0.20f, s) - shape.droop), 0.0f);
        const float radius = foot * mix(0.48f, 0.25f, s);
        addLimb(mesh, start, end, radius, 0.35f * radius, (shape.birch ? 0.08f : -0.03f) * h, 5, 0.55f);
        clumps.push_back({end, shape.clump * h * random.range(0.75f, 1.15f)});
        for (int twig = 0; twig < shape.twigsPerLimb; ++twig) {
            const float t = 0.45f + 0.45f * real(twig) / real(shape.twigsPerLimb);
            const float swing = turn + (twig % 2 == 0 ? 0.8f : -0.8f) + 0.3f * random.sign();
            const vec3 from = mix(start, end, t);
            const vec3 to =
                from + 0.55f * reach *
                           vec3(std::cos(swing), 0.35f - 2.0f * shape.droop + 0.25f * random.sign(), std::sin(swing));
            addLimb(mesh, from, to, 0.4f * radius, 0.12f * radius, 0.0f, 3, 0.5f);
            clumps.push_back({to, shape.clump * h * random.range(0.6f, 1.0f)});
        }
    }
    mesh.use("leaves");
    for (const Clump& clump : clumps)
        addClump(mesh, crown, clump, shape.cardsPerClump, 1.45f * clump.radius, shape.tint, random);
    return mesh;
}

Mesh makeBush(float size, const vec3& tint, Random random)
{
    Mesh mesh;
    mesh.use("leaves");
    const Crown crown{{0.0f, 0.3f * size, 0.0f}, vec3(0.75f, 0.72f, 0.75f) * size};
    for (int k = 0; k < 5; ++k) {
        const float turn = 2.39996f * real(k) + 0.5f * random.sign(), reach = (k == 0 ? 0.0f : 0.42f) * size;
        const Clump clump{
            {reach * std::cos(turn), size * random.range(0.3f, 0.5f) * (k == 0 ? 1.35f : 1.0f), reach * std::sin(turn)},
            0.42f * size};
        addClump(mesh, crown, clump, 7, 0.72f * size, tint, random);
    }
    return mesh;
}

} // namespace tarn::lake
