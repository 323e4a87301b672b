#include "reference/reference.h"

#include "base/error.h"
#include "base/progress.h"
#include "reference/accumulation.h"
#include "reference/identity.h"
#include "reference/integrator.h"
#include "reference/lens.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <chrono>
#include <cmath>
#include <mutex>

namespace tarn::reference {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

template <typename Visit> void overPixels(ivec2 size, const Visit& visit)
{
    tbb::parallel_for(tbb::blocked_range<int>(0, size.y), [&](const auto& rows) {
        for (int y = rows.begin(); y < rows.end(); ++y)
            for (int x = 0; x < size.x; ++x)
                visit(x, y,
                      static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x));
    });
}

void requireSize(ivec2 size)
{
    if (size.x < 1 || size.y < 1 || size.x > 16384 || size.y > 16384)
        throw Error("a reference of {}x{} pixels cannot be traced; 1 to 16384 a side", size.x, size.y);
}

} // namespace

struct Tracer::State {
    const Scene& scene;
    const WaterBody& body;
    float sunSlopeDeviation;
    Geometry geometry;
    Light light;
    mutable std::once_flag isIdentified;
    mutable std::string identifiedScene;

    State(const Scene& s, const WaterBody& w, float slopeDeviation)
        : scene(s), body(w), sunSlopeDeviation(slopeDeviation), geometry(s), light(s, w)
    {}

    SunMap::Inputs mapInputs(const WaterSurface& water, int photons, int seed) const
    {
        return {geometry, water, light, photons, seed};
    }
    std::optional<WaterSurface> surface(const ViewRequest& view) const
    {
        if (!body.present) return std::nullopt;
        return WaterSurface(body, view.time, grid(view, view.gridSize), grid(view, view.normalGridSize), normalMap());
    }
    /// Null when the water has none.
    const Image* normalMap() const
    {
        const WaterNormalMap& map = body.normalMap;
        return map.isSeen() ? &scene.images[static_cast<std::size_t>(map.image)] : nullptr;
    }
    /// As the viewer would lay it for this view; nothing for fewer than two vertices.
    std::optional<optics64::WaterGrid> grid(const ViewRequest& view, int size) const
    {
        if (size < 2) return std::nullopt;
        const glm::dvec4 rect(body.centre.x, body.centre.y, 0.5f * body.extent.x, 0.5f * body.extent.y);
        if (!view.gridFocused) return optics64::uniformGrid(rect, size);
        double amplitude = 0.0;
        for (const Wave& w : body.waves) amplitude += static_cast<double>(std::abs(w.amplitude));
        const float aspect = static_cast<float>(view.size.x) / static_cast<float>(view.size.y);
        const glm::dmat4 clipFromWorld =
            glm::dmat4(clipFromView(view.camera, aspect)) * glm::dmat4(viewFromWorld(view.camera));
        return optics64::focusedGrid(rect, static_cast<double>(body.level), amplitude, size,
                                     glm::dvec3(view.camera.eye), clipFromWorld);
    }
    SunMap sunMap(const ViewRequest& view, const ReferenceOptions& options, Progress* progress) const;
    World world(const ViewRequest& view, const WaterSurface* water, const SunMap& map,
                const ReferenceOptions& options) const
    {
        return {geometry, water, light, map, sunSlopeDeviation, options, view.approximations};
    }
    /// Made when it is first asked for: it reads every vertex and texel.
    const std::string& sceneIdentity() const
    {
        std::call_once(isIdentified, [this] { identifiedScene = reference::sceneIdentity(scene, body); });
        return identifiedScene;
    }
    std::string identity(const ViewRequest& view, const ReferenceOptions& options) const
    {
        return sceneIdentity() + viewIdentity(view, options, sunSlopeDeviation);
    }
    Picture picture(const ViewRequest& view, const WaterSurface* water, const SunMap& map,
                    const ReferenceOptions& options, const Accumulation& sums) const;
};

Tracer::Tracer(const Scene& scene, const WaterBody& water, float sunSlopeDeviation)
    : state_(std::make_unique<State>(scene, water, sunSlopeDeviation))
{}

Tracer::~Tracer() = default;

