#include "measure/flip.h"

#include "base/error.h"
#include "measure/colour.h"
#include "measure/picture_error.h"
#include "measure/plane.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace tarn {

namespace {

constexpr double piSquared = std::numbers::pi * std::numbers::pi;

/// One contrast sensitivity function as a sum of two Gaussians over the angle x in degrees,
/// Σ a √(π/b) exp(-π² x²/b); Andersson et al. 2020, section 4.1.
struct Sensitivity {
    double a1, b1, a2, b2;
};
constexpr Sensitivity achromatic{1.0, 0.0047, 0.0, 1e-5};
constexpr Sensitivity redGreen{1.0, 0.0053, 0.0, 1e-5};
constexpr Sensitivity blueYellow{34.1, 0.04, 13.5, 0.025};
constexpr double widestB = 0.04; // of all three, whose filters are cut at the same radius

// Section 4.1: exponent that compresses colour distances; the share pc of the largest becomes an error of pt.
constexpr float qc = 0.7f, pc = 0.4f, pt = 0.95f;

// Section 4.2: the feature detector's width in degrees, and the exponent that compresses its differences.
constexpr double featureWidth = 0.082;
constexpr float qf = 0.5f;

/// A Gaussian is cut where it no longer counts.
int cutRadius(double deviation) { return static_cast<int>(std::ceil(3.0 * deviation)); }

/// f(-radius) … f(radius), with the positive weights scaled to sum to 1 and the negative ones to -1.
template <typename Function> Kernel normalised(int radius, const Function& f)
{
    std::vector<double> weights;
    double positive = 0.0, negative = 0.0;
    for (int x = -radius; x <= radius; ++x) {
        weights.push_back(f(static_cast<double>(x)));
        (weights.back() > 0.0 ? positive : negative) += std::abs(weights.back());
    }
    Kernel kernel;
    for (const double weight : weights)
        kernel.push_back(static_cast<float>(weight == 0.0 ? 0.0 : weight / (weight > 0.0 ? positive : negative)));
    return kernel;
}

struct WeightedKernel {
    float weight;
    Kernel kernel; ///< for rows and for columns
};

/// A two-dimensional filter of sum 1. Each Gaussian of the function separates into rows and columns, their
/// sum does not.
using SensitivityFilter = std::vector<WeightedKernel>;

SensitivityFilter sensitivityFilter(const Sensitivity& function, double pixelsPerDegree)
{
    const int radius = cutRadius(std::sqrt(widestB / (2.0 * piSquared)) * pixelsPerDegree);
    SensitivityFilter filter;
    std::vector<double> sums;
    for (const auto& [a, b] : {std::pair(function.a1, function.b1), std::pair(function.a2, function.b2)}) {
        if (a == 0.0) continue;
        const auto gaussian = [&, b = b](double x) {
            return std::exp(-piSquared * x * x / (b * pixelsPerDegree * pixelsPerDegree));
        };
        double sum = 0.0;
        for (int x = -radius; x <= radius; ++x) sum += gaussian(static_cast<double>(x));
        sums.push_back(a * std::sqrt(std::numbers::pi / b) * sum * sum);
        filter.push_back({0.0f, normalised(radius, gaussian)});
    }
    const double total = std::accumulate(sums.begin(), sums.end(), 0.0);
    for (std::size_t i = 0; i < filter.size(); ++i) filter[i].weight = static_cast<float>(sums[i] / total);
    return filter;
}

/// All that depends on the viewer alone.
struct Eye {
    std::array<SensitivityFilter, 3> sensitivity; ///< of the opponent channels
    Kernel smooth, first, second;                 ///< a Gaussian and its derivatives, for the features
    int halo;                                     ///< pixels around a pixel that its error depends on
};

Eye makeEye(double pixelsPerDegree)
{
    const double deviation = 0.5 * featureWidth * pixelsPerDegree;
    const int radius = cutRadius(deviation);
    const auto gaussian = [&](double x) { return std::exp(-x * x / (2.0 * deviation * deviation)); };
    Eye eye{{sensitivityFilter(achromatic, pixelsPerDegree), sensitivityFilter(redGreen, pixelsPerDegree),
             sensitivityFilter(blueYellow, pixelsPerDegree)},
            normalised(radius, gaussian),
            normalised(radius, [&](double x) { return -x * gaussian(x); }),
            normalised(radius, [&](double x) { return (x * x / (deviation * deviation) - 1.0) * gaussian(x); }),
            radius};
    for (const SensitivityFilter& filter : eye.sensitivity)
        for (const WeightedKernel& part : filter) eye.halo = std::max(eye.halo, radiusOf(part.kernel));
    return eye;
}

Plane filtered(const Plane& plane, const SensitivityFilter& filter, int halo)
{
    Plane result(plane.width, plane.height - 2 * halo);
    for (const WeightedKernel& part : filter) {
        const Plane one = filterColumns(filterRows(plane, part.kernel), part.kernel, halo);
        for (std::size_t i = 0; i < result.values.size(); ++i) result.values[i] += part.weight * one.values[i];
    }
    return result;
}

/// The paper's YyCxCz without its scales and offset, (Y, X - Y, Y - Z) relative to white: filters of sum 1
/// and the way back to RGB do not depend on them, and Y is what the feature detector wants, 0 to 1.
using Opponent = std::array<Plane, 3>;

/// Rows first … end of a picture; above and below it stands its border's row.
Opponent opponentRows(const Image& image, int first, int end)
{
    static const std::array<float, 256> linear = [] {
        std::array<float, 256> table{};
        for (std::size_t i = 0; i < table.size(); ++i) table[i] = srgbDecode(static_cast<float>(i) / 255.0f);
        return table;
    }();
    Opponent planes;
    planes.fill(Plane(image.width, end - first));
    const auto channels = static_cast<std::size_t>(image.channels), width = static_cast<std::size_t>(image.width);
    const mat3 relativeOfRgb = relativeFromRgb();
    for (int y = first; y < end; ++y) {
        const auto from = static_cast<std::size_t>(std::clamp(y, 0, image.height - 1));
        const std::uint8_t* p = image.bytes.data() + from * width * channels;
        for (std::size_t x = 0; x < width; ++x, p += channels) {
            const vec3 relative = relativeOfRgb * vec3(linear[p[0]], linear[p[1]], linear[p[2]]);
            planes[0].row(y - first)[x] = relative.y;
            planes[1].row(y - first)[x] = relative.x - relative.y;
            planes[2].row(y - first)[x] = relative.y - relative.z;
        }
    }
    return planes;
}

/// CIELAB with its chroma scaled by lightness, since dark colours look less colourful (Hunt 1952).
vec3 huntAdjusted(const vec3& relative)
{
    const vec3 lab = labFromRelative(relative);
    return {lab.x, 0.01f * lab.x * lab.y, 0.01f * lab.x * lab.z};
}

/// Abasi, Amani Tehran and Fairchild 2020: lightness and chroma apart, which holds for large differences too.
float hyab(const vec3& a, const vec3& b) { return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z); }

