#include "reference/sun_map.h"

#include "base/progress.h"
#include "reference/random.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace tarn::reference {

namespace {

constexpr double sunAngularRadius = 0.2665 * std::numbers::pi / 180.0; // as SkyModel's disc

/// Height of a layer. A lookup takes its own layer and both neighbours, so that a bed that slopes through a texel is
/// whole; what lies further above or below is something else.
constexpr double layerHeight = 0.15;

constexpr double finestTexel = 0.005, coarsestTexel = 0.08;
constexpr int mapLevels = 5; // each of twice the texel

/// Photons that a texel of even light must have at least: with fewer, the lattice of the photons would show.
constexpr double photonsPerTexel = 24.0;
constexpr double mostTexels = 6.0e6; ///< of a map

int levelOf(double footprint)
{
    const double steps = std::log2(std::clamp(footprint, finestTexel, coarsestTexel) / finestTexel);
    return std::clamp(static_cast<int>(std::floor(steps + 0.5)), 0, mapLevels - 1);
}

dvec2 planeOf(const dvec3& p, double level, const dvec2& shear) { return dvec2(p.x, p.z) - shear * (p.y - level); }

} // namespace

/// Where a photon came down.
struct SunMap::Landing {
    std::uint64_t key; ///< texel, layer and the photon's number: the order in which fluxes are added
    float light;       ///< transmittance of the surface
    float path;        ///< m of water
};

SunMap::SunMap(const Inputs& inputs, const std::vector<LightQuery>& queries, Progress* progress)
    : slant_(dvec2(inputs.light.sunDirectionBelow.x, inputs.light.sunDirectionBelow.z) /
             static_cast<double>(inputs.light.sunDirectionBelow.y)),
      level_(inputs.water.level())
{
    struct Extent {
        dvec2 lower{1e30}, upper{-1e30};
    };
    std::vector<Extent> extents(mapLevels);
    for (const LightQuery& query : queries) {
        const dvec2 at = planeOf(query.position, level_, slant_);
        Extent& extent = extents[static_cast<std::size_t>(levelOf(query.footprint))];
        extent.lower = glm::min(extent.lower, at);
        extent.upper = glm::max(extent.upper, at);
    }
    // First the rectangles, so that photons can be shared out; then texels as coarse as the photons ask for.
    std::vector<double> fractions;
    std::vector<dvec2> edges;
    double sum = 0.0;
    for (int level = 0; level < mapLevels; ++level) {
        const Extent& extent = extents[static_cast<std::size_t>(level)];
        if (extent.lower.x > extent.upper.x) continue;
        Map map;
        map.texel = finestTexel * std::exp2(level);
        // Room for what lies between the queries.
        const dvec2 room(8.0 * map.texel + 0.05 * (extent.upper - extent.lower));
        map.lower = glm::max(extent.lower - room, inputs.water.lower() - 2.0);
        const dvec2 edge = glm::min(extent.upper + room, inputs.water.upper() + 2.0) - map.lower;
        if (!(edge.x > 0.0 && edge.y > 0.0)) continue;
        edges.push_back(edge);
        fractions.push_back(std::max(edge.x * edge.y / (map.texel * map.texel), 2.5e5));
        sum += fractions.back();
        maps_.push_back(std::move(map));
    }
    double done = 0.0;
    for (std::size_t i = 0; i < maps_.size(); ++i) {
        const auto photons = static_cast<std::size_t>(inputs.photons * fractions[i] / sum);
        Map& map = maps_[i];
        const double area = edges[i].x * edges[i].y;
        map.texel = std::max(
            {map.texel, std::sqrt(area * photonsPerTexel / static_cast<double>(std::max<std::size_t>(photons, 1))),
             std::sqrt(area / mostTexels)});
        map.size = ivec2(glm::ceil(edges[i] / map.texel)) + 1;
        trace(inputs, map, photons, [&](double part) {
            if (progress) progress->report((done + part * fractions[i]) / sum, "tracing photons");
        });
        done += fractions[i];
    }
}

SunMap::SunMap(const Inputs& inputs, const vec4& rect, double texel, Progress* progress, int filter)
    : slant_(dvec2(inputs.light.sunDirectionBelow.x, inputs.light.sunDirectionBelow.z) /
             static_cast<double>(inputs.light.sunDirectionBelow.y)),
      level_(inputs.water.level()), filter_(filter)
{
    Map map;
    map.texel = texel;
    map.lower = {rect.x - rect.z, rect.y - rect.w};
    map.size = ivec2(glm::ceil(2.0 * dvec2(rect.z, rect.w) / texel)) + 1;
    maps_.push_back(std::move(map));
    trace(inputs, maps_.front(), static_cast<std::size_t>(inputs.photons), [&](double part) {
        if (progress) progress->report(part, "tracing photons");
    });
}

namespace {

/// A photon's way from the sun through the surface to what it meets.
struct PhotonTracer {
    const SunMap::Inputs& inputs;
    dvec3 sun;
    Across across;