/// Photons are wanted where the picture looks: a coarse picture finds out.
SunMap Tracer::State::sunMap(const ViewRequest& view, const ReferenceOptions& options, Progress* progress) const
{
    if (!body.present || !light.hasSun() || view.flatLight) return {};
    const WaterSurface waves(body, view.time, {}, {}, normalMap());
    if (view.causticsTexture) {
        const auto& [rect, texel, filter] = *view.causticsTexture;
        return SunMap(mapInputs(waves, options.photons, options.seed), rect, texel, progress, filter);
    }
    const SunMap none;
    const World probe = world(view, &waves, none, options);
    const Integrator integrator(probe);
    // Finer than pixels for small pictures: a reference of a few pixels still needs its light.
    const double step = std::max(std::sqrt(static_cast<double>(view.size.x) * view.size.y / 30000.0), 0.25);
    const ivec2 coarse = glm::max(ivec2(glm::dvec2(view.size) / step), ivec2(1));
    const Lens lens(view.camera, coarse);
    std::vector<std::vector<LightQuery>> found(static_cast<std::size_t>(coarse.x) * static_cast<std::size_t>(coarse.y));
    const double pixelAngle = Lens(view.camera, view.size).pixelAngle();
    overPixels(coarse, [&](int x, int y, std::size_t pixel) {
        integrator.lightQueries(lens.through(x + 0.5, y + 0.5), pixelAngle, found[pixel]);
    });
    std::vector<LightQuery> queries;
    for (const auto& some : found) queries.insert(queries.end(), some.begin(), some.end());
    return SunMap(mapInputs(waves, options.photons, options.seed), queries, progress);
}

namespace {

float luminance(const vec3& c) { return glm::dot(c, vec3(0.2126f, 0.7152f, 0.0722f)); }

/// One more path through each pixel. The places within the pixels follow an even sequence, shifted per pixel.
void addSample(const Integrator& integrator, const Lens& lens, int seed, Accumulation& sums)
{
    const int sample = sums.samples;
    overPixels(sums.size, [&](int x, int y, std::size_t pixel) {
        Random shift(static_cast<std::uint64_t>(seed), pixel);
        const dvec2 offset = evenlySpread(static_cast<std::uint64_t>(sample), shift.next2());
        Random random(static_cast<std::uint64_t>(seed) + 1u, pixel << 24 | static_cast<std::uint64_t>(sample));
        double truncated = 0.0;
        const vec3 radiance =
            integrator.radiance(lens.through(x + offset.x, y + offset.y), lens.pixelAngle(), random, truncated);
        sums.radiance[pixel] += radiance;
        sums.squares[pixel] += luminance(radiance) * luminance(radiance);
        sums.truncated[pixel] += static_cast<float>(truncated);
    });
    ++sums.samples;
}

/// Standard error of the pixels' means, RMS, over the mean luminance; of few samples, nothing can be said.
double noiseOf(const Accumulation& sums)
{
    if (sums.samples < 2) return 0.0;
    const double n = sums.samples;
    double error = 0.0, total = 0.0;
    for (std::size_t i = 0; i < sums.radiance.size(); ++i) {
        const double mean = luminance(sums.radiance[i]) / n;
        error += std::max(sums.squares[i] / n - mean * mean, 0.0) / (n - 1.0);
        total += mean;
    }
    const auto pixels = static_cast<double>(sums.radiance.size());
    return total > 0.0 ? std::sqrt(error / pixels) / (total / pixels) : 0.0;
}

double meanTruncated(const Accumulation& sums)
{
    double total = 0.0;
    for (const float fraction : sums.truncated) total += fraction;
    return total / (static_cast<double>(sums.truncated.size()) * std::max(sums.samples, 1));
}

void samplesInto(Accumulation& sums, const Integrator& integrator, const Lens& lens, const ReferenceOptions& options,
                 const std::string& identity, const Checkpoint& checkpoint, Progress* progress)
{
    auto saved = Clock::now();
    while (sums.samples < options.samples) {
        const bool stops = checkpoint.interrupt && *checkpoint.interrupt;
        if (!checkpoint.file.empty() && sums.samples > 0 && (stops || secondsSince(saved) > checkpoint.everySeconds)) {
            save(checkpoint.file, sums, identity);
            saved = Clock::now();
        }
        if (stops) throw Interrupted();
        addSample(integrator, lens, options.seed, sums);
        if (progress)
            progress->report(static_cast<double>(sums.samples) / options.samples,
                             fmt::format("tracing sample {} of {}", sums.samples, options.samples));
    }
}

} // namespace

/// What the paths summed up to, and the quantities of each pixel's centre.
Picture Tracer::State::picture(const ViewRequest& view, const WaterSurface* water, const SunMap& map,
                               const ReferenceOptions& options, const Accumulation& sums) const
{
    const World all = world(view, water, map, options);
    const Integrator integrator(all);
    const Lens lens(view.camera, view.size);
    Picture picture(view.size);
    overPixels(view.size, [&](int x, int y, std::size_t pixel) {
        picture.radiance[pixel] = sums.radiance[pixel] / static_cast<float>(sums.samples);
        integrator.quantities(lens.through(x + 0.5, y + 0.5), lens.pixelAngle(), picture, pixel);
    });
    return picture;
}

