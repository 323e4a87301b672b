#include "reference/texture_lookup.h"

#include <array>
#include <cmath>

namespace tarn::reference {

namespace {

const std::array<float, 256>& decodeTable()
{
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = srgbDecode(static_cast<float>(i) / 255.0f);
        return values;
    }();
    return table;
}

int wrapped(int index, int size)
{
    const int rest = index % size;
    return rest < 0 ? rest + size : rest;
}

vec4 texel(const Image& image, int x, int y, Encoding encoding)
{
    const std::size_t first =
        (static_cast<std::size_t>(wrapped(y, image.height)) * static_cast<std::size_t>(image.width) +
         static_cast<std::size_t>(wrapped(x, image.width))) *
        static_cast<std::size_t>(image.channels);
    const auto value = [&](int c) {
        const std::size_t i = first + static_cast<std::size_t>(c);
        if (image.isFloat()) return image.floats[i];
        const std::uint8_t byte = image.bytes[i];
        return encoding == Encoding::srgb && c < 3 ? decodeTable()[byte] : static_cast<float>(byte) / 255.0f;
    };
    if (image.channels < 3) return vec4(vec3(value(0)), 1.0f);
    return {value(0), value(1), value(2), image.channels > 3 ? value(3) : 1.0f};
}

} // namespace

vec4 sampleTexture(const Image& image, vec2 uv, Encoding encoding)
{
    const float x = (uv.x - std::floor(uv.x)) * static_cast<float>(image.width) - 0.5f;
    const float v = 1.0f - uv.y;
    const float y = (v - std::floor(v)) * static_cast<float>(image.height) - 0.5f;
    const float x0 = std::floor(x), y0 = std::floor(y);
    const int ix = static_cast<int>(x0), iy = static_cast<int>(y0);
    const vec4 upper = glm::mix(texel(image, ix, iy, encoding), texel(image, ix + 1, iy, encoding), x - x0);
    const vec4 lower = glm::mix(texel(image, ix, iy + 1, encoding), texel(image, ix + 1, iy + 1, encoding), x - x0);
    return glm::mix(upper, lower, y - y0);
}

} // namespace tarn::reference
