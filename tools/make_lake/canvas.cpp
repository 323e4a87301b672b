#include "canvas.h"

#include "base/error.h"
#include "base/files.h"

#include <OpenImageIO/imageio.h>

#include <cmath>

namespace tarn::lake {

namespace {

float encodeSrgb(float linear)
{
    const float c = saturate(linear);
    return c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1.0f / 2.4f) - 0.055f;
}

unsigned char toByte(float value) { return static_cast<unsigned char>(std::lround(255.0f * saturate(value))); }

void writePicture(const std::filesystem::path& file, const Canvas& canvas, int channels, bool srgb, int quality)
{
    const int size = canvas.size();
    std::vector<unsigned char> bytes;
    bytes.reserve(static_cast<std::size_t>(size * size * channels));
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const vec4& pixel = canvas.at(x, y);
            for (int c = 0; c < 3; ++c) bytes.push_back(toByte(srgb ? encodeSrgb(pixel[c]) : pixel[c]));
            if (channels == 4) bytes.push_back(toByte(pixel.w));
        }
    }
    writeWhole(file, [&](const std::filesystem::path& temporary) {
        const auto output = OIIO::ImageOutput::create(temporary.string());
        if (!output) throw Error("{}: no writer for this kind of picture: {}", file.string(), OIIO::geterror());
        OIIO::ImageSpec spec(size, size, channels, OIIO::TypeDesc::UINT8);
        spec.attribute("png:compressionLevel", 9);
        spec.attribute("Compression", quality > 0 ? "jpeg:" + std::to_string(quality) : std::string("zip"));
        spec.attribute("oiio:UnassociatedAlpha", 1);
        if (!output->open(temporary.string(), spec) || !output->write_image(OIIO::TypeDesc::UINT8, bytes.data()) ||
            !output->close())
            throw Error("{}: cannot write the picture: {}", file.string(), output->geterror());
    });
}

} // namespace

vec4& Canvas::at(int x, int y)
{
    const int column = ((x % size_) + size_) % size_, row = ((y % size_) + size_) % size_;
    return pixels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(size_) + static_cast<std::size_t>(column)];
}

const vec4& Canvas::at(int x, int y) const { return const_cast<Canvas*>(this)->at(x, y); }

void Canvas::fill(const std::function<vec4(vec2)>& paint)
{
    for (int y = 0; y < size_; ++y)
        for (int x = 0; x < size_; ++x) at(x, y) = paint(vec2(real(x) + 0.5f, real(size_ - y) - 0.5f) / real(size_));
}

void Canvas::stroke(vec2 a, vec2 b, float radiusA, float radiusB, const vec3& colour)
{
    const vec2 middle = 0.5f * (a + b), along = b - a;
    const float length2 = std::max(glm::dot(along, along), 1e-6f);
    const float reach = 0.5f * std::sqrt(length2) + std::max(radiusA, radiusB) + 1.0f;
    stamp(
        middle, reach,
        [&](vec2 offset) {
            const vec2 q = middle + offset - a;
            const float t = saturate(glm::dot(q, along) / length2);
            return mix(radiusA, radiusB, t) - glm::length(q - t * along);
        },
        [&](vec2) { return colour; });
}

void Canvas::stamp(vec2 centre, float reach, const std::function<float(vec2)>& inside,
                   const std::function<vec3(vec2)>& colour)
{
    const int left = static_cast<int>(std::floor(centre.x - reach)),
              right = static_cast<int>(std::ceil(centre.x + reach));
    const int top = static_cast<int>(std::floor(centre.y - reach)),
              bottom = static_cast<int>(std::ceil(centre.y + reach));
    for (int y = top; y <= bottom; ++y) {
        for (int x = left; x <= right; ++x) {
            const vec2 offset = vec2(real(x) + 0.5f, real(y) + 0.5f) - centre;
            const float coverage = saturate(inside(offset) + 0.5f);
            if (coverage <= 0.0f) continue;
            if (edge_ == Edge::cut && (x < 0 || y < 0 || x >= size_ || y >= size_)) continue;
            vec4& pixel = at(x, y);
            const float alpha = coverage + pixel.w * (1.0f - coverage);
            const vec3 blended = (coverage * colour(offset) + (1.0f - coverage) * pixel.w * vec3(pixel)) / alpha;
            pixel = vec4(blended, alpha);
        }
    }
}

Canvas Canvas::halved() const
{
    Canvas small(size_ / 2, edge_);
    for (int y = 0; y < small.size_; ++y) {
        for (int x = 0; x < small.size_; ++x) {
            vec3 colour(0.0f);
            float alpha = 0.0f;
            for (int k = 0; k < 4; ++k) {
                const vec4& pixel = at(2 * x + k % 2, 2 * y + k / 2);
                colour += pixel.w * vec3(pixel);
                alpha += pixel.w;
            }
            small.at(x, y) = vec4(alpha > 0.0f ? colour / alpha : vec3(0.0f), 0.25f * alpha);
        }
    }
    return small;
}

void Canvas::bleed()
{
    // A pyramid of coverage-weighted averages: an empty pixel takes the colour of the finest level that has
    // one.
    std::vector<Canvas> levels{*this};
    while (levels.back().size_ > 1) levels.push_back(levels.back().halved());
    for (int y = 0; y < size_; ++y) {
        for (int x = 0; x < size_; ++x) {
            vec4& pixel = at(x, y);
            if (pixel.w > 0.02f) continue;
            for (std::size_t level = 1; level < levels.size(); ++level) {
                const vec4& coarse = levels[level].at(x >> level, y >> level);
                if (coarse.w <= 0.004f) continue;
                pixel = vec4(vec3(coarse), pixel.w);
                break;
            }
        }
    }
}

Canvas normalMap(const std::function<float(vec2)>& height, float strength)
{
    const int n = textureSize;
    std::vector<float> heights(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
    const auto index = [n](int x, int y) {
        return static_cast<std::size_t>((y + n) % n) * static_cast<std::size_t>(n) +
               static_cast<std::size_t>((x + n) % n);
    };
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
            heights[index(x, y)] = strength * height(vec2(real(x) + 0.5f, real(n - y) - 0.5f) / real(n));
    Canvas canvas(n);
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const float dx = 0.5f * (heights[index(x + 1, y)] - heights[index(x - 1, y)]);
            const float dy = 0.5f * (heights[index(x, y - 1)] - heights[index(x, y + 1)]);
            canvas.at(x, y) = vec4(0.5f + 0.5f * glm::normalize(vec3(-dx, -dy, 1.0f)), 1.0f);
        }
    }
    return canvas;
}

void setMean(Canvas& canvas, const vec3& mean)
{
    glm::dvec3 sum(0.0);
    for (int y = 0; y < canvas.size(); ++y)
        for (int x = 0; x < canvas.size(); ++x) sum += glm::dvec3(canvas.at(x, y));
    const vec3 scale = mean * real(canvas.size() * canvas.size()) / vec3(sum);
    for (int y = 0; y < canvas.size(); ++y)
        for (int x = 0; x < canvas.size(); ++x) canvas.at(x, y) *= vec4(scale, 1.0f);
}

void writeJpeg(const std::filesystem::path& file, const Canvas& canvas, int quality)
{
    writePicture(file, canvas, 3, true, quality);
}

void writeJpegData(const std::filesystem::path& file, const Canvas& canvas, int quality)
{
    writePicture(file, canvas, 3, false, quality);
}

void writePngWithAlpha(const std::filesystem::path& file, const Canvas& canvas)
{
    writePicture(file, canvas, 4, true, 0);
}

} // namespace tarn::lake
