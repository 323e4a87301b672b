#include "reference/water_surface.h"

#include "reference/texture_lookup.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tarn::reference {

namespace {

constexpr int maxWaves = blocks::maxWaves;

/// sin for the march: 4e-6 exact, and a form that compilers turn into vector code.
float fastSin(float x)
{
    constexpr float twoPi = 6.28318530718f;
    constexpr float rounding = 12582912.0f; // 1.5 · 2^23: adding it leaves no bits for a fraction
    const float turns = (x * (1.0f / twoPi) + rounding) - rounding;
    const float r = x - turns * twoPi;
    const float a = std::abs(r);
    const float m = std::min(a, pi - a);
    const float m2 = m * m;
    const float s =
        m * (1.0f + m2 * (-1.6666667e-1f + m2 * (8.3333310e-3f + m2 * (-1.9840874e-4f + m2 * 2.7525562e-6f))));
    return std::copysign(s, r);
}

/// The waves along a ray: each is a sine of the distance. In single precision, relative to a start in double.
struct WavesAlongRay {
    int count = 0;
    std::array<float, maxWaves> amplitude, phase, frequency;
    float steepest = 0.0f; ///< |dh/dt| is never more

    WavesAlongRay(const std::vector<optics64::WaveTerm>& waves, double time, const dvec3& start, const dvec3& direction)
        : count((static_cast<int>(waves.size()) + 3) / 4 * 4)
    {
        constexpr double twoPi = 2.0 * std::numbers::pi;
        amplitude.fill(0.0f);
        phase.fill(0.0f);
        frequency.fill(0.0f);
        for (std::size_t i = 0; i < waves.size(); ++i) {
            const optics64::WaveTerm& w = waves[i];
            amplitude[i] = static_cast<float>(w.amplitude);
            phase[i] =
                static_cast<float>(std::remainder(w.k.x * start.x + w.k.y * start.z - w.omega * time + w.phase, twoPi));
            frequency[i] = static_cast<float>(w.k.x * direction.x + w.k.y * direction.z);
            steepest += std::abs(amplitude[i] * frequency[i]);
        }
    }

    /// d height / dt
    float slope(float t) const
    {
        float sum = 0.0f;
        for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k)
            sum += amplitude[k] * frequency[k] * fastSin(phase[k] + frequency[k] * t + 0.5f * pi);
        return sum;
    }

    float height(float t) const
    {
        float sum[4] = {0.0f, 0.0f, 0.0f, 0.0f};
        for (int i = 0; i < count; i += 4)
            for (int j = 0; j < 4; ++j) {
                const auto k = static_cast<std::size_t>(i + j);
                sum[j] += amplitude[k] * fastSin(phase[k] + frequency[k] * t);
            }
        return (sum[0] + sum[1]) + (sum[2] + sum[3]);
    }
};

/// Bisection guards Newton's method. gap > 0 at `inside` and <= 0 at `outside`.
template <typename Gap, typename Rate> float rootBetween(float inside, float outside, const Gap& gap, const Rate& rate)
{
    float t = 0.5f * (inside + outside);
    for (int i = 0; i < 30 && outside - inside > 1e-6f * std::max(outside, 1.0f); ++i) {
        const float g = gap(t);
        if (std::abs(g) < 1e-7f) return t;
        (g > 0.0f ? inside : outside) = t;
        const float r = rate(t);
        const float newton = r != 0.0f ? t - g / r : inside;
        t = newton > inside && newton < outside ? newton : 0.5f * (inside + outside);
    }
    return t;
}

/// The part of [lower, upper] in which start + t · rate stays between two values.
void clipRange(double start, double rate, double least, double most, double& lower, double& upper)
{
    if (std::abs(rate) < 1e-12) {
        if (start < least || start > most) upper = -1.0;
        return;
    }
    const double a = (least - start) / rate, b = (most - start) / rate;
    lower = std::max(lower, std::min(a, b));
    upper = std::min(upper, std::max(a, b));
}

} // namespace