std::vector<Picture> Tracer::renderAll(const std::vector<Request>& requests, Progress* progress) const
{
    const State& s = *state_;
    std::vector<Picture> pictures;
    SunMap map;
    std::string mapOf;
    for (const auto& [view, options] : requests) {
        requireSize(view.size);
        Request light{view, options};
        light.view.approximations = {};
        light.view.gridSize = light.view.normalGridSize = light.options.bounces = 0;
        if (const std::string wanted = s.identity(light.view, light.options); mapOf != wanted) {
            map = s.sunMap(view, options, nullptr);
            mapOf = wanted;
        }
        const std::optional<WaterSurface> water = s.surface(view);
        const World world = s.world(view, water ? &*water : nullptr, map, options);
        const Integrator integrator(world);
        Accumulation sums(view.size);
        samplesInto(sums, integrator, Lens(view.camera, view.size), options, "", {}, nullptr);
        pictures.push_back(s.picture(view, water ? &*water : nullptr, map, options, sums));
        if (progress)
            progress->report(static_cast<double>(pictures.size()) / static_cast<double>(requests.size()),
                             fmt::format("tracing picture {} of {}", pictures.size(), requests.size()));
    }
    return pictures;
}

Picture Tracer::render(const ViewRequest& view, const ReferenceOptions& options, Progress* progress,
                       const Checkpoint& checkpoint, TraceReport* report) const
{
    requireSize(view.size);
    const auto start = Clock::now();
    const State& s = *state_;
    const std::string identity = s.identity(view, options);
    Accumulation sums = checkpoint.file.empty() ? Accumulation(view.size) : load(checkpoint.file, view.size, identity);

    const std::optional<WaterSurface> water = s.surface(view);
    const SunMap map = s.sunMap(view, options, progress);
    const World world = s.world(view, water ? &*water : nullptr, map, options);
    const Integrator integrator(world);
    const Lens lens(view.camera, view.size);
    samplesInto(sums, integrator, lens, options, identity, checkpoint, progress);

    Picture picture = s.picture(view, water ? &*water : nullptr, map, options, sums);
    TraceReport done{.seconds = secondsSince(start),
                     .truncatedFraction = meanTruncated(sums),
                     .causticsNoise = map.noise(),
                     .lostPhotons = map.lostFraction(),
                     .photons = map.photonCount(),
                     .radianceNoise = noiseOf(sums)};
    picture.metadata = {{"tarn:samples", fmt::format("{}", sums.samples)},
                        {"tarn:scene_content", s.sceneIdentity()},
                        {"tarn:reference", identity},
                        {"tarn:radiance", "linear RGB; times 1/n^2 where it leaves the water and n^2 where it enters"},
                        {"tarn:truncated_fraction", fmt::format("{:.3g}", done.truncatedFraction)},
                        {"tarn:radiance_noise", fmt::format("{:.3g}", done.radianceNoise)},
                        {"tarn:photons", fmt::format("{}", done.photons)},
                        {"tarn:caustics_noise", fmt::format("{:.3g}", done.causticsNoise)}};
    if (report) *report = done;
    return picture;
}

std::string Tracer::identity(const ViewRequest& view, const ReferenceOptions& options) const
{
    return state_->identity(view, options);
}

Picture Tracer::quantities(const ViewRequest& view, const ReferenceOptions& options, Progress* progress) const
{
    requireSize(view.size);
    const State& s = *state_;
    const std::optional<WaterSurface> water = s.surface(view);
    const SunMap map = s.sunMap(view, options, progress);
    const World world = s.world(view, water ? &*water : nullptr, map, options);
    const Integrator integrator(world);
    const Lens lens(view.camera, view.size);
    Picture picture(view.size);
    overPixels(view.size, [&](int x, int y, std::size_t pixel) {
        integrator.quantities(lens.through(x + 0.5, y + 0.5), lens.pixelAngle(), picture, pixel);
    });
    return picture;
}

std::function<std::optional<vec3>(const vec2& plane)> Tracer::lightOnBed(double time, const vec4& rect, double texel,
                                                                         int photons, int seed) const
{
    const State& s = *state_;
    if (!s.body.present || !s.light.hasSun()) return [](const vec2&) { return std::nullopt; };
    struct Known {
        WaterSurface water;
        SunMap map;
    };
    const WaterSurface water(s.body, time, {}, {}, s.normalMap());
    const auto known =
        std::make_shared<Known>(Known{water, SunMap(s.mapInputs(water, photons, seed), rect, texel, nullptr)});
    const dvec3 toSun = glm::normalize(dvec3(s.light.sunDirectionBelow));
    return [known, toSun, texel, &s](const vec2& plane) -> std::optional<vec3> {
        if (!known->water.spans(plane.x, plane.y)) return std::nullopt;
        const dvec3 level(plane.x, known->water.level(), plane.y);
        const auto hit = s.geometry.intersect({level, -toSun}, 0.0, 1e4, Sides::both);
        if (!hit) return std::nullopt;
        return known->map.relativeIrradiance(level - hit->distance * toSun, texel);
    };
}

} // namespace tarn::reference
