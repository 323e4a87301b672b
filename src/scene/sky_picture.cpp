#include "scene/sky_picture.h"

#include "base/error.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tarn {

SkyLayout skyLayout(const Image& image)
{
    const int w = image.width, h = image.height;
    if (w == 2 * h) return SkyLayout::latLong;
    if (w == 6 * h) return SkyLayout::stripWide;
    if (h == 6 * w) return SkyLayout::stripTall;
    if (w % 4 == 0 && 3 * w == 4 * h) return SkyLayout::crossWide;
    if (h % 4 == 0 && 3 * h == 4 * w) return SkyLayout::crossTall;
    throw Error("{}: a sky of {}x{} pixels is neither 2:1 (latitude-longitude) nor 4:3, 3:4, 6:1 or 1:6 (cube map)",
                image.name, w, h);
}

Image linearPicture(const Image& image)
{
    std::array<float, 256> decoded;
    for (std::size_t i = 0; i < decoded.size(); ++i) decoded[i] = srgbDecode(static_cast<float>(i) / 255.0f);

    Image result;
    result.name = image.name;
    result.width = image.width;
    result.height = image.height;
    result.channels = 3;
    result.floats.resize(result.size());
    const auto channels = static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0; i < result.floats.size(); ++i) {
        const std::size_t source = i / 3 * channels + (channels >= 3 ? i % 3 : 0);
        const float value = image.isFloat() ? image.floats[source] : decoded[image.bytes[source]];
        // Half floats end at 65504; a picture's infinity is "very bright".
        result.floats[i] = std::isnan(value) ? 0.0f : std::clamp(value, 0.0f, 65504.0f);
    }
    return result;
}

namespace {

struct Rect {
    int x, y, width, height;
};

vec3 texel(const Image& image, int x, int y)
{
    const auto at =
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
    return {image.floats[at], image.floats[at + 1], image.floats[at + 2]};
}

/// @param u,v in 0..1 over the rectangle, v downwards
vec3 bilinear(const Image& image, const Rect& rect, float u, float v, bool wrapU)
{
    const float x = u * static_cast<float>(rect.width) - 0.5f, y = v * static_cast<float>(rect.height) - 0.5f;
    const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
    const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
    const auto column = [&](int i) {
        return rect.x + (wrapU ? (i + rect.width) % rect.width : std::clamp(i, 0, rect.width - 1));
    };
    const auto row = [&](int i) { return rect.y + std::clamp(i, 0, rect.height - 1); };
    return glm::mix(glm::mix(texel(image, column(x0), row(y0)), texel(image, column(x0 + 1), row(y0)), fx),
                    glm::mix(texel(image, column(x0), row(y0 + 1)), texel(image, column(x0 + 1), row(y0 + 1)), fx), fy);
}

struct CubePoint {
    int face; // right, left, top, bottom, front (-z), back (+z)
    float u, v;
};

CubePoint cubePoint(const vec3& d)
{
    const vec3 size = glm::abs(d);
    vec3 onFace; // along u, along v (downwards), along the face's axis
    int face = 0;
    if (size.x >= size.y && size.x >= size.z) {
        face = d.x > 0.0f ? 0 : 1;
        onFace = d.x > 0.0f ? vec3(d.z, -d.y, size.x) : vec3(-d.z, -d.y, size.x);
    } else if (size.y >= size.z) {
        face = d.y > 0.0f ? 2 : 3;
        onFace = d.y > 0.0f ? vec3(d.x, -d.z, size.y) : vec3(d.x, d.z, size.y);
    } else {
        face = d.z < 0.0f ? 4 : 5;
        onFace = d.z < 0.0f ? vec3(d.x, -d.y, size.z) : vec3(-d.x, -d.y, size.z);
    }
    return {face, 0.5f + 0.5f * onFace.x / onFace.z, 0.5f + 0.5f * onFace.y / onFace.z};
}

/// Column and row of a face among the squares of the picture.
ivec2 cellOf(SkyLayout layout, int face)
{
    static constexpr int wide[6][2] = {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}};
    static constexpr int tall[6][2] = {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3}};
    switch (layout) {
    case SkyLayout::crossWide: return {wide[face][0], wide[face][1]};
    case SkyLayout::crossTall: return {tall[face][0], tall[face][1]};
    case SkyLayout::stripWide: return {face, 0};
    case SkyLayout::stripTall:
    case SkyLayout::latLong: break;
    }
    return {0, face};
}

int faceSize(SkyLayout layout, const Image& image)
{
    switch (layout) {
    case SkyLayout::crossWide: return image.width / 4;
    case SkyLayout::crossTall: return image.height / 4;
    case SkyLayout::stripWide: return image.height;
    case SkyLayout::stripTall:
    case SkyLayout::latLong: break;
    }
    return image.width;
}

} // namespace

vec3 samplePicture(const Image& image, const vec3& direction)
{
    const SkyLayout layout = skyLayout(image);
    if (layout == SkyLayout::latLong) {
        const float u = 0.5f + std::atan2(direction.x, -direction.z) / (2.0f * pi);
        const float v = std::acos(std::clamp(direction.y, -1.0f, 1.0f)) / pi;
        return bilinear(image, {0, 0, image.width, image.height}, u, v, true);
    }
    CubePoint point = cubePoint(direction);
    // The back of a tall cross hangs upside down below the bottom.
    if (layout == SkyLayout::crossTall && point.face == 5) point = {5, 1.0f - point.u, 1.0f - point.v};
    const int size = faceSize(layout, image);
    const ivec2 cell = cellOf(layout, point.face);
    return bilinear(image, {cell.x * size, cell.y * size, size, size}, point.u, point.v, false);
}

} // namespace tarn
