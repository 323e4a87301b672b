#include "textures.h"

namespace tarn::lake {

namespace {

vec4 opaque(const vec3& colour) { return vec4(colour, 1.0f); }

/// A rounded stone in a Worley cell: height 0 to 1, 0 outside.
float stone(const Cell& cell, float size)
{
    const float gap = 0.5f * (cell.second - cell.nearest);
    const float dome = saturate(1.0f - (cell.nearest * cell.nearest) / (size * size));
    return std::sqrt(dome) * smoothStep(0.0f, 0.08f, gap);
}

// Sand: ripples about 11 cm apart on a tile of 3 m, dark litter in their troughs, a pebble here and there.

struct Sand {
    Noise noise;

    float ripple(vec2 uv) const
    {
        const float warp =
            2.2f * noise.fractal(uv * 3.0f, 3, ivec2(3)) + 0.35f * noise.fractal(uv * 16.0f, 2, ivec2(16));
        const float phase = 2.0f * pi * (26.0f * uv.y + warp);
        return 0.5f + 0.5f * std::sin(phase + 0.5f * std::sin(phase));
    }
    float rippling(vec2 uv) const { return smoothStep(-0.5f, 0.5f, noise.fractal(uv * 4.0f + 0.5f, 2, ivec2(4))); }
    float grain(vec2 uv) const { return noise.fractal(uv * 256.0f, 2, ivec2(256)); }
    static constexpr float rare = 0.90f;
    Cell pebble(vec2 uv) const { return noise.cell(uv * 40.0f, ivec2(40)); }
    float pebbleHeight(const Cell& cell) const
    {
        return cell.id > rare ? stone(cell, 0.10f + 0.35f * (cell.id - rare) / (1.0f - rare)) : 0.0f;
    }

    float height(vec2 uv) const
    {
        return 0.55f * ripple(uv) * rippling(uv) + 0.10f * grain(uv) + 0.9f * pebbleHeight(pebble(uv)) +
               0.4f * noise.fractal(uv * 8.0f, 3, ivec2(8));
    }
    vec3 colour(vec2 uv) const
    {
        const float tone = 0.95f + 0.20f * grain(uv) + 0.16f * noise.fractal(uv * 6.0f, 4, ivec2(6));
        const float litter = rippling(uv) * smoothStep(0.35f, 0.0f, ripple(uv));
        vec3 sand = tone * mix(vec3(1.0f), vec3(0.74f, 0.70f, 0.66f), litter);
        const float speck = hashUnit(static_cast<int>(uv.x * 512.0f), static_cast<int>(uv.y * 512.0f), 5, 77u);
        if (speck > 0.985f) sand *= 0.62f;
        const Cell cell = pebble(uv);
        const float stones = pebbleHeight(cell);
        const float kind = std::fmod(cell.id * 97.0f, 1.0f);
        const vec3 rock = mix(vec3(0.62f, 0.60f, 0.57f), vec3(1.15f, 1.04f, 0.92f), kind);
        return mix(sand, rock * (0.8f + 0.25f * stones), smoothStep(0.05f, 0.4f, stones));
    }
};

// Pebbles: two sizes of stones packed on a dark ground, on a tile of 2.5 m.

struct Pebbles {
    Noise noise;

    float height(vec2 uv) const
    {
        const vec2 warped = uv + 0.012f * vec2(noise.at(uv * 20.0f, ivec2(20)), noise.at(uv * 20.0f + 0.3f, ivec2(20)));
        const float large = stone(noise.cell(warped * 18.0f, ivec2(18)), 0.62f);
        const float small = stone(noise.cell(warped * 52.0f + 0.5f, ivec2(52)), 0.6f);
        return std::max(large, 0.42f * small) + 0.05f * noise.fractal(uv * 128.0f, 2, ivec2(128));
    }
    vec3 colour(vec2 uv) const
    {
        const vec2 warped = uv + 0.012f * vec2(noise.at(uv * 20.0f, ivec2(20)), noise.at(uv * 20.0f + 0.3f, ivec2(20)));
        const Cell big = noise.cell(warped * 18.0f, ivec2(18)), fine = noise.cell(warped * 52.0f + 0.5f, ivec2(52));
        const float large = stone(big, 0.62f), small = 0.42f * stone(fine, 0.6f);
        const float id = large >= small ? big.id : fine.id;
        const vec3 rock = mix(vec3(0.50f, 0.49f, 0.47f), vec3(1.1f, 0.95f, 0.78f), id * id);
        const float depth = std::max(large, small);
        const float silt = smoothStep(0.0f, 0.6f, 0.3f + noise.fractal(uv * 7.0f, 3, ivec2(7)));
        const float grain = 1.0f + 0.2f * noise.fractal(uv * 100.0f, 3, ivec2(100));
        return mix(rock, vec3(0.72f, 0.68f, 0.60f), 0.3f + 0.55f * silt) * (0.55f + 0.5f * depth) * grain;
    }
};

// Rock: beds, blocks split by cracks, lichen; a tile of 4 m.

struct Rock {
    Noise noise;

