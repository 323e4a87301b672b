#include "pier.h"

namespace tarn::lake {

namespace {

constexpr float length = 4.5f, beam = 1.5f, draught = 0.13f, freeboard = 0.42f;
constexpr float floorHeight = 0.115f; // above the highest wave, so that no water shows inside
constexpr int stations = 18, strakes = 7;

constexpr vec3 red{0.46f, 0.055f, 0.035f}, cream{0.88f, 0.83f, 0.70f}, bottom{0.10f, 0.11f, 0.12f};

/// Half the breadth and the height of the gunwale and keel at s from -1 (stern) to 1 (bow).
struct Section {
    float halfBeam, keel, sheer;
};
Section sectionAt(float s)
{
    const float fore = s > 0.0f ? std::pow(1.0f - std::pow(s, 2.3f), 0.85f) : 1.0f - 0.32f * s * s;
    const float keel = -draught + 0.05f * s * s + (s > 0.75f ? 1.7f * std::pow(s - 0.75f, 1.6f) : 0.0f);
    return {0.5f * beam * fore, keel, freeboard + 0.05f * s * s + 0.13f * std::pow(std::max(0.0f, s), 2.0f)};
}

/// A point of the hull: t from 0 (keel) to 1 (gunwale); `inset` moves it inwards.
vec3 hullPoint(float s, float t, float side, float inset)
{
    const Section section = sectionAt(s);
    const float flare = std::pow(std::sin(0.5f * pi * std::min(1.0f, 0.06f + 0.98f * t)), 0.72f);
    const float breadth = std::max(0.0f, section.halfBeam * flare - inset) * smoothStep(0.0f, 0.08f, t);
    const float y = mix(section.keel, section.sheer, std::pow(t, 1.45f)) + (t < 0.9f ? inset : 0.0f);
    const float rake = s > 0.0f ? 0.16f * s * t : 0.10f * s * t;
    return {0.5f * (length - 0.3f) * s + rake - (s > 0.5f ? inset : -inset), y, side * breadth};
}

vec3 outsideColour(const vec3& p, float t)
{
    vec3 colour = t > 0.83f ? cream : red;
    if (p.y < 0.035f) colour = bottom;
    return colour * mix(0.72f, 1.0f, smoothStep(-0.15f, 0.3f, p.y));
}

/// One skin of one side, as a grid of quads; clinker: each strake's lower edge stands out a little.
void addSkin(Mesh& mesh, float side, float inset, bool inside)
{
    std::vector<vec3> positions;
    std::vector<std::array<int, 3>> triangles;
    std::vector<vec3> colours;
    std::vector<vec2> uvs;
    const int columns = stations + 1, rows = 2 * strakes;
    for (int row = 0; row < rows; ++row) {
        const float t = real((row + 1) / 2) / real(strakes);
        const float lap = row % 2 == 0 ? 0.0f : 0.011f; // the top of a strake lies under the next one
        for (int k = 0; k < columns; ++k) {
            const float s = -1.0f + 2.0f * real(k) / real(stations);
            const vec3 p = hullPoint(s, t, side, inset + lap);
            positions.push_back(p);
            uvs.emplace_back(0.5f * p.x + 0.31f * real(row / 2), 1.6f * t + 0.13f * real(row / 2));
            colours.push_back(inside ? vec3(0.75f, 0.62f, 0.47f) * mix(0.28f, 0.85f, smoothStep(0.1f, 0.45f, p.y))
                                     : outsideColour(p, (real(row / 2) + 0.5f) / real(strakes)) *
                                           (lap > 0.0f ? 0.62f : 1.0f));
        }
    }
    const bool turned = (side > 0.0f) != inside;
    for (int row = 0; row + 1 < rows; ++row)
        for (int k = 0; k + 1 < columns; ++k) {
            const int a = row * columns + k, b = a + 1, c = a + columns, d = c + 1;
            if (turned)
                triangles.insert(triangles.end(), {{a, b, d}, {a, d, c}});
            else
                triangles.insert(triangles.end(), {{a, d, b}, {a, c, d}});
        }
    const std::vector<vec3> normals = smoothNormals(positions, triangles);
    std::vector<Corner> corners;
    for (std::size_t i = 0; i < positions.size(); ++i)
        corners.push_back(mesh.add(positions[i], normals[i], uvs[i], colours[i]));
    for (const auto& t : triangles)
        mesh.triangle(corners[static_cast<std::size_t>(t[0])], corners[static_cast<std::size_t>(t[1])],
                      corners[static_cast<std::size_t>(t[2])]);
}

/// The flat stern between the two skins.
void addTransom(Mesh& mesh, float shift, bool inside, const vec3& colour)
{
    std::vector<vec3> rim;
    for (int row = strakes; row >= 0; --row)
        rim.push_back(hullPoint(-1.0f, real(row) / real(strakes), -1.0f, inside ? 0.02f : 0.0f));
    for (int row = 1; row <= strakes; ++row)
        rim.push_back(hullPoint(-1.0f, real(row) / real(strakes), 1.0f, inside ? 0.02f : 0.0f));
    const vec3 normal(inside ? 1.0f : -1.0f, 0.0f, 0.0f);
    const auto corner = [&](const vec3& p) {
        const vec3 q(p.x + shift, p.y, p.z);
        return mesh.add(q, normal, {q.z, q.y},
                        q.y < 0.035f && !inside ? bottom : colour * mix(0.6f, 1.0f, smoothStep(-0.1f, 0.3f, q.y)));
    };
    const vec3 centre(rim.front().x, 0.5f * (rim.front().y + sectionAt(-1.0f).keel), 0.0f);
    const Corner middle = corner(centre);
    for (std::size_t i = 0; i < rim.size(); ++i) {
        const Corner a = corner(rim[i]), b = corner(rim[(i + 1) % rim.size()]);
        if (inside)
            mesh.triangle(middle, b, a);
        else
            mesh.triangle(middle, a, b);
    }
}

/// A board across or along the boat.
void addBoard(Mesh& mesh, const vec3& centre, const vec3& size, float turn, const vec3& colour, Random& random)
{
    BoxStyle style{.uvPerMetre = 0.7f, .uvOffset = {random.unit(), random.unit()}, .segments = 2};
    style.colour = [=](const vec3& p) { return colour * (p.y < centre.y ? 0.5f : 1.0f); };
    addBox(mesh, placed(centre, turn), size, style);
}

void addFittings(Mesh& mesh, Random& random)
{
    const vec3 oiled(0.80f, 0.64f, 0.46f);
    mesh.use("wood");
    for (int k = -3; k <= 3; ++k) { // floor boards, shorter towards the sides
        const float z = 0.165f * real(k), shorter = 0.075f * real(std::abs(k));
        addBoard(mesh, {-0.25f - 0.4f * shorter, floorHeight - 0.012f, z}, {3.35f - 5.0f * shorter, 0.024f, 0.15f},
                 0.0f, 0.6f * oiled, random);
    }
    for (const float x : {-1.35f, 0.05f, 1.15f}) { // benches
        const float breadth = 2.0f * sectionAt(x / (0.5f * length)).halfBeam * 0.965f;
        for (const float offset : {-0.125f, 0.02f})
            addBoard(mesh, {x + offset, 0.31f, 0.0f}, {breadth, 0.03f, 0.135f}, 0.5f * pi, oiled, random);
    }
    const auto tube = [&](const std::vector<TubeRing>& rings, int sides, const vec3& colour) {
        TubeStyle style{.sides = sides, .uvRound = 0.15f, .uvPerMetre = 0.7f};
        style.colour = [colour](const vec3&) { return colour; };
        addTube(mesh, rings, style);
    };
    for (const float side : {-1.0f, 1.0f}) {
        // Rail along the gunwale: it closes the gap between the skins.
        std::vector<TubeRing> rail;
        for (int k = 0; k <= stations; ++k)
            rail.push_back(
                {hullPoint(-1.0f + 2.0f * real(k) / real(stations), 1.0f, side, 0.010f) + vec3(0.0f, 0.004f, 0.0f),
                 0.027f});
        tube(rail, 6, vec3(0.62f, 0.47f, 0.33f));
        // An oar lying on the benches, blade over the bow bench.
        const vec3 handle(-1.75f, 0.39f, side * 0.16f), neck(0.75f, 0.355f, side * 0.34f),
            tip(1.38f, 0.37f, side * 0.38f);
        tube({{handle, 0.018f}, {mix(handle, neck, 0.1f), 0.024f}, {neck, 0.02f}}, 6, oiled);
        const vec3 along = glm::normalize(tip - neck);
        addBoard(mesh, 0.5f * (neck + tip) + vec3(0, 0.008f, 0), {glm::length(tip - neck), 0.016f, 0.125f},
                 std::atan2(-along.z, along.x), oiled, random);
    }
    tube({{{-0.5f * length + 0.14f, freeboard + 0.045f, -0.5f}, 0.025f},
          {{-0.5f * length + 0.14f, freeboard + 0.045f, 0.5f}, 0.025f}},
         6, vec3(0.62f, 0.47f, 0.33f));
    tube({{{0.5f * length - 0.22f, 0.50f, 0.0f}, 0.032f}, {{0.5f * length - 0.05f, freeboard + 0.24f, 0.0f}, 0.035f}},
         6, vec3(0.62f, 0.47f, 0.33f));
}

vec3 bowRing() { return {0.5f * length - 0.07f, freeboard + 0.16f, 0.0f}; }

} // namespace

Mesh makeBoat(Random random)
{
    Mesh mesh;
    for (const float side : {-1.0f, 1.0f}) {
        mesh.use("paint");
        addSkin(mesh, side, 0.0f, false);
        mesh.use("wood");
        addSkin(mesh, side, 0.03f, true);
    }
    mesh.use("paint");
    addTransom(mesh, 0.0f, false, red);
    mesh.use("wood");
    addTransom(mesh, 0.035f, true, vec3(0.6f, 0.48f, 0.36f));
    addFittings(mesh, random);
    return mesh;
}

mat4 boatPlace(const PierSite& site)
{
    const vec2 p = site.at(site.length - 7.2f, -2.45f);
    const float along = std::atan2(-site.direction.y, site.direction.x);
    return placed({p.x, 0.0f, p.y}, along + 0.16f);
}

Mesh makeRope(const PierSite& site)
{
    Mesh mesh;
    mesh.use("rope");
    const vec3 bow = vec3(boatPlace(site) * vec4(bowRing(), 1.0f));
    const vec2 post = site.at(site.length - 2.85f, -1.93f);
    const vec3 knot(post.x, site.deck + 0.2f, post.y);
    std::vector<TubeRing> rings;
    for (int k = 0; k <= 14; ++k) {
        const float t = real(k) / 14.0f;
        rings.push_back({mix(bow, knot, t) - vec3(0.0f, 1.5f * t * (1.0f - t), 0.0f), 0.014f});
    }
    TubeStyle style{.sides = 6, .uvRound = 0.1f, .uvPerMetre = 1.0f};
    addTube(mesh, rings, style);
    std::vector<TubeRing> turns; // round the post
    for (int k = 0; k <= 30; ++k) {
        const float turn = 2.0f * pi * 2.5f * real(k) / 30.0f;
        turns.push_back(
            {knot + vec3(0.132f * std::cos(turn), 0.0013f * real(k) - 0.03f, 0.132f * std::sin(turn)), 0.014f});
    }
    addTube(mesh, turns, style);
    return mesh;
}

} // namespace tarn::lake