/// Section 4.1: a distance of Hunt-adjusted colours as 0 to 1. The largest is that of green and blue.
float colourError(float distance)
{
    static const float largest = std::pow(hyab(huntAdjusted(relativeFromRgb() * vec3(0.0f, 1.0f, 0.0f)),
                                               huntAdjusted(relativeFromRgb() * vec3(0.0f, 0.0f, 1.0f))),
                                          qc);
    const float compressed = std::pow(distance, qc), knee = pc * largest;
    if (compressed < knee) return pt / knee * compressed;
    return std::min(1.0f, pt + (1.0f - pt) * (compressed - knee) / (largest - knee));
}

/// What the eye makes of a pixel's colour after its neighbours have blurred into it.
vec3 seenColour(const Opponent& blurred, std::size_t i)
{
    const float y = blurred[0].values[i];
    const vec3 relative(y + blurred[1].values[i], y, y - blurred[2].values[i]);
    // No display shows what the filters leave outside its gamut.
    const vec3 rgb = glm::clamp(rgbFromRelative() * relative, vec3(0.0f), vec3(1.0f));
    return huntAdjusted(relativeFromRgb() * rgb);
}

/// Magnitudes of the first (edges) and second (points and lines) derivative of Y, section 4.2.
struct Features {
    Plane edges, points;
};

Plane magnitude(const Plane& x, const Plane& y)
{
    Plane result(x.width, x.height);
    for (std::size_t i = 0; i < result.values.size(); ++i)
        result.values[i] = std::sqrt(x.values[i] * x.values[i] + y.values[i] * y.values[i]);
    return result;
}