    explicit PhotonTracer(const SunMap::Inputs& in)
        : inputs(in), sun(glm::normalize(dvec3(in.light.sunDirection))), across(sun)
    {}

    enum class End { shaded, landed, lost };
    struct Result {
        End end;
        dvec3 position{0.0};
        float light = 0.0f, path = 0.0f;
    };

    /// @param plane where the photon would cross the level   @param disc a point of the unit disc: where on the sun
    Result follow(const dvec2& plane, const dvec2& disc) const
    {
        const WaterSurface& water = inputs.water;
        const dvec3 toSun = glm::normalize(sun + std::tan(sunAngularRadius) * (disc.x * across.a + disc.y * across.b));
        const double up = (water.amplitude() + 0.01) / toSun.y;
        const Ray down{dvec3(plane.x, water.level(), plane.y) + up * toSun, -toSun};
        const auto distance = water.intersect(down, 0.0, 3.0 * up, true);
        if (!distance) return {End::shaded};
        const dvec3 U = down.origin + *distance * down.direction;
        const dvec3 n = water.normal(U.x, U.z);
        const double cosine = glm::dot(n, toSun);
        if (cosine <= 0.0) return {End::shaded};
        if (inputs.geometry.occluded({U, toSun}, 1e-4, 1e5)) return {End::shaded};
        const double ior = inputs.light.ior;
        const Ray below{U, optics64::refractRay(-toSun, n, 1.0 / ior)};
        const auto hit = inputs.geometry.intersect(below, 1e-4, 1e4, Sides::both);
        if (!hit) return {End::lost};
        const double transmitted = 1.0 - optics64::fresnelExact(cosine, 1.0 / ior);
        return {End::landed, U + hit->distance * below.direction, static_cast<float>(transmitted),
                static_cast<float>(hit->distance)};
    }
};

} // namespace

void SunMap::trace(const Inputs& inputs, Map& map, std::size_t photons, const std::function<void(double)>& report)
{
    // Waves throw light sideways: photons start in a wider rectangle than where they are counted. tan of the angle by
    // which a slope of 0.4 turns the refracted ray, times a depth beyond which the pattern has washed out.
    const double reach =
        std::min(0.12 * std::max(level_ - static_cast<double>(inputs.geometry.bounds().lower.y), 0.0), 2.0);
    const dvec2 lower = map.lower - reach;
    const dvec2 edge = dvec2(map.size) * map.texel + 2.0 * reach;
    const double cellArea = edge.x * edge.y / static_cast<double>(std::max<std::size_t>(photons, 1));

    const PhotonTracer tracer(inputs);
    Random start(static_cast<std::uint64_t>(inputs.seed), 0x5a9u);
    const dvec2 offset = start.next2();
    // The halves that noise() compares are the even and the odd photons, each evenly spread by itself.
    constexpr std::size_t batch = 1u << 20;
    std::vector<Landing> landings;
    landings.reserve(photons);
    std::vector<Landing> some(batch);
    std::atomic<std::size_t> entered{0}, lost{0};
    constexpr std::uint64_t nowhere = ~std::uint64_t{0};
    for (std::size_t first = 0; first < photons; first += batch) {
        const std::size_t count = std::min(batch, photons - first);
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 4096), [&](const auto& range) {
            std::size_t enteredHere = 0, lostHere = 0;
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                const std::uint64_t number = first + i;
                Random random(static_cast<std::uint64_t>(inputs.seed) + 77u, number);
                const dvec2 disc = discFromSquare(random.next2());
                const auto photon = tracer.follow(lower + edge * evenlySpread(number, offset), disc);
                some[i].key = nowhere;
                if (photon.end == PhotonTracer::End::shaded) continue;
                ++enteredHere;
                if (photon.end == PhotonTracer::End::lost) ++lostHere;
                if (photon.end != PhotonTracer::End::landed) continue;
                const dvec2 at = (planeOf(photon.position, level_, slant_) - map.lower) / map.texel;
                if (at.x < 0.0 || at.y < 0.0 || at.x >= map.size.x || at.y >= map.size.y) continue;
                const auto texel =
                    static_cast<std::uint64_t>(static_cast<int>(at.y)) * static_cast<std::uint64_t>(map.size.x) +
                    static_cast<std::uint64_t>(static_cast<int>(at.x));
                // 2048 layers of 15 cm about the level; the number keeps the order of addition fixed.
                const auto layer = static_cast<std::uint64_t>(
                    std::clamp(std::floor((photon.position.y - level_) / layerHeight), -1500.0, 500.0) + 1500.0);
                some[i] = {texel << 40 | layer << 29 | (number & 0x1fffffffu), photon.light, photon.path};
            }
            entered += enteredHere;
            lost += lostHere;
        });
        for (std::size_t i = 0; i < count; ++i)
            if (some[i].key != nowhere) landings.push_back(some[i]);
        report(static_cast<double>(first + count) / static_cast<double>(photons));
    }
    photons_ += photons;
    entered_ += entered;
    lost_ += lost;
    tbb::parallel_sort(landings.begin(), landings.end(),
                       [](const Landing& a, const Landing& b) { return a.key < b.key; });
    fold(map, landings, inputs.light, cellArea);
}