WaterSurface::WaterSurface(const WaterBody& water, double time, const Grid& grid, const Grid& normalGrid,
                           const Image* normalMap)
    : time_(time), level_(water.level), lower_(dvec2(water.centre) - 0.5 * dvec2(water.extent)),
      upper_(dvec2(water.centre) + 0.5 * dvec2(water.extent)), grid_(grid), normalGrid_(normalGrid),
      normalMap_(water.normalMap.enabled ? normalMap : nullptr), tile_(static_cast<double>(water.normalMap.tile)),
      bump_(static_cast<double>(water.normalMap.bump)), offsets_(layerOffsets(water.normalMap, time))
{
    const std::size_t count = std::min<std::size_t>(water.waves.size(), maxWaves);
    for (std::size_t i = 0; i < count; ++i) {
        const Wave& w = water.waves[i];
        waves_.push_back(optics64::makeWaveTerm(w.amplitude, w.wavelength, w.direction, w.phase, w.period));
    }
    amplitude_ = optics64::totalAmplitude(waves_);
    if (!grid_) return;
    for (std::size_t axis = 0; axis < 2; ++axis)
        for (int i = 0; i < static_cast<int>((*grid_)[axis].vertices); ++i)
            lines_[axis].push_back(optics64::gridPosition((*grid_)[axis], i));
}

bool WaterSurface::spans(double x, double z) const
{
    return x >= lower_.x && x <= upper_.x && z >= lower_.y && z <= upper_.y;
}

double WaterSurface::height(double x, double z) const
{
    if (grid_)
        return level_ + optics64::gridHeight(waves_.data(), static_cast<int>(waves_.size()), {x, z}, time_, (*grid_)[0],
                                             (*grid_)[1]);
    return level_ + optics64::waveHeight(waves_, {x, z}, time_);
}

bool WaterSurface::contains(const dvec3& point) const
{
    return spans(point.x, point.z) && point.y < height(point.x, point.z);
}

dvec3 WaterSurface::normal(double x, double z) const
{
    const dvec3 n = drawnNormal(x, z);
    if (!normalMap_) return n;
    return optics64::waveNormal(-dvec2(n.x, n.z) / n.y + rippleSlope(x, z));
}

dvec2 WaterSurface::rippleSlope(double x, double z) const
{
    dvec3 sum(0.0);
    for (const dvec2& offset : offsets_) {
        const dvec2 uv = glm::fract(dvec2(x, z) / tile_ + offset); // small, for the single precision of the lookup
        const vec3 colour(sampleTexture(*normalMap_, vec2(uv), Encoding::linear));
        sum += optics64::normalMapNormal(dvec3(colour));
    }
    return optics64::normalMapSlope(sum, bump_);
}

dvec3 WaterSurface::keptOn(const dvec3& direction, const dvec3& U, bool above) const
{
    if (!normalMap_) return direction;
    const dvec3 n = waveNormal(U.x, U.z);
    const double away = glm::dot(direction, n);
    return (above ? away : -away) < 0.0 ? optics64::reflectRay(direction, n) : direction;
}

dvec3 WaterSurface::drawnNormal(double x, double z) const
{
    if (!normalGrid_) return waveNormal(x, z);
    // The triangle of the grid: see gridHeight in shaders/shared/water_grid.glsl.
    const auto& [axisX, axisZ] = *normalGrid_;
    const auto positionOf = [&](const dvec2& line) {
        return dvec2(optics64::gridPosition(axisX, line.x), optics64::gridPosition(axisZ, line.y));
    };
    const dvec2 line(optics64::gridLine(axisX, x), optics64::gridLine(axisZ, z));
    const dvec2 corner = glm::min(glm::floor(line), dvec2(axisX.vertices, axisZ.vertices) - 2.0);
    const dvec2 first = positionOf(corner), last = positionOf(corner + 1.0);
    const dvec2 f = glm::clamp((dvec2(x, z) - first) / glm::max(last - first, dvec2(1e-9)), dvec2(0.0), dvec2(1.0));
    const bool isFirst = f.x + f.y <= 1.0;
    const dvec2 own = isFirst ? corner : corner + 1.0;
    const double way = isFirst ? 1.0 : -1.0;
    const dvec2 weight = isFirst ? f : 1.0 - f;
    const auto vertex = [&](const dvec2& at) {
        const dvec2 p = positionOf(at), cell(optics64::gridCell(axisX, at.x), optics64::gridCell(axisZ, at.y));
        return optics64::gridSum(waves_.data(), static_cast<int>(waves_.size()), p, cell, time_).slope;
    };
    return optics64::waveNormal((1.0 - weight.x - weight.y) * vertex(own) + weight.x * vertex(own + dvec2(way, 0.0)) +
                                weight.y * vertex(own + dvec2(0.0, way)));
}

dvec3 WaterSurface::waveNormal(double x, double z) const { return optics64::waveNormalAt(waves_, {x, z}, time_); }

double WaterSurface::heightAbove(const dvec3& point) const { return point.y - height(point.x, point.z); }

