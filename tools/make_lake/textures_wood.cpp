#include "textures.h"

namespace tarn::lake {

namespace {

vec4 opaque(const vec3& colour) { return vec4(colour, 1.0f); }

// Bark: plates between long furrows. u goes once round the trunk.

struct Bark {
    Noise noise;

    float height(vec2 uv) const
    {
        const float warp = 0.45f * noise.fractal(uv * vec2(6.0f, 5.0f), 3, ivec2(6, 5));
        const float plates = noise.ridges(vec2(uv.x * 18.0f + warp, uv.y * 4.0f), 3, ivec2(18, 4));
        const float breaks = noise.ridges(vec2(uv.x * 8.0f, uv.y * 18.0f), 2, ivec2(8, 18));
        return 1.0f - plates + 0.18f * (1.0f - breaks) +
               0.16f * noise.fractal(uv * vec2(64.0f, 24.0f), 3, ivec2(64, 24));
    }
    vec3 colour(vec2 uv) const
    {
        const float h = height(uv);
        const float lichen = smoothStep(0.1f, 0.5f, noise.fractal(uv * 5.0f + 0.3f, 4, ivec2(5)));
        const vec3 wood = mix(vec3(0.045f, 0.035f, 0.028f), vec3(0.23f, 0.185f, 0.145f), smoothStep(0.1f, 0.8f, h));
        return mix(wood, vec3(0.19f, 0.20f, 0.145f), 0.45f * lichen * smoothStep(0.3f, 0.6f, h));
    }
};

Canvas birch(std::uint32_t seed)
{
    const Noise noise(seed);
    Random random(seed, 21);
    Canvas canvas;
    canvas.fill([&](vec2 uv) {
        const float band = noise.fractal(uv * vec2(3.0f, 40.0f), 4, ivec2(3, 40));
        const float stain = smoothStep(0.15f, 0.5f, noise.fractal(uv * vec2(4.0f, 3.0f), 4, ivec2(4, 3)));
        return opaque(mix(vec3(0.60f, 0.57f, 0.51f) * (1.0f + 0.25f * band), vec3(0.34f, 0.30f, 0.25f), 0.6f * stain));
    });
    for (int i = 0; i < 260; ++i) {
        const vec2 a(random.unit() * textureSize, random.unit() * textureSize);
        const float length = random.unit() < 0.14f ? random.range(60.0f, 190.0f) : random.range(10.0f, 60.0f);
        const float width = random.range(0.8f, 3.2f) * (length > 60.0f ? 3.0f : 1.0f);
        const vec2 half(0.5f * length, 2.0f * random.sign());
        for (const float side : {-1.0f, 1.0f})
            canvas.stroke(a, a + side * half, 0.7f * width, 0.2f * width, vec3(0.05f, 0.042f, 0.035f));
    }
    return canvas;
}

// Sawn wood gone grey: fibres along v, knots, cracks.

struct Wood {
    Noise noise;

    vec2 bent(vec2 uv) const
    {
        const Cell knot = noise.cell(uv * 5.0f, ivec2(5));
        const float pull = knot.id > 0.62f ? std::exp(-knot.nearest * knot.nearest * 40.0f) : 0.0f;
        return vec2(uv.x + 0.02f * pull * (knot.offset.x > 0.0f ? 1.0f : -1.0f) +
                        0.008f * noise.fractal(uv * vec2(8.0f, 3.0f), 2, ivec2(8, 3)),
                    uv.y);
    }
    float fibre(vec2 uv) const
    {
        const vec2 q = bent(uv);
        return 0.6f * noise.fractal(q * vec2(48.0f, 3.0f), 3, ivec2(48, 3)) +
               0.5f * noise.fractal(q * vec2(220.0f, 9.0f), 2, ivec2(220, 9));
    }
    float knot(vec2 uv) const
    {
        const Cell cell = noise.cell(uv * 5.0f, ivec2(5));
        return cell.id > 0.62f ? smoothStep(0.11f, 0.05f, cell.nearest) : 0.0f;
    }
    float crack(vec2 uv) const
    {
        const float line = std::abs(noise.fractal(bent(uv) * vec2(22.0f, 2.0f) + 0.4f, 2, ivec2(22, 2)));
        return smoothStep(0.025f, 0.0f, line) * smoothStep(0.0f, 0.25f, noise.at(uv * 6.0f, ivec2(6)));
    }
    float height(vec2 uv) const { return 0.5f * fibre(uv) - 0.9f * crack(uv) + 0.25f * knot(uv); }
    vec3 colour(vec2 uv) const
    {
        const float f = fibre(uv);
        const float grey = smoothStep(-0.4f, 0.4f, noise.fractal(uv * 4.0f, 3, ivec2(4)));
        const vec3 base = mix(vec3(0.40f, 0.31f, 0.22f), vec3(0.38f, 0.355f, 0.32f), grey) * (1.0f + 0.55f * f);
        return mix(base, vec3(0.11f, 0.075f, 0.05f), std::max(0.75f * knot(uv), 0.85f * crack(uv)));
    }
};

// Oil paint on planks: brush marks, weathering, chips down to the wood.

struct Paint {
    Noise noise;

    vec3 colour(vec2 uv) const
    {
        const float brush = noise.fractal(uv * vec2(4.0f, 90.0f), 3, ivec2(4, 90));
        const float dirt = smoothStep(-0.1f, 0.6f, noise.fractal(uv * 6.0f, 5, ivec2(6), 0.6f));
        const float chip = smoothStep(0.40f, 0.46f, noise.fractal(uv * vec2(14.0f, 22.0f), 5, ivec2(14, 22), 0.6f));
        const vec3 paint = vec3(0.80f) * (1.0f + 0.09f * brush) * (1.0f - 0.22f * dirt);
        return mix(paint, vec3(0.30f, 0.24f, 0.18f), chip);
    }
};

template <typename Pattern> Canvas drawn(const Pattern& pattern)
{
    Canvas canvas;
    canvas.fill([&](vec2 uv) { return opaque(pattern.colour(uv)); });
    return canvas;
}

} // namespace

void writeWoodTextures(const std::filesystem::path& folder, std::uint32_t seed)
{
    const Bark bark{Noise(seed + 31)};
    writeJpeg(folder / "bark.jpg", drawn(bark));
    writeJpegData(folder / "bark_normal.jpg", normalMap([&](vec2 uv) { return bark.height(uv); }, 16.0f));
    writeJpeg(folder / "birch.jpg", birch(seed + 32));
    const Wood wood{Noise(seed + 33)};
    writeJpeg(folder / "wood.jpg", drawn(wood));
    writeJpegData(folder / "wood_normal.jpg", normalMap([&](vec2 uv) { return wood.height(uv); }, 3.0f));
    writeJpeg(folder / "paint.jpg", drawn(Paint{Noise(seed + 34)}));
}

} // namespace tarn::lake
