#include "render/warm_up.h"

#include "base/progress.h"
#include "gl/profiler.h"
#include "gl/shader_library.h"
#include "gl/vertex_array.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace tarn {

namespace {

/// A frame that nobody sees.
struct Sort {
    Options options;
    Camera camera;
    double time = 0.0;
    ivec2 size{16, 12};
};

/// As small as it can be, and never as large as the user's: nothing that is drawn here may be taken for theirs.
Options small(Options options)
{
    for (int* size : {&options.sunlight.mapSize, &options.heights.mapSize, &options.refraction.targetSize,
                      &options.reflection.targetSize, &options.caustics.photons, &options.caustics.textureSize})
        *size = *size == 16 ? 32 : 16;
    for (const RuleId keeper : {RuleId::keepFrame, RuleId::keepMaps, RuleId::keepTargets})
        options.plan.rules[static_cast<std::size_t>(keeper)] = false;
    return options;
}

/// Everything there is: no chunk is left out.
Options complete(const Options& options)
{
    Options all = small(options);
    all.plan.rules.fill(false);
    return all;
}

Camera levelCamera(const vec3& eye)
{
    Camera camera;
    camera.eye = eye;
    camera.target = eye + vec3(1.0f, -0.1f, 0.0f);
    return camera;
}

/// Frames that together use every program that a frame with these options may use.
std::vector<Sort> everySort(const Options& options, const WaterBody& water)
{
    std::vector<Sort> sorts;
    const Options all = complete(options);
    const auto add = [&](const Options& variant, float height) {
        sorts.push_back({variant, levelCamera(vec3(water.centre.x, height, water.centre.y))});
    };
    const float amplitude = totalAmplitude(water);
    const float above = water.level + amplitude + 1.0f;
    // The rules leave out either target, and with the bed its caustics.
    for (const bool refracts : {true, false}) {
        for (const bool reflects : {true, false}) {
            Options variant = all;
            variant.refraction.enabled = refracts && options.refraction.enabled;
            variant.reflection.enabled = reflects && options.reflection.enabled;
            add(variant, above);
        }
    }
    if (!water.present || !options.water.enabled) return sorts;
    Options glowless = all;
    glowless.glow.enabled = false;
    add(glowless, above);
    add(all, surfaceHeight(water, water.centre, 0.0)); // cuts the near plane
    add(all, water.level - amplitude - 1.0f);
    return sorts;
}

/// Draws frames, and looks after the first uses of programs meanwhile; the renderer is then as it was.
class Rehearsing {
public:
    Rehearsing(Renderer& renderer, const WaterBody& water)
        : renderer_(renderer), options_(renderer.options()), water_(water)
    {
        renderer_.setWarmingUp(true);
    }
    ~Rehearsing()
    {
        renderer_.shaders().watchFirstUses({});
        renderer_.setWarmingUp(false);
        renderer_.setOptions(options_, water_);
    }

    /// How many programs the frames use that were not drawn with yet. They are compiled and linked.
    std::size_t count(const std::vector<Sort>& sorts, Progress* progress)
    {
        std::set<const gl::Program*> programs;
        renderer_.shaders().watchFirstUses([&](const gl::Program& program) {
            if (programs.insert(&program).second && progress)
                progress->report(0.0, fmt::format("compiling shaders, {} so far", programs.size()));
            return false;
        });
        const gl::NoDrawing noDrawing;
        draw(sorts);
        return programs.size();
    }

    /// Every second program that was not yet drawn with.
    /// @param first of them, 0 or 1   @param next before each
    void buildHalf(const std::vector<Sort>& sorts, std::size_t first, const std::function<void()>& next)
    {
        std::map<const gl::Program*, std::size_t> numbers;
        std::optional<gl::NoDrawing> skipping;
        renderer_.shaders().watchFirstUses([&](const gl::Program& program) {
            const std::size_t number = numbers.try_emplace(&program, numbers.size()).first->second;
            const bool builds = number % 2 == first;
            if (builds) next();
            if (builds)
                skipping.reset();
            else if (!skipping)
                skipping.emplace();
            return builds;
        });
        draw(sorts);
    }