std::optional<double> WaterSurface::intersect(const Ray& ray, double tMin, double tMax, bool fromAbove) const
{
    const dvec3& d = ray.direction;
    double lower = tMin, upper = tMax;
    clipRange(ray.origin.x, d.x, lower_.x, upper_.x, lower, upper);
    clipRange(ray.origin.z, d.z, lower_.y, upper_.y, lower, upper);
    const double room = amplitude_ + 1e-4; // never flat, so that level water is met inside the range
    clipRange(ray.origin.y, d.y, level_ - room, level_ + room, lower, upper);
    if (!(lower < upper)) return std::nullopt;
    const double side = fromAbove ? 1.0 : -1.0;
    if (grid_) return intersectGrid(ray, lower, upper, side);

    const dvec3 start = ray.origin + lower * d;
    const WavesAlongRay waves(waves_, time_, start, d);
    const auto slope = static_cast<float>(d.y);
    const auto offset = static_cast<float>(start.y - level_);
    const float bound = std::abs(slope) + waves.steepest;
    const auto reach = static_cast<float>(upper - lower);
    const auto sign = static_cast<float>(side);
    // Where the surface bends away within a millimetre it does so by less than a micrometre.
    constexpr float leastStep = 1.0e-3f;
    // A ray that begins beyond the surface (beside the water's rectangle, or by rounding) has first to come out.
    bool isInside = false;
    for (float t = 0.0f, last = 0.0f; last < reach; t = std::min(t, reach)) {
        const float gap = sign * (offset + slope * t - waves.height(t));
        if (gap <= 0.0f && isInside) {
            const auto gapAt = [&](float x) { return sign * (offset + slope * x - waves.height(x)); };
            const auto rateAt = [&](float x) { return sign * (slope - waves.slope(x)); };
            return polish(ray, lower + static_cast<double>(rootBetween(last, t, gapAt, rateAt)), side);
        }
        isInside = gap > 0.0f;
        last = t;
        t += std::max(gap / bound, leastStep);
    }
    return std::nullopt;
}

/// One step of Newton's method in double precision: single precision leaves a few micrometres.
double WaterSurface::polish(const Ray& ray, double t, double side) const
{
    const dvec3 p = ray.origin + t * ray.direction;
    const optics64::WaveSum surface = optics64::waveAt(waves_, {p.x, p.z}, time_);
    const double gap = p.y - level_ - surface.height;
    const double rate = ray.direction.y - glm::dot(surface.slope, dvec2(ray.direction.x, ray.direction.z));
    // Where the ray grazes the surface the step has no bound, and there is nothing to gain.
    if (side * rate > -1e-3) return t;
    const double step = -gap / rate;
    return std::abs(step) < 1e-3 ? t + step : t;
}

/// Along a ray the grid's height is a line between the edges of its triangles: walk from edge to edge.
std::optional<double> WaterSurface::intersectGrid(const Ray& ray, double tMin, double tMax, double side) const
{
    // Of a cell with the ray's point in it: its two lines on either axis, and the diagonal between its triangles.
    const auto cellAt = [&](std::size_t axis, double position) {
        const std::vector<double>& lines = lines_[axis];
        const auto after = std::upper_bound(lines.begin() + 1, lines.end() - 1, position);
        return dvec2(*(after - 1), *after);
    };
    constexpr double past = 1e-9; // m, beyond an edge that was reached
    const auto nextEdge = [&](double t) {
        const dvec3 p = ray.origin + (t + past) * ray.direction;
        const dvec2 x = cellAt(0, p.x), z = cellAt(1, p.z);
        double next = tMax;
        const auto meets = [&](double distance, double rate) {
            if (std::abs(rate) < 1e-12) return;
            const double when = t + past + distance / rate;
            if (when > t + past) next = std::min(next, when);
        };
        for (int end = 0; end < 2; ++end) {
            meets(x[end] - p.x, ray.direction.x);
            meets(z[end] - p.z, ray.direction.z);
        }
        const dvec2 size = glm::max(dvec2(x[1] - x[0], z[1] - z[0]), dvec2(1e-9));
        meets(1.0 - (p.x - x[0]) / size.x - (p.z - z[0]) / size.y, ray.direction.x / size.x + ray.direction.z / size.y);
        return std::max(next, t + past);
    };
    double t = tMin;
    double gap = side * heightAbove(ray.origin + t * ray.direction);
    while (t < tMax) {
        const double next = nextEdge(t);
        const double nextGap = side * heightAbove(ray.origin + next * ray.direction);
        if (nextGap <= 0.0 && gap > 0.0) return t + (next - t) * gap / (gap - nextGap);
        t = next;
        gap = nextGap;
    }
    return std::nullopt;
}

} // namespace tarn::reference