    vec2 warped(vec2 uv) const
    {
        return uv + 0.09f * vec2(noise.fractal(uv * 5.0f, 4, ivec2(5)), noise.fractal(uv * 5.0f + 0.37f, 4, ivec2(5)));
    }
    /// 1, falling to 0 in a joint between blocks; joints close up here and there.
    float joint(vec2 uv) const
    {
        const Cell cell = noise.cell(warped(uv) * vec2(4.0f, 7.0f), ivec2(4, 7));
        const float open = smoothStep(-0.25f, 0.3f, noise.fractal(uv * 4.0f + 0.6f, 3, ivec2(4)));
        return 1.0f - open * smoothStep(0.09f, 0.0f, cell.second - cell.nearest);
    }
    float height(vec2 uv) const
    {
        const Cell block = noise.cell(warped(uv) * vec2(4.0f, 7.0f), ivec2(4, 7));
        const Cell chip = noise.cell(warped(uv) * 15.0f, ivec2(15));
        return 0.6f * noise.ridges(warped(uv) * 5.0f, 5, ivec2(5)) + 0.35f * joint(uv) + 0.35f * block.id +
               0.22f * chip.id + 0.30f * noise.fractal(uv * 20.0f, 5, ivec2(20), 0.68f);
    }
    vec3 colour(vec2 uv) const
    {
        const float mottle = noise.fractal(uv * 9.0f, 7, ivec2(9), 0.7f);
        const float crest = noise.ridges(warped(uv) * 5.0f, 5, ivec2(5)) - 0.5f;
        const float bed = noise.fractal(warped(uv) * vec2(3.0f, 14.0f), 3, ivec2(3, 14));
        const float lichen = smoothStep(0.10f, 0.32f, noise.fractal(uv * 11.0f + 0.5f, 6, ivec2(11), 0.65f));
        const vec3 hue = mix(vec3(1.06f, 0.98f, 0.90f), vec3(0.88f, 0.96f, 1.04f), saturate(0.5f + bed));
        const vec3 stone = (0.85f + 0.95f * mottle + 0.30f * crest + 0.12f * bed) * hue;
        return mix(stone, vec3(1.15f, 1.15f, 0.92f), 0.4f * lichen) * mix(0.5f, 1.0f, joint(uv));
    }
};

// Grass and forest floor are drawn stroke by stroke.

Canvas grass(std::uint32_t seed)
{
    Random random(seed, 11);
    Canvas canvas;
    canvas.fill([](vec2) { return opaque(vec3(0.20f, 0.20f, 0.17f)); });
    for (int i = 0; i < 34000; ++i) {
        const vec2 root(random.unit() * textureSize, random.unit() * textureSize);
        const float turn = random.angle(), length = random.range(12.0f, 34.0f);
        const vec2 tip = root + length * vec2(std::cos(turn), std::sin(turn));
        const vec2 middle = 0.5f * (root + tip) + random.range(-4.0f, 4.0f) * vec2(-std::sin(turn), std::cos(turn));
        const float age = real(i) / 34000.0f, tone = 0.28f + 0.75f * age * random.range(0.6f, 1.1f);
        const float dry = random.unit() < 0.09f ? 1.0f : random.range(0.0f, 0.35f);
        const vec3 colour = tone * mix(vec3(0.90f, 1.04f, 0.80f), vec3(1.35f, 1.12f, 0.95f), dry);
        canvas.stroke(root, middle, 1.5f, 1.3f, 0.85f * colour);
        canvas.stroke(middle, tip, 1.3f, 0.4f, colour);
    }
    return canvas;
}

Canvas forestFloor(std::uint32_t seed)
{
    const Noise noise(seed);
    Random random(seed, 12);
    Canvas canvas;
    canvas.fill([&](vec2 uv) {
        return opaque((0.5f + 0.3f * noise.fractal(uv * 16.0f, 5, ivec2(16), 0.6f)) * vec3(1.0f, 0.92f, 0.85f));
    });
    for (int i = 0; i < 900; ++i) { // fallen leaves
        const vec2 centre(random.unit() * textureSize, random.unit() * textureSize);
        const float turn = random.angle(), length = random.range(9.0f, 18.0f),
                    width = length * random.range(0.4f, 0.6f);
        const vec3 colour =
            random.range(0.35f, 0.95f) * mix(vec3(1.2f, 0.85f, 0.6f), vec3(1.1f, 1.05f, 0.8f), random.unit());
        const vec2 axis(std::cos(turn), std::sin(turn));
        canvas.stamp(
            centre, length,
            [&](vec2 d) {
                const vec2 q(glm::dot(d, axis) / length, (axis.x * d.y - axis.y * d.x) / width);
                return width * (1.0f - glm::length(vec2(q.x, q.y * (1.0f + 0.8f * q.x * q.x))));
            },
            [&](vec2 d) { return colour * (std::abs(axis.x * d.y - axis.y * d.x) < 0.8f ? 0.75f : 1.0f); });
    }
    for (int i = 0; i < 22000; ++i) { // needles
        const vec2 root(random.unit() * textureSize, random.unit() * textureSize);
        const float turn = random.angle(), length = random.range(7.0f, 15.0f);
        const vec3 colour =
            random.range(0.35f, 1.05f) * mix(vec3(1.15f, 0.92f, 0.72f), vec3(0.8f, 0.85f, 0.7f), random.unit());
        canvas.stroke(root, root + length * vec2(std::cos(turn), std::sin(turn)), 0.9f, 0.5f, colour);
    }
    for (int i = 0; i < 60; ++i) { // twigs
        vec2 a(random.unit() * textureSize, random.unit() * textureSize);
        float turn = random.angle();
        for (int k = 0; k < 4; ++k) {
            turn += 0.3f * random.sign();
            const vec2 b = a + 20.0f * vec2(std::cos(turn), std::sin(turn));
            canvas.stroke(a, b, 2.2f - 0.4f * real(k), 1.8f - 0.4f * real(k), vec3(0.42f, 0.36f, 0.31f));
            a = b;
        }
    }
    return canvas;
}

template <typename Pattern>
void writePattern(const std::filesystem::path& folder, const std::string& name, const Pattern& pattern, float strength)
{
    Canvas colour;
    colour.fill([&](vec2 uv) { return opaque(pattern.colour(uv)); });
    setMean(colour, vec3(neutralMean));
    writeJpeg(folder / (name + ".jpg"), colour);
    writeJpegData(folder / (name + "_normal.jpg"), normalMap([&](vec2 uv) { return pattern.height(uv); }, strength));
}

} // namespace

void writeGroundTextures(const std::filesystem::path& folder, std::uint32_t seed)
{
    writePattern(folder, "sand", Sand{Noise(seed + 1)}, 5.0f);
    writePattern(folder, "pebbles", Pebbles{Noise(seed + 2)}, 9.0f);
    writePattern(folder, "rock", Rock{Noise(seed + 3)}, 22.0f);

    Canvas meadow = grass(seed + 4);
    setMean(meadow, vec3(neutralMean));
    writeJpeg(folder / "grass.jpg", meadow);

    Canvas floor = forestFloor(seed + 5);
    setMean(floor, vec3(neutralMean));
    writeJpeg(folder / "forest.jpg", floor);
    const Noise lumps(seed + 6);
    writeJpegData(folder / "forest_normal.jpg", normalMap(
                                                    [&](vec2 uv) {
                                                        const int x = static_cast<int>(uv.x * textureSize);
                                                        const int y = static_cast<int>((1.0f - uv.y) * textureSize);
                                                        return 0.7f * lumps.fractal(uv * 12.0f, 4, ivec2(12)) +
                                                               0.5f * floor.at(x, y).y;
                                                    },
                                                    5.0f));
}

} // namespace tarn::lake
