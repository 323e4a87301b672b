#include "noise.h"

#include <array>
#include <initializer_list>

namespace tarn::lake {

namespace {

int wrap(int i, int period)
{
    if (period <= 0) return i;
    const int r = i % period;
    return r < 0 ? r + period : r;
}

float fade(float t) { return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f); }

float slope2(std::uint32_t h, float x, float y)
{
    // 16 directions round the circle, so that no axis shows.
    static const std::array<vec2, 16> directions = [] {
        std::array<vec2, 16> all;
        for (int i = 0; i < 16; ++i) {
            const float angle = real(i) * (2.0f * pi / 16.0f);
            all[static_cast<std::size_t>(i)] = {std::cos(angle), std::sin(angle)};
        }
        return all;
    }();
    const vec2& direction = directions[h >> 28];
    return direction.x * x + direction.y * y;
}

float slope3(std::uint32_t h, float x, float y, float z)
{
    const std::uint32_t k = h >> 28;
    const float u = k < 8 ? x : y;
    const float v = k < 4 ? y : (k == 12 || k == 14 ? x : z);
    return ((k & 1u) ? -u : u) + ((k & 2u) ? -v : v);
}

} // namespace

std::uint32_t hash(int x, int y, int z, std::uint32_t seed)
{
    std::uint32_t h = seed * 0x9e3779b9u + 0x7f4a7c15u;
    for (const int word : {x, y, z}) {
        h ^= static_cast<std::uint32_t>(word) * 0x85ebca6bu;
        h = (h << 13) | (h >> 19);
        h = h * 5u + 0xe6546b64u;
        h ^= h >> 16;
        h *= 0xc2b2ae35u;
    }
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    return h ^ (h >> 13);
}

float hashUnit(int x, int y, int z, std::uint32_t seed)
{
    return static_cast<float>(hash(x, y, z, seed) >> 8) * 0x1p-24f;
}

float Noise::at(vec2 p, ivec2 period) const
{
    const float fx = std::floor(p.x), fy = std::floor(p.y);
    const int x = static_cast<int>(fx), y = static_cast<int>(fy);
    const float dx = p.x - fx, dy = p.y - fy;
    const auto corner = [&](int i, int j) {
        return slope2(hash(wrap(x + i, period.x), wrap(y + j, period.y), 0, seed_), dx - real(i), dy - real(j));
    };
    const float u = fade(dx), v = fade(dy);
    return 1.4f * mix(mix(corner(0, 0), corner(1, 0), u), mix(corner(0, 1), corner(1, 1), u), v);
}

float Noise::at(const vec3& p) const
{
    const vec3 f = glm::floor(p);
    const vec3 d = p - f;
    const int x = static_cast<int>(f.x), y = static_cast<int>(f.y), z = static_cast<int>(f.z);
    const auto corner = [&](int i, int j, int k) {
        return slope3(hash(x + i, y + j, z + k, seed_), d.x - real(i), d.y - real(j), d.z - real(k));
    };
    const float u = fade(d.x), v = fade(d.y), w = fade(d.z);
    const auto layer = [&](int k) {
        return mix(mix(corner(0, 0, k), corner(1, 0, k), u), mix(corner(0, 1, k), corner(1, 1, k), u), v);
    };
    return mix(layer(0), layer(1), w);
}

float Noise::fractal(vec2 p, int octaves, ivec2 period, float gain) const
{
    float sum = 0.0f, amplitude = 1.0f, total = 0.0f;
    for (int octave = 0; octave < octaves; ++octave) {
        sum += amplitude * Noise(seed_ + static_cast<std::uint32_t>(octave) * 101u).at(p, period);
        total += amplitude;
        amplitude *= gain;
        p *= 2.0f;
        period *= 2;
    }
    return sum / total;
}

float Noise::fractal(const vec3& p, int octaves, float gain) const
{
    float sum = 0.0f, amplitude = 1.0f, total = 0.0f, frequency = 1.0f;
    for (int octave = 0; octave < octaves; ++octave) {
        sum += amplitude * Noise(seed_ + static_cast<std::uint32_t>(octave) * 101u).at(frequency * p);
        total += amplitude;
        amplitude *= gain;
        frequency *= 2.0f;
    }
    return sum / total;
}

float Noise::ridges(vec2 p, int octaves, ivec2 period) const
{
    float sum = 0.0f, amplitude = 1.0f, total = 0.0f;
    for (int octave = 0; octave < octaves; ++octave) {
        const float crest = 1.0f - std::abs(Noise(seed_ + static_cast<std::uint32_t>(octave) * 131u).at(p, period));
        sum += amplitude * crest * crest;
        total += amplitude;
        amplitude *= 0.5f;
        p *= 2.0f;
        period *= 2;
    }
    return sum / total;
}

float Noise::ridges(const vec3& p, int octaves) const
{
    float sum = 0.0f, amplitude = 1.0f, total = 0.0f, frequency = 1.0f;
    for (int octave = 0; octave < octaves; ++octave) {
        const float crest = 1.0f - std::abs(Noise(seed_ + static_cast<std::uint32_t>(octave) * 131u).at(frequency * p));
        sum += amplitude * crest * crest;
        total += amplitude;
        amplitude *= 0.5f;
        frequency *= 2.0f;
    }
    return sum / total;
}

Cell Noise::cell(vec2 p, ivec2 period) const
{
    const int x = static_cast<int>(std::floor(p.x)), y = static_cast<int>(std::floor(p.y));
    Cell result{.nearest = 9.0f, .second = 9.0f};
    for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
            const int cx = wrap(x + i, period.x), cy = wrap(y + j, period.y);
            const vec2 feature(real(x + i) + hashUnit(cx, cy, 1, seed_), real(y + j) + hashUnit(cx, cy, 2, seed_));
            const float distance = glm::length(p - feature);
            if (distance < result.nearest) {
                result.second = result.nearest;
                result.nearest = distance;
                result.offset = p - feature;
                result.id = hashUnit(cx, cy, 3, seed_);
            } else if (distance < result.second) {
                result.second = distance;
            }
        }
    }
    return result;
}

} // namespace tarn::lake