Features featuresOf(const Plane& luminance, const Eye& eye)
{
    const Plane rows = filterRows(luminance, eye.smooth);
    const auto derivative = [&](const Kernel& kernel) {
        return magnitude(filterColumns(filterRows(luminance, kernel), eye.smooth, eye.halo),
                         filterColumns(rows, kernel, eye.halo));
    };
    return {derivative(eye.first), derivative(eye.second)};
}

/// Section 4.2. Each magnitude is at most √2, of a response of 1 in both directions.
float featureError(const Features& a, const Features& b, std::size_t i)
{
    const float edges = std::abs(a.edges.values[i] - b.edges.values[i]);
    const float points = std::abs(a.points.values[i] - b.points.values[i]);
    return std::pow(std::min(1.0f, std::max(edges, points) / std::numbers::sqrt2_v<float>), qf);
}

/// A strip of a picture as FLIP looks at it.
struct Seen {
    Opponent blurred;
    Features features;
};

Seen see(const Image& image, int first, int end, const Eye& eye)
{
    const Opponent planes = opponentRows(image, first - eye.halo, end + eye.halo);
    Seen seen;
    for (std::size_t i = 0; i < planes.size(); ++i) seen.blurred[i] = filtered(planes[i], eye.sensitivity[i], eye.halo);
    seen.features = featuresOf(planes[0], eye);
    return seen;
}

/// Rows first … end of the map.
void judge(const Image& reference, const Image& test, const Eye& eye, int first, int end, float* map)
{
    const Seen a = see(reference, first, end, eye), b = see(test, first, end, eye);
    const std::size_t count = a.blurred[0].values.size();
    for (std::size_t i = 0; i < count; ++i) {
        const float colour = colourError(hyab(seenColour(a.blurred, i), seenColour(b.blurred, i)));
        map[i] = std::pow(colour, 1.0f - featureError(a.features, b.features, i)); // section 4.3
    }
}

/// Strip by strip rather than filter by filter: what a strip needs stays in a core's cache.
void judgeInStrips(const Image& reference, const Image& test, const Eye& eye, Image& map)
{
    const int rows = std::max(32, 2 * eye.halo); // so that the halo is at most as much work as the strip
    const int strips = (map.height + rows - 1) / rows;
    tbb::parallel_for(0, strips, [&](int strip) {
        const int first = strip * rows;
        float* values = map.floats.data() + static_cast<std::size_t>(first) * static_cast<std::size_t>(map.width);
        judge(reference, test, eye, first, std::min(first + rows, map.height), values);
    });
}

void requireMap(const Image& map)
{
    if (map.channels != 1 || !map.isFloat() || map.floats.size() != map.size())
        throw Error("{}: a picture of one float channel is wanted", map.name);
}

} // namespace

Image flipMap(const Image& reference, const Image& test, double pixelsPerDegree)
{
    requireComparable(reference, test);
    for (const Image* image : {&reference, &test})
        if (image->bytes.empty() || image->bytes.size() != image->size())
            throw Error("{}: FLIP compares 8-bit sRGB pictures", image->name);
    if (!(pixelsPerDegree >= leastPixelsPerDegree && pixelsPerDegree <= mostPixelsPerDegree))
        throw Error("FLIP: {} pixels per degree; from {} to {} are possible", pixelsPerDegree, leastPixelsPerDegree,
                    mostPixelsPerDegree);
    Image map{"FLIP of " + test.name, reference.width, reference.height, 1, {}, {}};
    map.floats.resize(map.size());
    judgeInStrips(reference, test, makeEye(pixelsPerDegree), map);
    return map;
}

double meanFlip(const Image& reference, const Image& test, double pixelsPerDegree)
{
    return meanOf(flipMap(reference, test, pixelsPerDegree));
}

double meanOf(const Image& map)
{
    requireMap(map);
    double sum = 0.0;
    for (const float value : map.floats) sum += static_cast<double>(value);
    return sum / static_cast<double>(map.floats.size());
}

double meanOver(const Image& map, std::span<const std::uint8_t> mask)
{
    requireMap(map);
    if (mask.size() != map.floats.size())
        throw Error("{}: its mask has {} pixels, not {}", map.name, mask.size(), map.floats.size());
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        if (mask[i] == 0) continue;
        sum += static_cast<double>(map.floats[i]);
        ++count;
    }
    return count > 0 ? sum / static_cast<double>(count) : std::numeric_limits<double>::quiet_NaN();
}

} // namespace tarn
