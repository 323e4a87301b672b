#include "textures.h"

#include <vector>

namespace tarn::lake {

namespace {

// Drawn at twice the size and halved: strokes a pixel wide keep clean edges. Positions in pixels of the large
// canvas, y down.
constexpr int drawnSize = 2 * textureSize;
constexpr float edge = 2.0f * textureSize;

vec2 towards(float turn) { return {std::cos(turn), std::sin(turn)}; }

/// A pointed leaf from its stalk along `turn`, lighter along the midrib and edges, folded a little.
void drawLeaf(Canvas& canvas, vec2 stalk, float turn, float length, float width, const vec3& colour, float light)
{
    const vec2 axis = towards(turn);
    const vec2 centre = stalk + 0.5f * length * axis;
    const auto local = [&](vec2 d) { return vec2(glm::dot(d, axis), axis.x * d.y - axis.y * d.x); };
    canvas.stamp(
        centre, 0.55f * length,
        [&](vec2 d) {
            const vec2 q = local(d);
            const float t = saturate(q.x / length + 0.5f);
            const float half = 0.5f * width * std::pow(std::max(0.0f, std::sin(pi * std::pow(t, 0.8f))), 0.85f);
            return std::min(half - std::abs(q.y), 0.5f * length - std::abs(q.x));
        },
        [&](vec2 d) {
            const vec2 q = local(d);
            const float rib = smoothStep(3.5f, 1.0f, std::abs(q.y));
            const float vein = 0.06f * std::sin((q.x + 1.3f * std::abs(q.y)) * 0.32f);
            const float fold = q.y > 0.0f ? 1.12f : 0.90f;
            return colour * (light * (fold + vein + 0.35f * rib));
        });
}

/// Leaves on alternate sides of a twig.
void drawSpray(Canvas& canvas, Random& random, const std::vector<vec2>& twig, float light)
{
    for (std::size_t k = 0; k + 1 < twig.size(); ++k) {
        const vec2 along = twig[k + 1] - twig[k];
        const float turn = std::atan2(along.y, along.x);
        for (const float side : {-1.0f, 1.0f}) {
            const float hue = random.unit(), length = random.range(88.0f, 132.0f);
            const vec3 colour = mix(vec3(0.050f, 0.100f, 0.022f), vec3(0.092f, 0.148f, 0.033f), hue * hue);
            drawLeaf(canvas, twig[k] + random.unit() * along, turn + side * random.range(0.5f, 1.15f), length,
                     length * random.range(0.46f, 0.6f), colour, light * random.range(0.8f, 1.1f));
        }
    }
}

std::vector<vec2> growTwig(Random& random, vec2 start, float turn, float length, float bend)
{
    std::vector<vec2> twig{start};
    const int steps = std::max(2, static_cast<int>(length / 66.0f));
    for (int k = 0; k < steps; ++k) {
        turn += bend / real(steps) + 0.10f * random.sign();
        twig.push_back(twig.back() + length / real(steps) * towards(turn));
    }
    return twig;
}

Canvas drawLeaves(std::uint32_t seed)
{
    // Sprays that leave gaps: a clump seen from afar must not close up into a disc. Dark sprays first.
    Random random(seed, 41);
    Canvas canvas(drawnSize, Canvas::Edge::cut);
    for (int layer = 0; layer < 3; ++layer) {
        const float light = 0.50f + 0.28f * real(layer);
        constexpr int sprays = 6;
        for (int i = 0; i < sprays; ++i) {
            const float turn = 2.0f * pi * (real(i) + 0.33f * real(layer) + 0.5f * random.unit()) / real(sprays);
            const vec2 start = vec2(0.5f * edge) + 0.012f * edge * towards(turn);
            const auto twig = growTwig(random, start, turn, edge * random.range(0.26f, 0.40f), 0.7f * random.sign());
            for (std::size_t k = 0; k + 1 < twig.size(); ++k)
                canvas.stroke(twig[k], twig[k + 1], 5.0f, 4.0f, vec3(0.075f, 0.055f, 0.035f));
            for (std::size_t k = 1; k + 1 < twig.size(); k += 2) {
                const vec2 along = twig[k + 1] - twig[k];
                const float side = (k / 2) % 2 == 0 ? 0.8f : -0.8f;
                const auto small = growTwig(random, twig[k], std::atan2(along.y, along.x) + side,
                                            edge * random.range(0.07f, 0.13f), 0.3f * random.sign());
                drawSpray(canvas, random, small, light);
            }
            drawSpray(canvas, random, twig, light);
        }
    }
    return canvas.halved();
}

/// Needles on both sides of a twig.
void drawNeedles(Canvas& canvas, Random& random, vec2 a, vec2 b, float needle, const vec3& colour)
{
    const vec2 along = b - a;
    const float length = glm::length(along), turn = std::atan2(along.y, along.x);
    const int count = static_cast<int>(length / 5.0f);
    for (int i = 0; i < count; ++i) {
        const float t = (real(i) + random.unit()) / real(count);
        const float side = i % 2 == 0 ? 1.0f : -1.0f;
        const float lean = turn + side * random.range(0.45f, 1.05f);
        const float reach = needle * random.range(0.75f, 1.1f) * (1.0f - 0.3f * t);
        const vec2 root = a + t * along;
        canvas.stroke(root, root + reach * towards(lean), 3.1f, 1.5f, colour * random.range(0.65f, 1.3f));
    }
}

Canvas drawSpruceBranch(std::uint32_t seed)
{
    Random random(seed, 42);
    Canvas canvas(drawnSize, Canvas::Edge::cut);
    const vec3 bark(0.085f, 0.058f, 0.036f);
    const vec2 base(0.5f * edge, edge), tip(0.5f * edge, 0.035f * edge);
    canvas.stroke(base, tip, 15.0f, 4.0f, bark);
    constexpr int pairs = 13;
    for (int layer = 0; layer < 2; ++layer) { // shaded needles first, lit ones over them
        for (int i = 0; i < 2 * pairs; ++i) {
            const float t = 0.02f + 0.95f * (real(i / 2) + 0.7f * random.unit()) / real(pairs);
            const float side = i % 2 == 0 ? 1.0f : -1.0f;
            const float reach = edge * (0.56f * std::pow(1.0f - t, 0.85f) + 0.035f) * random.range(0.82f, 1.04f) *
                                smoothStep(-0.14f, 0.1f, t);
            const vec2 start = mix(0.0f, 1.0f, t) * (tip - base) + base;
            float turn = -0.5f * pi + side * random.range(0.85f, 1.12f);
            const int steps = std::max(2, static_cast<int>(reach / 90.0f));
            vec2 a = start;
            const float young = 0.75f + 0.35f * t;
            const vec3 green = mix(vec3(0.032f, 0.062f, 0.022f), vec3(0.078f, 0.125f, 0.042f),
                                   layer == 0 ? 0.15f : random.range(0.35f, 1.0f)) *
                               young;
            for (int k = 0; k < steps; ++k) {
                turn -= side * 0.055f;
                const vec2 b = a + reach / real(steps) * towards(turn);
                canvas.stroke(a, b, 5.0f, 3.5f, bark);
                drawNeedles(canvas, random, a, b, 46.0f, green * (1.0f + 0.5f * real(k) / real(steps)));
                if (k > 0 && k + 1 < steps)
                    for (const float twist : {-1.0f, 1.0f}) {
                        const vec2 end =
                            a + 0.21f * reach * (1.0f - 0.6f * real(k) / real(steps)) * towards(turn + twist * 0.75f);
                        drawNeedles(canvas, random, a, end, 36.0f, green * 0.95f);
                    }
                a = b;
            }
        }
        drawNeedles(canvas, random, mix(0.0f, 1.0f, 0.05f) * (tip - base) + base, tip, 62.0f,
                    vec3(0.06f, 0.10f, 0.035f));
    }
    return canvas.halved();
}

/// A blade that bends to one side as it rises.
void drawBlade(Canvas& canvas, vec2 root, float height, float lean, float bend, float width, const vec3& low,
               const vec3& high)
{
    constexpr int steps = 14;
    vec2 a = root;
    for (int k = 0; k < steps; ++k) {
        const float t = real(k + 1) / real(steps), before = real(k) / real(steps);
        const vec2 b(root.x + height * (lean * t + bend * t * t), root.y - height * t);
        const auto radius = [&](float s) {
            return 0.5f * width * (0.75f + 0.5f * std::sin(pi * std::min(1.0f, s + 0.15f))) *
                   (1.0f - 0.85f * s * s * s);
        };
        canvas.stroke(a, b, radius(before), radius(t), mix(low, high, t));
        a = b;
    }
}

Canvas drawReeds(std::uint32_t seed)
{
    Random random(seed, 43);
    Canvas canvas(drawnSize, Canvas::Edge::cut);
    for (int i = 0; i < 34; ++i) {
        const float tone = 0.55f + 0.6f * real(i) / 34.0f;
        const vec2 root((0.08f + 0.84f * random.unit()) * edge, edge + 10.0f);
        const bool plumed = i % 5 == 4;
        const float height = edge * (plumed ? random.range(0.78f, 0.86f) : random.range(0.5f, 0.93f));
        const float dry = random.unit() < 0.2f ? 1.0f : 0.25f * random.unit();
        const vec3 high = tone * mix(vec3(0.13f, 0.20f, 0.05f), vec3(0.30f, 0.24f, 0.12f), dry);
        const vec3 low = tone * mix(vec3(0.10f, 0.12f, 0.045f), vec3(0.20f, 0.16f, 0.09f), dry);
        const float lean = 0.10f * random.sign(), bend = 0.14f * random.sign();
        drawBlade(canvas, root, height, lean, plumed ? 0.3f * bend : bend, plumed ? 17.0f : random.range(24.0f, 40.0f),
                  low, high);
        if (!plumed) continue;
        const vec2 top(root.x + height * (lean + 0.3f * bend), root.y - height);
        for (int k = 0; k < 150; ++k) {
            const float t = random.unit();
            const vec2 a = top + vec2(5.0f * random.sign(), 190.0f * (1.0f - t) - 140.0f);
            const float turn = -0.5f * pi + 0.75f * random.sign();
            canvas.stroke(a, a + random.range(25.0f, 58.0f) * (1.1f - t) * towards(turn), 4.5f, 2.0f,
                          random.range(0.6f, 1.1f) * vec3(0.21f, 0.135f, 0.085f));
        }
    }
    return canvas.halved();
}

Canvas drawBlades(std::uint32_t seed)
{
    Random random(seed, 44);
    Canvas canvas(drawnSize, Canvas::Edge::cut);
    for (int i = 0; i < 90; ++i) {
        const float tone = 0.5f + 0.65f * real(i) / 90.0f;
        const float across = 0.5f + 0.28f * random.normal() * 0.6f;
        const vec2 root(across * edge, edge + 8.0f);
        const float spread = 0.8f * (across - 0.5f) + 0.12f * random.sign();
        const float height = edge * random.range(0.35f, 0.9f) * (1.0f - 0.6f * std::abs(across - 0.5f));
        const float dry = random.unit() < 0.12f ? 1.0f : 0.3f * random.unit();
        const vec3 high = tone * mix(vec3(0.110f, 0.150f, 0.036f), vec3(0.27f, 0.22f, 0.11f), dry);
        drawBlade(canvas, root, height, 0.5f * spread, 0.9f * spread, random.range(26.0f, 44.0f), 0.45f * high, high);
    }
    return canvas.halved();
}

} // namespace

FoliageTextures drawFoliage(std::uint32_t seed)
{
    FoliageTextures textures{drawLeaves(seed), drawSpruceBranch(seed), drawReeds(seed), drawBlades(seed)};
    for (Canvas* canvas : {&textures.leaves, &textures.needles, &textures.reeds, &textures.blades}) canvas->bleed();
    return textures;
}

void writeFoliageTextures(const std::filesystem::path& folder, const FoliageTextures& textures)
{
    writePngWithAlpha(folder / "leaves.png", textures.leaves);
    writePngWithAlpha(folder / "needles.png", textures.needles);
    writePngWithAlpha(folder / "reeds.png", textures.reeds);
    writePngWithAlpha(folder / "blades.png", textures.blades);
}

} // namespace tarn::lake
