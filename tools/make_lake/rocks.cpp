#include "rocks.h"

namespace tarn::lake {

namespace {

vec3 rockColour(const Noise& noise, const vec3& p, const vec3& normal, float ground, float moss)
{
    const float mottle = noise.fractal(p * 0.9f, 3);
    vec3 colour = mix(vec3(0.125f, 0.118f, 0.108f), vec3(0.225f, 0.21f, 0.19f), saturate(0.5f + 1.2f * mottle));
    const float grown = moss * smoothStep(0.35f, 0.8f, normal.y + 0.6f * mottle) * smoothStep(0.35f, 0.7f, p.y);
    colour = mix(colour, vec3(0.075f, 0.095f, 0.03f), 0.85f * grown);
    // The band that waves keep wet, and what grows on it below.
    const float wet = smoothStep(0.24f, 0.06f, p.y + 0.08f * mottle);
    const float algae = smoothStep(0.02f, -0.12f, p.y + 0.05f * mottle) * smoothStep(-3.5f, -0.5f, p.y);
    colour = mix(colour, vec3(0.12f, 0.125f, 0.06f), 0.45f * algae) * mix(1.0f, 0.52f, wet);
    const float contact = mix(0.35f, 1.0f, smoothStep(0.0f, 0.5f, p.y - ground));
    const float sky = 0.62f + 0.38f * smoothStep(-0.7f, 0.6f, normal.y);
    return colour * (contact * sky / 0.5f);
}

/// A lump: a sphere cut by random planes (which gives it faces and edges) and roughened.
/// Small `cut` leaves little of the sphere: 0.5 gives a block, 0.7 a boulder.
std::vector<vec3> lump(const IcoSphere& sphere, const Noise& noise, Random& random, float roughness, float cut)
{
    std::array<vec4, 11> planes;
    for (vec4& plane : planes) plane = vec4(random.direction(), random.range(cut, cut + 0.26f));
    const vec3 shift = 40.0f * random.direction();
    std::vector<vec3> positions;
    for (vec3 p : sphere.positions) {
        for (const vec4& plane : planes) {
            const float over = glm::dot(p, vec3(plane)) - plane.w;
            if (over > 0.0f) p -= 0.96f * over * vec3(plane);
        }
        const float rough = noise.fractal(1.6f * p + shift, 3) + 0.5f * noise.ridges(3.0f * p + shift, 2) - 0.25f;
        positions.push_back(p * (1.0f + roughness * rough));
    }
    return positions;
}

void addLump(Mesh& mesh, const IcoSphere& sphere, std::vector<vec3> local, const Boulder& boulder,
             const std::function<vec3(const vec3&, const vec3&)>& colour, float tilesPerMetre)
{
    const mat4 world = placed(boulder.centre, boulder.turn) * glm::scale(mat4(1.0f), boulder.radii);
    for (vec3& p : local) p = vec3(world * vec4(p, 1.0f));
    const std::vector<vec3> normals = smoothNormals(local, sphere.triangles);
    std::vector<int> positions;
    for (std::size_t i = 0; i < local.size(); ++i)
        positions.push_back(mesh.addPosition(local[i], colour(local[i], normals[i])));
    const auto creased = creasedNormals(local, sphere.triangles, 0.82f);
    for (std::size_t face = 0; face < sphere.triangles.size(); ++face) {
        const auto& t = sphere.triangles[face];
        const auto i = [&](std::size_t k) { return static_cast<std::size_t>(t[k]); };
        const auto uvs = boxUvs(local[i(0)], local[i(1)], local[i(2)], tilesPerMetre);
        std::array<Corner, 3> corners;
        for (std::size_t k = 0; k < 3; ++k)
            corners[k] = {positions[i(k)], mesh.addUv(uvs[k]), mesh.addNormal(creased[face][k])};
        mesh.triangle(corners[0], corners[1], corners[2]);
    }
}

/// Blocks that stand out of the cliff's foot and face, taller than wide.
void placeCrags(const LakeShape& shape, std::vector<Boulder>& boulders, Random& random)
{
    for (float turn = 200.0f; turn < 310.0f; turn += 1.9f) {
        const vec2 foot = shape.shoreAlong({-2.0f, -20.0f}, turn + 0.6f * random.sign());
        const Ground ground = shape.at(foot);
        if (ground.kind.cliff < 0.45f || random.unit() < 0.25f) continue;
        const vec2 inland = glm::normalize(foot - vec2(-2.0f, -20.0f));
        const vec2 p = foot + random.range(0.4f, 3.6f) * inland;
        const float size = random.range(1.3f, 2.5f);
        const vec3 radii = size * vec3(random.range(0.7f, 1.1f), random.range(0.9f, 1.5f), random.range(0.7f, 1.1f));
        boulders.push_back({shape.onGround(p) + vec3(0.0f, -0.25f * radii.y, 0.0f), radii, random.angle(), 2, true});
    }
}

} // namespace

std::vector<Boulder> placeBoulders(const LakeShape& shape, const std::vector<View>& views, Random random)
{
    std::vector<Boulder> boulders;
    const auto put = [&](vec2 p, float radius, float sink, int levels) {
        const float flat = random.range(0.62f, 0.85f);
        const vec3 radii = radius * vec3(random.range(0.85f, 1.15f), flat, random.range(0.8f, 1.1f));
        boulders.push_back(
            {shape.onGround(p) + vec3(0.0f, radii.y * (1.0f - 2.0f * sink), 0.0f), radii, random.angle(), levels});
    };
    // By hand: off the beach, round the island, at the foot of the cliff.
    const vec2 beach = shape.shoreAlong({0.0f, 15.0f}, 100.0f);
    put(beach + vec2(-5.5f, -2.4f), 1.05f, 0.3f, 3);
    put(beach + vec2(-7.4f, -1.1f), 0.62f, 0.3f, 3);
    put(beach + vec2(-4.3f, -3.6f), 0.5f, 0.35f, 2);
    put(beach + vec2(6.2f, -4.6f), 0.8f, 0.3f, 3);
    for (const vec2 p :
         {vec2(7.6f, 3.4f), vec2(9.4f, 1.2f), vec2(5.0f, 6.2f), vec2(11.6f, 5.4f), vec2(2.0f, 4.4f), vec2(8.6f, 7.2f)})
        put(p, random.range(0.6f, 1.5f), 0.3f, 2); // on the slope down to the deep
    for (int k = 0; k < 11; ++k) {
        const float turn = 360.0f * real(k) / 11.0f + 9.0f * random.sign();
        const vec2 out(std::cos(glm::radians(turn)), std::sin(glm::radians(turn)));
        vec2 p = islandCentre;
        while (shape.height(p) > 0.0f && glm::length(p - islandCentre) < 30.0f) p += 0.1f * out;
        put(p + random.range(-0.4f, 0.9f) * out, random.range(0.45f, 1.35f), 0.3f, 2);
    }
    placeCrags(shape, boulders, random);
    const std::size_t enough = boulders.size() + 28;
    for (int tries = 0; tries < 6000 && boulders.size() < enough; ++tries) {
        const vec2 p(random.range(-72.0f, 72.0f), random.range(-58.0f, 52.0f));
        const Ground ground = shape.at(p);
        const float cliff = ground.kind.cliff, wanted = 0.10f + 0.9f * cliff - 0.3f * ground.kind.beach;
        if (std::abs(ground.shore + 0.6f) > 2.2f + 2.0f * cliff || random.unit() > wanted) continue;
        const float radius = random.range(0.35f, 0.9f) + 1.2f * cliff * random.unit() * random.unit();
        bool free = !blocksView(views, p, radius, Growth::low);
        for (const Boulder& other : boulders)
            free = free && glm::length(vec2(other.centre.x, other.centre.z) - p) > 0.8f * (other.radii.x + radius);
        if (free) put(p, radius, random.range(0.25f, 0.4f), radius > 0.75f ? 2 : 1);
    }
    return boulders;
}

Mesh makeBoulders(const std::vector<Boulder>& boulders, const LakeShape& shape, std::uint32_t seed)
{
    const Noise noise(seed);
    Random random(seed, 51);
    const std::array<IcoSphere, 4> spheres{icoSphere(0), icoSphere(1), icoSphere(2), icoSphere(3)};
    Mesh mesh;
    mesh.use("rock");
    for (const Boulder& boulder : boulders) {
        const IcoSphere& sphere = spheres[static_cast<std::size_t>(boulder.levels)];
        const float moss = random.unit() < 0.45f ? random.unit() : 0.0f;
        const auto colour = [&](const vec3& p, const vec3& n) {
            return rockColour(noise, p, n, shape.height({p.x, p.z}), moss);
        };
        addLump(mesh, sphere, lump(sphere, noise, random, boulder.crag ? 0.10f : 0.14f, boulder.crag ? 0.46f : 0.62f),
                boulder, colour, 1.0f / 2.2f);
    }
    return mesh;
}

Mesh makeStones(const LakeShape& shape, Random random)
{
    const Noise noise(random.next());
    const std::array<IcoSphere, 2> spheres{icoSphere(0), icoSphere(1)};
    Mesh mesh;
    mesh.use("stone");
    const vec2 beach = shape.shoreAlong({0.0f, 15.0f}, 100.0f);
    int count = 0;
    for (int tries = 0; tries < 20000 && count < 400; ++tries) {
        // The first lie where one looks down from the beach.
        const bool near = count < 90;
        const vec2 p = near ? beach + vec2(2.6f * random.normal() - 2.0f, 1.5f * random.normal() - 3.0f)
                            : vec2(random.range(-66.0f, 62.0f), random.range(-48.0f, 44.0f));
        const Ground ground = shape.at(p);
        const float patch = noise.fractal(p / 6.0f, 2);
        if (ground.shore > 1.6f || ground.shore < -22.0f || (!near && patch < random.range(-0.3f, 0.5f))) continue;
        if (random.unit() > std::exp(0.11f * std::min(0.0f, ground.shore))) continue;
        const float size = 0.045f + 0.21f * std::pow(random.unit(), 3.0f);
        const std::size_t level = size > 0.145f ? 1 : 0;
        const vec3 radii = size * vec3(random.range(0.9f, 1.3f), random.range(0.5f, 0.75f), random.range(0.8f, 1.1f));
        const Boulder stone{shape.onGround(p) + vec3(0.0f, 0.35f * radii.y, 0.0f), radii, random.angle(), 1};
        const vec3 tone =
            random.range(0.7f, 1.25f) * mix(vec3(0.20f, 0.195f, 0.185f), vec3(0.27f, 0.225f, 0.17f), random.unit());
        const auto colour = [&](const vec3& q, const vec3& n) {
            const float wet = q.y < 0.1f ? 0.75f : 1.0f;
            return tone * (wet * (0.45f + 0.55f * smoothStep(-0.6f, 0.5f, n.y)) / 0.5f);
        };
        addLump(mesh, spheres[level], lump(spheres[level], noise, random, 0.12f, 0.66f), stone, colour, 1.0f / 1.1f);
        ++count;
    }
    return mesh;
}

Mesh makeSunkenTrunk(const LakeShape& shape, Random random)
{
    Mesh mesh;
    mesh.use("bark");
    const vec2 foot(-21.0f, 22.0f), top(-11.5f, 15.5f);
    std::vector<TubeRing> rings;
    for (int k = 0; k <= 16; ++k) {
        const float t = real(k) / 16.0f, radius = 0.30f - 0.17f * t;
        const vec2 p = foot + t * (top - foot) + vec2(0.25f * std::sin(5.0f * t), 0.3f * std::sin(4.0f * t + 1.0f));
        const float lie = std::max(shape.height(p), mix(shape.height(foot), shape.height(top), t) - 0.25f);
        rings.push_back(
            {{p.x, lie + 0.8f * radius + 0.12f * t, p.y}, radius * (k == 0 ? 1.5f : (k == 1 ? 1.15f : 1.0f))});
    }
    TubeStyle style{.sides = 10, .uvRound = 1.0f, .uvPerMetre = 0.5f};
    style.colour = [&](const vec3& p) {
        const float above = smoothStep(0.0f, 0.5f, p.y - shape.height({p.x, p.z}));
        return vec3(1.15f, 1.05f, 0.72f) * mix(0.4f, 0.95f, above);
    };
    addTube(mesh, rings, style);
    for (int k = 3; k < 15; ++k) { // what is left of its branches
        const TubeRing& ring = rings[static_cast<std::size_t>(k)];
        const float turn = random.angle();
        const vec3 out = glm::normalize(vec3(std::cos(turn), random.range(0.1f, 1.1f), std::sin(turn)));
        const float length = random.range(0.25f, 1.3f);
        TubeStyle twig = style;
        twig.sides = 5;
        twig.uvRound = 0.3f;
        addTube(mesh,
                {{ring.centre, 0.045f},
                 {ring.centre + (ring.radius + 0.5f * length) * out, 0.032f},
                 {ring.centre + (ring.radius + length) * out + vec3(0.0f, -0.1f * length, 0.0f), 0.012f}},
                twig);
    }
    return mesh;
}

} // namespace tarn::lake
