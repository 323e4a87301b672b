#include "plants.h"

namespace tarn::lake {

namespace {

struct Card {
    vec3 foot;
    float turn, width, height;
    vec2 lean{0.0f}; ///< how far the upper edge is moved, m
    vec3 low{1.0f}, high{1.0f};
    vec3 normal{0.0f, 1.0f, 0.0f};
    vec2 uvLower{0.0f}, uvUpper{1.0f};
    int rows = 1;
};

/// An upright card that bends as it rises.
void addCard(Mesh& mesh, const Card& card)
{
    const vec3 side(std::cos(card.turn), 0.0f, std::sin(card.turn));
    std::vector<std::array<Corner, 2>> rows;
    for (int row = 0; row <= card.rows; ++row) {
        const float t = real(row) / real(card.rows);
        const vec3 middle = card.foot + vec3(card.lean.x * t * t, card.height * t, card.lean.y * t * t);
        const vec3 colour = mix(card.low, card.high, t);
        std::array<Corner, 2> corners;
        for (int k = 0; k < 2; ++k) {
            const float across = real(2 * k - 1);
            corners[static_cast<std::size_t>(k)] = mesh.add(
                middle + 0.5f * card.width * across * side, card.normal + 0.3f * across * side,
                {mix(card.uvLower.x, card.uvUpper.x, real(k)), mix(card.uvLower.y, card.uvUpper.y, t)}, colour);
        }
        rows.push_back(corners);
    }
    for (std::size_t row = 0; row + 1 < rows.size(); ++row)
        mesh.quad(rows[row][0], rows[row][1], rows[row + 1][1], rows[row + 1][0]);
}

} // namespace

Mesh makeReeds(const LakeShape& shape, const std::vector<View>& views, Random random)
{
    const Noise noise(random.next());
    Mesh mesh;
    mesh.use("reeds");
    int clumps = 0;
    for (int tries = 0; tries < 40000 && clumps < 420; ++tries) {
        const vec2 p(random.range(-72.0f, 68.0f), random.range(-55.0f, 50.0f));
        const Ground ground = shape.at(p);
        if (ground.height > 0.12f || ground.height < -0.95f || glm::length(p - islandCentre) < 20.0f) continue;
        const float west = smoothStep(-38.0f, -50.0f, p.x), patch = noise.fractal(p / 8.0f, 2);
        const float wanted = (0.9f * west + 0.28f) * smoothStep(0.05f, 0.35f, patch + 0.45f * west) *
                             (1.0f - 0.8f * ground.kind.beach * (1.0f - west));
        if (random.unit() > wanted || blocksView(views, p, 1.0f, Growth::low)) continue;
        const float height = random.range(1.5f, 2.2f) - ground.height;
        const float tone = random.range(0.7f, 1.0f), first = random.angle();
        for (int k = 0; k < 3; ++k) {
            Card card;
            card.foot = shape.onGround(p + 0.18f * vec2(random.sign(), random.sign())) - vec3(0.0f, 0.04f, 0.0f);
            card.turn = first + pi / 3.0f * real(k);
            card.width = height * random.range(0.5f, 0.65f);
            card.height = height * random.range(0.85f, 1.05f);
            card.lean = 0.22f * vec2(0.5f + random.unit(), random.sign());
            card.low = vec3(0.42f * tone);
            card.high = vec3(tone);
            card.normal = vec3(0.25f * random.sign(), 1.0f, 0.25f * random.sign());
            card.rows = 2;
            addCard(mesh, card);
        }
        ++clumps;
    }
    return mesh;
}

Mesh makeGrass(const LakeShape& shape, const std::vector<View>& views, Random random)
{
    const Noise noise(random.next());
    Mesh mesh;
    mesh.use("blades");
    int tufts = 0;
    const vec2 eye(views.front().eye.x, views.front().eye.z);
    const vec2 ahead = glm::normalize(vec2(views.front().target.x, views.front().target.z) - eye);
    for (int tries = 0; tries < 120000 && tufts < 2400; ++tries) {
        // A third in front of the first camera, so that its foreground is a meadow.
        const bool foreground = tufts < 900;
        const float reach = random.range(4.0f, 26.0f);
        const vec2 p = foreground ? eye + reach * (ahead + 1.0f * random.sign() * vec2(-ahead.y, ahead.x))
                                  : vec2(random.range(-85.0f, 80.0f), random.range(-62.0f, 62.0f));
        const Ground ground = shape.at(p);
        if (ground.height < 0.14f + 0.75f * ground.kind.beach || (ground.shore > 15.0f && !foreground)) continue;
        const float patch = noise.fractal(p / 4.0f, 3);
        const float sandy = ground.kind.beach * smoothStep(0.95f, 0.55f, ground.height);
        const float wanted = smoothStep(-0.25f, 0.4f, patch) * (1.0f - 0.97f * sandy) *
                             (foreground ? 1.0f : smoothStep(16.0f, 2.0f, ground.shore));
        if (random.unit() > wanted || blocksView(views, p, 0.5f, Growth::low)) continue;
        const vec3 up = shape.normal(p, 0.6f);
        if (up.y < 0.72f) continue;
        const float height = random.range(0.28f, 0.62f) * (1.0f + 0.5f * saturate(patch));
        const float first = random.angle();
        const vec3 tone =
            random.range(0.7f, 1.0f) * mix(vec3(0.85f, 1.0f, 0.95f), vec3(1.0f, 0.95f, 0.85f), random.unit());
        for (int k = 0; k < 3; ++k) {
            Card card;
            card.foot = shape.onGround(p) - vec3(0.0f, 0.05f, 0.0f);
            card.turn = first + pi / 3.0f * real(k);
            card.width = height * random.range(1.1f, 1.4f);
            card.height = height;
            card.lean = 0.18f * height * vec2(random.sign(), random.sign());
            card.low = 0.5f * tone;
            card.high = tone;
            card.normal = up;
            addCard(mesh, card);
        }
        ++tufts;
    }
    return mesh;
}

Mesh makeWeed(const LakeShape& shape, const std::vector<View>& views, Random random)
{
    const Noise noise(random.next());
    Mesh mesh;
    mesh.use("blades");
    int plants = 0;
    for (int tries = 0; tries < 60000 && plants < 340; ++tries) {
        const vec2 p(random.range(-62.0f, 58.0f), random.range(-45.0f, 40.0f));
        const float bed = shape.height(p), patch = noise.fractal(p / 7.0f, 2);
        if (bed > -1.1f || bed < -5.2f || patch < 0.16f || blocksView(views, p, 3.0f, Growth::low)) continue;
        const float height = std::min(random.range(0.22f, 0.6f) * (0.6f + 1.5f * patch), -bed - 0.45f);
        const float first = random.angle();
        for (int k = 0; k < 2; ++k) {
            Card card;
            card.foot = shape.onGround(p) - vec3(0.0f, 0.04f, 0.0f);
            card.turn = first + 0.5f * pi * real(k);
            card.width = 1.1f * height;
            card.height = height;
            card.lean = 0.35f * height * vec2(0.6f + 0.4f * random.sign(), 0.5f * random.sign());
            card.low = vec3(0.34f, 0.33f, 0.25f);
            card.high = vec3(0.78f, 0.80f, 0.5f);
            card.rows = 2;
            addCard(mesh, card);
        }
        ++plants;
    }
    return mesh;
}

Mesh makeForest(const LakeShape& shape, const Impostors& impostors, const std::vector<View>& views, Random random)
{
    const Noise noise(random.next());
    Mesh mesh;
    mesh.use("forest_trees");
    int trees = 0;
    for (int tries = 0; tries < 200000 && trees < 4000; ++tries) {
        const float radius = std::sqrt(random.range(62.0f * 62.0f, 292.0f * 292.0f)), around = random.angle();
        const vec2 p = radius * vec2(std::cos(around), std::sin(around));
        const Ground ground = shape.at(p);
        if (ground.shore < 34.0f) continue;
        const float patch = noise.fractal(p / 55.0f, 3);
        if (random.unit() > smoothStep(-0.5f, -0.05f, patch + 0.4f * smoothStep(60.0f, 110.0f, ground.shore)) ||
            blocksView(views, p, 4.0f))
            continue;
        const bool broad =
            noise.fractal(p / 30.0f + 9.0f, 2) + 0.5f * random.sign() > 0.3f + 0.012f * (ground.height - 14.0f);
        const std::size_t cell = static_cast<std::size_t>(random.index(4)) + (broad ? 4u : 0u);
        const Impostors::Cell& picture = impostors.cells[cell];
        const float scale = random.range(0.8f, 1.3f), tone = random.range(0.72f, 1.0f), first = random.angle();
        for (int k = 0; k < 2; ++k) {
            Card card;
            card.foot = shape.onGround(p) - vec3(0.0f, 0.3f, 0.0f);
            card.turn = first + 0.5f * pi * real(k);
            card.width = picture.size.x * scale * (broad ? 1.0f : 1.18f);
            card.height = picture.size.y * scale;
            card.low = vec3(0.72f * tone);
            card.high = vec3(tone);
            // Towards the lake and up: the side that is seen.
            card.normal = vec3(-0.5f * p.x / radius, 1.0f, -0.5f * p.y / radius);
            card.uvLower = picture.lower;
            card.uvUpper = picture.upper;
            if (random.unit() < 0.5f) std::swap(card.uvLower.x, card.uvUpper.x);
            addCard(mesh, card);
        }
        ++trees;
    }
    return mesh;
}

} // namespace tarn::lake