    /// @param next before each program that was not yet drawn with; while it answers false none is
    void build(const std::vector<Sort>& sorts, const std::function<bool()>& next)
    {
        std::optional<gl::NoDrawing> rest;
        renderer_.shaders().watchFirstUses([&](const gl::Program&) {
            if (!rest && !next()) rest.emplace();
            return !rest;
        });
        draw(sorts);
    }

private:
    void draw(const std::vector<Sort>& sorts)
    {
        for (const Sort& sort : sorts) {
            renderer_.setOptions(sort.options, water_);
            renderer_.render({sort.camera, sort.time, sort.size});
        }
    }

    Renderer& renderer_;
    Options options_;
    const WaterBody& water_;
};

void say(Progress* progress, std::size_t number, std::size_t of)
{
    const double fraction = static_cast<double>(number - 1) / static_cast<double>(std::max<std::size_t>(of, 1));
    if (progress) progress->report(std::min(fraction, 1.0), fmt::format("building shaders, {} of {}", number, of));
}

/// Those that were not drawn with yet.
/// @param order none: as they come
std::size_t buildAll(Renderer& renderer, const WaterBody& water, const std::vector<Sort>& sorts, Progress* progress,
                     std::optional<Rehearsal::Order> order = {})
{
    Rehearsing rehearsing(renderer, water);
    const std::size_t programs = rehearsing.count(sorts, progress);
    std::size_t built = 0;
    const auto next = [&] {
        ++built;
        say(progress, built, std::max(built, programs));
        return true;
    };
    if (order) rehearsing.buildHalf(sorts, *order == Rehearsal::Order::oddFirst ? 1 : 0, next);
    rehearsing.build(sorts, next);
    return built;
}

} // namespace

void warmUp(Renderer& renderer, const WaterBody& water, Progress* progress)
{
    buildAll(renderer, water, everySort(renderer.options(), water), progress);
}

struct Rehearsal::State {
    State(std::shared_ptr<GpuScene> scene, gl::ShaderLibrary& shaders, const Options& o, const WaterBody& w,
          Progress* p)
        : options(o), water(w), progress(p), renderer(std::move(scene), o, shaders, profiler)
    {
        renderer.setOptions(o, w);
    }

    Options options;
    WaterBody water;
    Progress* progress;
    gl::Profiler profiler;
    Renderer renderer;
    std::vector<Sort> sorts; ///< empty: not yet listed for these options
    std::size_t built = 0, programs = 0;
};

Rehearsal::Rehearsal(std::shared_ptr<GpuScene> scene, gl::ShaderLibrary& shaders, const Options& options,
                     const WaterBody& water, Progress* progress)
    : state_(std::make_unique<State>(std::move(scene), shaders, options, water, progress))
{}

Rehearsal::~Rehearsal() = default;

void Rehearsal::setOptions(const Options& options, const WaterBody& water)
{
    State& s = *state_;
    s.options = options;
    s.water = water;
    s.renderer.setOptions(options, water);
    s.sorts.clear();
}

void Rehearsal::build(const View& view, Order order)
{
    State& s = *state_;
    // As wide as the asked picture for its height, so that it sees as much.
    const float across = 16.0f * std::sqrt(static_cast<float>(view.size.x) / static_cast<float>(view.size.y));
    const ivec2 size = glm::max(ivec2(glm::round(vec2(across, 256.0f / across))), ivec2(1));
    s.built += buildAll(s.renderer, s.water, {{small(s.options), view.camera, view.time, size}}, s.progress, order);
}

bool Rehearsal::buildOthers(std::size_t most)
{
    State& s = *state_;
    Rehearsing rehearsing(s.renderer, s.water);
    if (s.sorts.empty()) {
        s.sorts = everySort(s.options, s.water);
        s.programs = s.built + rehearsing.count(s.sorts, s.progress);
    }
    std::size_t now = 0;
    rehearsing.build(s.sorts, [&] {
        if (now == most) return false;
        ++now;
        ++s.built;
        say(s.progress, s.built, std::max(s.built, s.programs));
        return true;
    });
    return now == most;
}

} // namespace tarn
