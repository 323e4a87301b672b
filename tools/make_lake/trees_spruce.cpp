#include "trees.h"

namespace tarn::lake {

namespace {

constexpr vec3 upward{0.0f, 1.0f, 0.0f};

/// One branch: a strip of two by two (or two by one) quads like a gable roof, its ridge drooping towards the
/// tip.
struct Branch {
    vec3 foot;
    vec3 outward; ///< horizontal, unit
    float length, width;
    float rise;  ///< slope at the trunk
    float droop; ///< how far the tip hangs below that line, per length
    float light; ///< of the whole branch
    int rows = 2;
};

void addBranch(Mesh& mesh, const Branch& branch)
{
    const vec3 side = glm::cross(branch.outward, upward);
    std::vector<std::array<Corner, 3>> rows;
    for (int row = 0; row <= branch.rows; ++row) {
        const float t = real(row) / real(branch.rows);
        const vec3 ridge =
            branch.foot + branch.length * (t * branch.outward + (branch.rise * t - branch.droop * t * t) * upward);
        const float light = branch.light * mix(0.34f, 1.0f, smoothStep(0.0f, 0.85f, t));
        std::array<Corner, 3> corners;
        for (int column = -1; column <= 1; ++column) {
            const float across = real(column);
            const vec3 position =
                ridge + 0.5f * branch.width * (0.9f * across * side - std::abs(across) * 0.72f * upward);
            const vec3 normal = 0.75f * branch.outward * (0.4f + 0.6f * t) + 0.55f * upward + 0.5f * across * side;
            corners[static_cast<std::size_t>(column + 1)] =
                mesh.add(position, normal, {0.5f + 0.5f * across, 0.02f + 0.97f * t},
                         vec3(light * (column == 0 ? 1.0f : 0.92f)));
        }
        rows.push_back(corners);
    }
    for (std::size_t row = 0; row + 1 < rows.size(); ++row)
        for (std::size_t column = 0; column < 2; ++column)
            mesh.quad(rows[row][column], rows[row][column + 1], rows[row + 1][column + 1], rows[row + 1][column]);
}

void addLeader(Mesh& mesh, float height, float length)
{
    for (int k = 0; k < 2; ++k) {
        const float turn = 0.5f * pi * real(k) + 0.4f;
        const vec3 side(std::cos(turn), 0.0f, std::sin(turn));
        const vec3 low(0.0f, height - length, 0.0f), high(0.0f, height + 0.02f * length, 0.0f);
        const float half = 0.24f * length;
        const vec3 light(0.95f);
        mesh.quad(mesh.add(low - half * side, -side + 0.6f * upward, {0.0f, 0.35f}, 0.8f * light),
                  mesh.add(low + half * side, side + 0.6f * upward, {1.0f, 0.35f}, 0.8f * light),
                  mesh.add(high + half * side, side + upward, {1.0f, 1.0f}, light),
                  mesh.add(high - half * side, -side + upward, {0.0f, 1.0f}, light));
    }
}

void addTrunk(Mesh& mesh, const SpruceShape& shape, Random& random)
{
    mesh.use("bark");
    const float foot = 0.0165f * shape.height;
    const vec2 lean = 0.012f * shape.height * vec2(random.sign(), random.sign());
    std::vector<TubeRing> rings;
    for (const float t : {-0.03f, 0.0f, 0.03f, 0.2f, 0.5f, 0.97f}) {
        const float flare = t < 0.02f ? 1.35f : 1.0f;
        rings.push_back(
            {{lean.x * t * (1.0f - t), t * shape.height, lean.y * t * (1.0f - t)}, foot * flare * (1.02f - t)});
    }
    TubeStyle style{.sides = 7, .uvRound = 1.0f, .uvPerMetre = 0.6f, .capStart = false, .capEnd = false};
    style.colour = [&](const vec3& p) {
        const float inCrown = smoothStep(0.0f, 0.25f, p.y / shape.height - shape.clear);
        return vec3(mix(0.85f, 0.35f, inCrown) * smoothStep(-0.4f, 0.6f, p.y));
    };
    addTube(mesh, rings, style);
}

} // namespace

Mesh makeSpruce(const SpruceShape& shape, Random random)
{
    Mesh mesh;
    addTrunk(mesh, shape, random);
    mesh.use("needles");
    float turn = random.angle();
    for (int k = 0; k < shape.branches; ++k) {
        // Closer together towards the top, as the years' growth gets shorter; turned by the golden angle.
        const float s = real(k) / real(shape.branches);
        const float t =
            shape.clear + (0.955f - shape.clear) * (1.0f - std::pow(1.0f - s, 1.25f)) + 0.008f * random.sign();
        turn += 2.39996f + 0.25f * random.sign();
        const float up = (t - shape.clear) / (1.0f - shape.clear);
        const float profile = std::pow(1.0f - up, 0.86f) * (1.0f - 0.25f * smoothStep(0.16f, 0.0f, up));
        const float length = shape.height * (shape.spread * profile + 0.018f) * random.range(0.78f, 1.1f);
        Branch branch;
        branch.foot = {0.0f, t * shape.height, 0.0f};
        branch.outward = {std::cos(turn), 0.0f, std::sin(turn)};
        branch.length = length;
        branch.width = std::min(length * random.range(0.85f, 1.05f), 0.40f * length + 0.75f);
        branch.rise = mix(0.02f, 0.75f, up * up) + 0.10f * random.sign();
        branch.droop = mix(0.50f, 0.22f, up) * random.range(0.7f, 1.2f);
        branch.light = mix(0.66f, 1.0f, smoothStep(0.0f, 0.75f, up)) * random.range(0.85f, 1.05f);
        branch.rows = up < 0.34f ? 2 : 1;
        addBranch(mesh, branch);
    }
    addLeader(mesh, shape.height, 0.085f * shape.height + 0.25f);
    return mesh;
}

} // namespace tarn::lake
