#include "render/alpha_mips.h"

#include "base/error.h"
#include "base/hash.h"
#include "optics/optics.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

namespace tarn {

namespace {

std::uint8_t toByte(double value) { return static_cast<std::uint8_t>(std::clamp(255.0 * value + 0.5, 0.0, 255.0)); }

/// A level in linear values: colours as they are, alpha not yet scaled.
struct Level {
    int width = 0, height = 0, channels = 0;
    std::vector<float> values;

    std::size_t first(int x, int y) const
    {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
               static_cast<std::size_t>(channels);
    }
};

Level decoded(const Image& image, const CutOut& cutOut, CutOutLevels kind)
{
    std::array<float, 256> colour{};
    for (std::size_t i = 0; i < colour.size(); ++i)
        colour[i] = cutOut.isSrgb ? srgbDecode(static_cast<float>(i) / 255.0f) : static_cast<float>(i) / 255.0f;
    Level level{image.width, image.height, image.channels, std::vector<float>(image.bytes.size())};
    for (std::size_t i = 0; i < image.bytes.size(); ++i) {
        const bool isAlpha = static_cast<int>(i % static_cast<std::size_t>(image.channels)) == cutOut.channel;
        float& value = level.values[i];
        value = isAlpha ? static_cast<float>(image.bytes[i]) / 255.0f : colour[image.bytes[i]];
        if (isAlpha && kind == CutOutLevels::coverage) value = value >= cutOut.cutoff ? 1.0f : 0.0f;
    }
    return level;
}

/// The part of each source row or column that a texel of the next level covers.
struct Part {
    int first = 0;
    std::vector<double> weights;
};

std::vector<Part> partsOf(int size, int sourceSize)
{
    const double scale = static_cast<double>(sourceSize) / size;
    std::vector<Part> parts;
    for (int index = 0; index < size; ++index) {
        const double from = index * scale, to = (index + 1) * scale;
        Part part{static_cast<int>(from), {}};
        for (int i = part.first; i < sourceSize && i < to - 1e-9; ++i)
            part.weights.push_back(std::min(to, i + 1.0) - std::max(from, static_cast<double>(i)));
        parts.push_back(std::move(part));
    }
    return parts;
}

constexpr std::size_t mostChannels = 4;

/// The mean of a part of the source, into `texel`: colours weighted by alpha where there is some.
void average(const Level& source, const Part& rows, const Part& columns, std::size_t alphaChannel, float* texel)
{
    const auto channels = static_cast<std::size_t>(source.channels);
    std::array<double, mostChannels> plain{}, weighted{};
    double total = 0.0, totalAlpha = 0.0;
    for (std::size_t j = 0; j < rows.weights.size(); ++j) {
        const float* from = &source.values[source.first(columns.first, rows.first + static_cast<int>(j))];
        for (std::size_t i = 0; i < columns.weights.size(); ++i, from += channels) {
            const double weight = rows.weights[j] * columns.weights[i];
            const double alpha = weight * static_cast<double>(from[alphaChannel]);
            total += weight;
            totalAlpha += alpha;
            for (std::size_t c = 0; c < channels; ++c) {
                plain[c] += weight * static_cast<double>(from[c]);
                weighted[c] += alpha * static_cast<double>(from[c]);
            }
        }
    }
    for (std::size_t c = 0; c < channels; ++c) {
        const bool isPlain = c == alphaChannel || totalAlpha <= 1e-9;
        texel[c] = static_cast<float>(isPlain ? plain[c] / total : weighted[c] / totalAlpha);
    }
}

/// Of a level's rows, a few at once.
template <typename Work> void forEachRow(const Level& level, const Work& work)
{
    tbb::parallel_for(tbb::blocked_range<int>(0, level.height, 16), [&](const tbb::blocked_range<int>& rows) {
        for (int y = rows.begin(); y != rows.end(); ++y) work(y);
    });
}

Level halved(const Level& source, int alphaChannel)
{
    Level level{std::max(source.width / 2, 1), std::max(source.height / 2, 1), source.channels, {}};
    level.values.resize(level.first(0, level.height));
    const std::vector<Part> rows = partsOf(level.height, source.height), columns = partsOf(level.width, source.width);
    forEachRow(level, [&](int y) {
        float* texel = &level.values[level.first(0, y)];
        for (const Part& column : columns) {
            average(source, rows[static_cast<std::size_t>(y)], column, static_cast<std::size_t>(alphaChannel), texel);
            texel += level.channels;
        }
    });
    return level;
}

Image encoded(const Level& level, const CutOut& cutOut, double alphaScale, const std::string& name)
{
    Image image{name, level.width, level.height, level.channels, std::vector<std::uint8_t>(level.values.size()), {}};
    forEachRow(level, [&](int y) {
        for (std::size_t i = level.first(0, y); i < level.first(0, y + 1); ++i) {
            const bool isAlpha = static_cast<int>(i % static_cast<std::size_t>(level.channels)) == cutOut.channel;
            const double value = static_cast<double>(level.values[i]);
            image.bytes[i] = toByte(isAlpha         ? alphaScale * value
                                    : cutOut.isSrgb ? optics64::srgbFromLinear(value)
                                                    : value);
        }
    });
    return image;
}

/// The factor on a level's alpha that brings its coverage next to what is wanted: the alpha of the texel that is the
/// last to be there is put on the cutoff.
double scaleFor(const Level& level, const CutOut& cutOut, double coverage)
{
    std::vector<float> alphas;
    for (std::size_t i = static_cast<std::size_t>(cutOut.channel); i < level.values.size();
         i += static_cast<std::size_t>(level.channels))
        alphas.push_back(level.values[i]);
    const auto wanted = static_cast<std::size_t>(std::lround(coverage * static_cast<double>(alphas.size())));
    if (wanted == 0) return 1.0; // too little to keep a texel for
    std::nth_element(alphas.begin(), alphas.begin() + static_cast<std::ptrdiff_t>(wanted - 1), alphas.end(),
                     std::greater<>());
    const double last = static_cast<double>(alphas[wanted - 1]);
    // Half a byte of room, so that rounding does not cut the texel away.
    return last > 1e-6 ? (static_cast<double>(cutOut.cutoff) + 0.5 / 255.0) / last : 1.0;
}

/// Raise it whenever the same picture gives other levels.
constexpr int methodVersion = 1;

std::string cacheKey(const Image& image, const CutOut& cutOut, CutOutLevels kind)
{
    const std::string_view content(reinterpret_cast<const char*>(image.bytes.data()), image.bytes.size());
    return fmt::format("mip levels of a cut-out {}: {}x{}x{} {:016x} channel {} cutoff {:a} srgb {} kind {}",
                       methodVersion, image.width, image.height, image.channels, hashOf(content), cutOut.channel,
                       cutOut.cutoff, cutOut.isSrgb, static_cast<int>(kind));
}

std::string joined(const std::vector<Image>& levels)
{
    std::string bytes;
    for (const Image& level : levels)
        bytes.append(reinterpret_cast<const char*>(level.bytes.data()), level.bytes.size());
    return bytes;
}

/// Nothing when the bytes are not as many as the levels have.
std::optional<std::vector<Image>> separated(const std::string& bytes, const Image& image)
{
    std::vector<Image> levels;
    std::size_t from = 0;
    for (ivec2 size(image.width, image.height); size != ivec2(1);) {
        size = glm::max(size / 2, ivec2(1));
        Image level{image.name, size.x, size.y, image.channels, {}, {}};
        if (from + level.size() > bytes.size()) return std::nullopt;
        const auto* first = reinterpret_cast<const std::uint8_t*>(bytes.data()) + from;
        level.bytes.assign(first, first + level.size());
        from += level.size();
        levels.push_back(std::move(level));
    }
    if (from != bytes.size()) return std::nullopt;
    return levels;
}

} // namespace

double coverageOf(const Image& image, const CutOut& cutOut)
{
    std::size_t there = 0, count = 0;
    for (std::size_t i = static_cast<std::size_t>(cutOut.channel); i < image.bytes.size();
         i += static_cast<std::size_t>(image.channels), ++count)
        if (static_cast<float>(image.bytes[i]) / 255.0f >= cutOut.cutoff) ++there;
    return count > 0 ? static_cast<double>(there) / static_cast<double>(count) : 0.0;
}

std::vector<Image> cutOutMips(const Image& image, const CutOut& cutOut, CutOutLevels kind)
{
    const bool hasChannel = cutOut.channel >= 0 && cutOut.channel < image.channels;
    if (image.isFloat() || !hasChannel || image.channels > static_cast<int>(mostChannels))
        throw Error("{}: no 8-bit alpha to cut out by", image.name);
    const double coverage = coverageOf(image, cutOut);
    std::vector<Image> levels;
    Level level = decoded(image, cutOut, kind);
    while (level.width > 1 || level.height > 1) {
        level = halved(level, cutOut.channel);
        const double scale = kind == CutOutLevels::covering ? scaleFor(level, cutOut, coverage) : 1.0;
        levels.push_back(encoded(level, cutOut, scale, image.name));
    }
    return levels;
}

std::vector<Image> cutOutMips(const Image& image, const CutOut& cutOut, CutOutLevels kind, const DiskCache& cache)
{
    const std::string key = cacheKey(image, cutOut, kind);
    if (const std::optional<std::string> bytes = cache.read(key))
        if (auto levels = separated(*bytes, image)) return *std::move(levels);
    std::vector<Image> levels = cutOutMips(image, cutOut, kind);
    cache.write(key, joined(levels));
    return levels;
}

} // namespace tarn