void SunMap::fold(Map& map, std::vector<Landing>& landings, const Light& light, double cellArea) const
{
    const std::size_t texels = static_cast<std::size_t>(map.size.x) * static_cast<std::size_t>(map.size.y);
    const auto fraction = static_cast<float>(cellArea / (map.texel * map.texel));
    map.begin.assign(texels + 1, 0);
    std::size_t i = 0;
    for (std::size_t texel = 0; texel < texels; ++texel) {
        map.begin[texel] = static_cast<std::uint32_t>(map.entries.size());
        while (i < landings.size() && landings[i].key >> 40 == texel) {
            const auto layer = static_cast<std::int32_t>(landings[i].key >> 29 & 0x7ffu) - 1500;
            if (map.entries.size() == map.begin[texel] || map.entries.back().layer != layer)
                map.entries.push_back({layer, vec3(0.0f), vec3(0.0f)});
            const vec3 flux =
                2.0f * fraction * landings[i].light * optics::beerLambert(light.absorption, landings[i].path);
            ((landings[i].key & 1u) ? map.entries.back().first : map.entries.back().second) += flux;
            ++i;
        }
    }
    map.begin[texels] = static_cast<std::uint32_t>(map.entries.size());
}

/// @param half 0, 1, or 2 for the mean of both
vec3 SunMap::sumAt(const Map& map, ivec2 texel, int layer, int half)
{
    if (texel.x < 0 || texel.y < 0 || texel.x >= map.size.x || texel.y >= map.size.y) return vec3(0.0f);
    const std::size_t index =
        static_cast<std::size_t>(texel.y) * static_cast<std::size_t>(map.size.x) + static_cast<std::size_t>(texel.x);
    vec3 sum(0.0f);
    for (std::uint32_t e = map.begin[index]; e < map.begin[index + 1]; ++e) {
        const Entry& entry = map.entries[e];
        if (std::abs(entry.layer - layer) > 1) continue;
        sum += half == 0 ? entry.first : half == 1 ? entry.second : 0.5f * (entry.first + entry.second);
    }
    return sum;
}

std::optional<vec3> SunMap::relativeIrradiance(const dvec3& point, double footprint) const
{
    if (filter_ == 0 || maps_.empty()) return unfiltered(point, footprint);
    vec3 sum(0.0f);
    for (int j = -filter_; j <= filter_; ++j)
        for (int i = -filter_; i <= filter_; ++i) {
            const float weight = optics::causticsFilterWeight(filter_, i) * optics::causticsFilterWeight(filter_, j);
            const auto light = unfiltered(point + maps_.front().texel * dvec3(i, 0.0, j), footprint);
            if (!light) return std::nullopt;
            sum += weight * *light;
        }
    return sum;
}

std::optional<vec3> SunMap::unfiltered(const dvec3& point, double footprint) const
{
    const dvec2 plane = planeOf(point, level_, slant_);
    const int layer = static_cast<int>(std::floor((point.y - level_) / layerHeight));
    const Map* chosen = nullptr;
    for (const Map& map : maps_) {
        const dvec2 at = (plane - map.lower) / map.texel - 0.5;
        if (at.x < 0.0 || at.y < 0.0 || at.x >= map.size.x - 1 || at.y >= map.size.y - 1) continue;
        chosen = &map;
        if (map.texel * 1.5 >= footprint) break; // fine enough: a finer one would only be noisier
    }
    if (!chosen) return std::nullopt;
    const dvec2 at = (plane - chosen->lower) / chosen->texel - 0.5;
    const ivec2 corner(glm::floor(at));
    const vec2 part = vec2(at) - vec2(corner);
    const auto value = [&](int x, int y) { return sumAt(*chosen, corner + ivec2(x, y), layer, 2); };
    return glm::mix(glm::mix(value(0, 0), value(1, 0), part.x), glm::mix(value(0, 1), value(1, 1), part.x), part.y);
}

double SunMap::noise() const
{
    double difference = 0.0, total = 0.0, count = 0.0;
    for (const Map& map : maps_) {
        for (const Entry& entry : map.entries) {
            const double a = entry.first.y, b = entry.second.y;
            // Half the difference of two halves is the error of their mean.
            difference += 0.25 * (a - b) * (a - b);
            total += 0.5 * (a + b);
            count += 1.0;
        }
    }
    if (count == 0.0 || total == 0.0) return 0.0;
    return std::sqrt(difference / count) / (total / count);
}

double SunMap::lostFraction() const
{
    return entered_ > 0 ? static_cast<double>(lost_) / static_cast<double>(entered_) : 0.0;
}

} // namespace tarn::reference
