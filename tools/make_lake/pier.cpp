#include "pier.h"

namespace tarn::lake {

namespace {

constexpr float plankThickness = 0.045f;

vec3 woodColour(const vec3& p, float tone)
{
    // Dark and green where water and weed keep it wet, shaded under the deck by what colour() callers pass
    // in.
    const float wet = smoothStep(0.22f, 0.05f, p.y), algae = smoothStep(0.06f, -0.2f, p.y);
    const vec3 dry = vec3(0.66f, 0.62f, 0.58f) * tone;
    return mix(dry * mix(1.0f, 0.5f, wet), vec3(0.26f, 0.29f, 0.14f), 0.7f * algae);
}

/// The frame of a board: x along `along`, y up, centred at `centre`.
mat4 boardFrame(const vec3& centre, const vec3& along, float roll = 0.0f)
{
    const vec3 x = glm::normalize(along), z = glm::normalize(glm::cross(x, vec3(0, 1, 0))), y = glm::cross(z, x);
    const mat4 frame(vec4(x, 0), vec4(y, 0), vec4(z, 0), vec4(centre, 1));
    return glm::rotate(frame, roll, vec3(1, 0, 0));
}

vec3 lift(vec2 p, float y) { return {p.x, y, p.y}; }

void addPost(Mesh& mesh, const LakeShape& shape, vec2 p, float top, float radius, Random& random)
{
    const float bed = shape.height(p), tone = random.range(0.75f, 0.95f);
    const vec2 lean = 0.03f * vec2(random.sign(), random.sign());
    std::vector<TubeRing> rings;
    for (const float y : {bed - 0.6f, bed, bed + 0.25f, -0.5f, -0.12f, 0.06f, 0.22f, top - 0.25f, top}) {
        if (!rings.empty() && y < rings.back().centre.y + 0.03f) continue;
        rings.push_back({lift(p + lean * (y - top), y), radius * (1.0f + 0.04f * random.sign())});
    }
    TubeStyle style{.sides = 12, .uvRound = 0.5f, .uvPerMetre = 0.5f, .uOffset = random.unit()};
    style.colour = [=](const vec3& q) {
        const float foot = mix(0.5f, 1.0f, smoothStep(bed, bed + 0.35f, q.y));
        return woodColour(q, tone) * foot;
    };
    addTube(mesh, rings, style);
}

struct DeckPart {
    float from, to, halfWidth;
};

void addPlanks(Mesh& mesh, const PierSite& site, const DeckPart& part, Random& random)
{
    for (float along = part.from; along < part.to;) {
        const float width = random.range(0.135f, 0.17f), middle = along + 0.5f * width;
        const float overhang = 0.05f * random.sign(), tone = random.range(0.78f, 1.05f);
        const vec3 a = lift(site.at(middle + 0.008f * random.sign(), -part.halfWidth - overhang), 0.0f);
        const vec3 b = lift(site.at(middle + 0.008f * random.sign(), part.halfWidth + 0.03f * random.sign()), 0.0f);
        const float y = site.deck - 0.5f * plankThickness + 0.006f * random.sign();
        BoxStyle style{.uvPerMetre = 0.8f, .uvOffset = {random.unit(), random.unit()}, .segments = 2};
        style.colour = [=, &site](const vec3& p) { // dark underneath
            return woodColour(p, tone * (p.y < site.deck - 0.6f * plankThickness ? 0.45f : 1.0f));
        };
        addBox(mesh, boardFrame(0.5f * (a + b) + vec3(0, y, 0), b - a, 0.012f * random.sign()),
               {glm::length(b - a), plankThickness, width}, style);
        along += width + random.range(0.014f, 0.026f);
    }
}

void addBeam(Mesh& mesh, const vec3& a, const vec3& b, float height, float width, float tone, Random& random)
{
    BoxStyle style{.uvPerMetre = 0.6f, .uvOffset = {random.unit(), random.unit()}, .segments = 4};
    style.colour = [=](const vec3& p) { return woodColour(p, tone); };
    addBox(mesh, boardFrame(0.5f * (a + b), b - a), {glm::length(b - a), height, width}, style);
}

} // namespace

PierSite pierSite(const LakeShape& shape)
{
    const float out = glm::radians(67.0f);
    const vec2 direction(-std::cos(out), -std::sin(out));
    const vec2 shore = shape.shoreAlong({10.0f, 20.0f}, 67.0f);
    return {.root = shore - 2.6f * direction, .direction = direction};
}

Mesh makePier(const LakeShape& shape, const PierSite& site, Random random)
{
    Mesh mesh;
    mesh.use("wood");
    const float half = 0.5f * site.width, head = 3.2f, headHalf = 1.9f;
    addPlanks(mesh, site, {0.0f, site.length - head, half}, random);
    addPlanks(mesh, site, {site.length - head + 0.02f, site.length, headHalf}, random);

    const float under = site.deck - plankThickness - 0.085f;
    for (const float side : {-1.0f, 1.0f}) {
        const float inset = half - 0.14f;
        addBeam(mesh, lift(site.at(0.0f, side * inset), under), lift(site.at(site.length - 0.1f, side * inset), under),
                0.15f, 0.09f, 0.55f, random);
        const float wide = headHalf - 0.16f;
        addBeam(mesh, lift(site.at(site.length - head + 0.05f, side * wide), under),
                lift(site.at(site.length - 0.1f, side * wide), under), 0.15f, 0.09f, 0.55f, random);
    }
    for (float along = 2.2f; along < site.length - head - 0.5f; along += 2.55f) {
        for (const float side : {-1.0f, 1.0f})
            addPost(mesh, shape, site.at(along, side * (half + 0.02f)), site.deck + random.range(0.10f, 0.28f), 0.105f,
                    random);
        addBeam(mesh, lift(site.at(along + 0.15f, -half - 0.1f), under - 0.14f),
                lift(site.at(along + 0.15f, half + 0.1f), under - 0.14f), 0.13f, 0.08f, 0.5f, random);
    }
    for (const float along : {site.length - head + 0.35f, site.length - 0.3f}) {
        for (const float side : {-1.0f, 1.0f})
            addPost(mesh, shape, site.at(along, side * (headHalf + 0.03f)), site.deck + random.range(0.35f, 0.5f),
                    0.12f, random);
        addBeam(mesh, lift(site.at(along + 0.15f, -headHalf - 0.1f), under - 0.14f),
                lift(site.at(along + 0.15f, headHalf + 0.1f), under - 0.14f), 0.13f, 0.08f, 0.5f, random);
    }
    return mesh;
}

} // namespace tarn::lake
