#include "woods.h"

#include <algorithm>

namespace tarn::lake {

namespace {

// Indices into growSpecies().
enum : std::size_t {
    tallSpruce,
    spruce,
    wideSpruce,
    slimSpruce,
    youngSpruce,
    oak,
    maple,
    alder,
    birch,
    smallBirch,
    greenBush,
    paleBush
};

bool crowded(const std::vector<StandingTree>& trees, const std::vector<Species>& species, vec2 p, float crown)
{
    return std::any_of(trees.begin(), trees.end(), [&](const StandingTree& tree) {
        const float both = crown + tree.scale * species[tree.species].crown;
        return glm::length(vec2(tree.foot.x, tree.foot.z) - p) < 0.62f * both;
    });
}

std::size_t chooseKind(const LakeShape& shape, const Noise& noise, vec2 p, Random& random)
{
    const Ground ground = shape.at(p);
    if (ground.shore < 7.0f && random.unit() < 0.34f) return random.unit() < 0.6f ? greenBush : paleBush;
    // Conifers to the north and on high ground, birches by the beaches, alders along the banks.
    const float conifers = 0.45f + 0.8f * noise.fractal(p / 26.0f, 2) - 0.006f * p.y + 0.3f * ground.kind.cliff -
                           0.45f * ground.kind.beach;
    if (random.unit() < conifers) {
        constexpr std::size_t kinds[] = {tallSpruce, spruce, spruce, wideSpruce, slimSpruce, youngSpruce};
        return kinds[random.index(6)];
    }
    if (random.unit() < 0.25f + 0.5f * ground.kind.beach) return random.unit() < 0.6f ? birch : smallBirch;
    constexpr std::size_t kinds[] = {oak, maple, alder, alder};
    return kinds[random.index(4)];
}

void plantIsland(const LakeShape& shape, std::vector<StandingTree>& trees, Random& random)
{
    struct Spot {
        std::size_t kind;
        vec2 at;
        float scale;
    };
    // Seen from the south and south-east: the tall ones off the middle, a birch leaning out on each side.
    constexpr Spot spots[] = {
        {tallSpruce, {-2.6f, -0.6f}, 0.92f}, {slimSpruce, {0.6f, -2.6f}, 0.82f}, {spruce, {-5.4f, 0.2f}, 0.88f},
        {wideSpruce, {3.4f, -1.2f}, 0.80f},  {youngSpruce, {1.9f, 1.9f}, 0.9f},  {youngSpruce, {-7.6f, -0.8f}, 0.8f},
        {birch, {6.6f, 0.9f}, 0.78f},        {smallBirch, {-3.6f, 3.0f}, 0.80f}, {maple, {-0.4f, 1.6f}, 0.62f},
        {greenBush, {4.6f, 2.8f}, 0.9f},     {paleBush, {-6.3f, 2.3f}, 0.8f},    {greenBush, {0.6f, 4.3f}, 0.7f},
        {greenBush, {8.4f, 2.6f}, 0.7f}};
    for (const Spot& spot : spots) {
        const vec2 p = islandCentre + spot.at;
        if (shape.height(p) > 0.15f) trees.push_back({spot.kind, shape.onGround(p), random.angle(), spot.scale});
    }
}

} // namespace

std::vector<Species> growSpecies(std::uint32_t seed)
{
    std::vector<Species> all;
    const auto random = [&] { return Random(seed, 60 + all.size()); };
    const auto conifer = [&](const char* name, const SpruceShape& s) {
        all.push_back({name, makeSpruce(s, random()), s.spread * s.height, true});
    };
    const auto broad = [&](const char* name, const BroadShape& s) {
        all.push_back({name, makeBroadleaf(s, random()), s.spread * s.height, false});
    };
    conifer("tall_spruce", {.height = 17.0f, .spread = 0.19f, .clear = 0.06f, .branches = 124});
    conifer("spruce", {.height = 13.0f, .spread = 0.22f, .clear = 0.04f, .branches = 108});
    conifer("wide_spruce", {.height = 10.0f, .spread = 0.27f, .clear = 0.03f, .branches = 96});
    conifer("slim_spruce", {.height = 18.5f, .spread = 0.155f, .clear = 0.10f, .branches = 120});
    conifer("young_spruce", {.height = 5.2f, .spread = 0.28f, .clear = 0.02f, .branches = 60});
    broad("oak", {.height = 11.5f,
                  .spread = 0.42f,
                  .fork = 0.24f,
                  .limbs = 7,
                  .twigsPerLimb = 3,
                  .cardsPerClump = 8,
                  .clump = 0.155f,
                  .tint = vec3(0.78f, 0.80f, 0.85f)});
    broad("maple", {.height = 10.0f,
                    .spread = 0.37f,
                    .fork = 0.26f,
                    .limbs = 6,
                    .twigsPerLimb = 3,
                    .cardsPerClump = 8,
                    .clump = 0.165f,
                    .tint = vec3(0.95f, 0.88f, 0.8f)});
    broad("alder", {.height = 8.5f,
                    .spread = 0.31f,
                    .fork = 0.16f,
                    .limbs = 7,
                    .twigsPerLimb = 2,
                    .cardsPerClump = 8,
                    .clump = 0.16f,
                    .tint = vec3(0.66f, 0.76f, 0.85f)});
    broad("birch", {.height = 13.0f,
                    .spread = 0.23f,
                    .fork = 0.22f,
                    .limbs = 10,
                    .twigsPerLimb = 2,
                    .cardsPerClump = 6,
                    .clump = 0.11f,
                    .droop = 0.085f,
                    .birch = true,
                    .tint = vec3(0.98f, 0.95f, 0.75f)});
    broad("small_birch", {.height = 9.5f,
                          .spread = 0.25f,
                          .fork = 0.2f,
                          .limbs = 9,
                          .twigsPerLimb = 2,
                          .cardsPerClump = 6,
                          .clump = 0.12f,
                          .droop = 0.075f,
                          .birch = true,
                          .tint = vec3(1.0f, 0.95f, 0.7f)});
    all.push_back({"green_bush", makeBush(1.6f, vec3(0.8f, 0.9f, 0.85f), random()), 1.2f, false});
    all.push_back({"pale_bush", makeBush(1.3f, vec3(0.95f, 0.92f, 0.75f), random()), 1.0f, false});
    return all;
}

std::vector<StandingTree> plantTrees(const LakeShape& shape, const std::vector<Species>& species,
                                     const std::vector<View>& views, Random random)
{
    const Noise noise(random.next());
    std::vector<StandingTree> trees;
    plantIsland(shape, trees, random);
    for (int tries = 0; tries < 30000 && trees.size() < 130; ++tries) {
        const vec2 p(random.range(-105.0f, 100.0f), random.range(-90.0f, 85.0f));
        const Ground ground = shape.at(p);
        if (ground.shore < 2.2f || ground.shore > 40.0f || ground.height < 0.55f ||
            glm::length(p - islandCentre) < 22.0f)
            continue;
        if (shape.normal(p, 1.0f).y < 0.72f) continue;
        const float open = 0.8f * ground.kind.beach * smoothStep(20.0f, 8.0f, ground.shore);
        const float wanted = smoothStep(-0.35f, 0.25f, noise.fractal(p / 19.0f, 2)) *
                             smoothStep(52.0f, 12.0f, ground.shore) * (1.0f - open);
        if (random.unit() > wanted) continue;
        const std::size_t kind = chooseKind(shape, noise, p, random);
        const float scale = random.range(0.78f, 1.15f), crown = scale * species[kind].crown;
        if (kind < greenBush && ground.shore < 0.75f * crown) continue;
        if (crowded(trees, species, p, crown) || blocksView(views, p, crown)) continue;
        trees.push_back({kind, shape.onGround(p), random.angle(), scale});
    }
    return trees;
}

std::vector<Shade> treeShades(const std::vector<StandingTree>& trees, const std::vector<Species>& species)
{
    std::vector<Shade> shades;
    for (const StandingTree& tree : trees) {
        const float crown = tree.scale * species[tree.species].crown;
        const vec2 p(tree.foot.x, tree.foot.z);
        shades.push_back({p, 1.25f * crown, species[tree.species].conifer ? 0.6f : 0.5f});
        shades.push_back({p, 0.3f + 0.12f * crown, 0.45f});
    }
    return shades;
}

} // namespace tarn::lake
