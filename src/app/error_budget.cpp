#include "app/error_budget.h"

#include "app/reference_view.h"
#include "app/trade_experiment.h"
#include "base/progress.h"
#include "gl/context.h"
#include "measure/display.h"
#include "measure/flip.h"
#include "render/bed_detail.h"
#include "render/sun_views.h"
#include "render/view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tarn {

namespace {

using reference::ViewRequest;

reference::TargetCamera targetCamera(const View& view)
{
    reference::TargetCamera camera;
    camera.viewFromWorld = glm::dmat4(view.viewFromWorld);
    camera.tangents = 1.0 / glm::dvec2(view.clipFromView[0][0], view.clipFromView[1][1]);
    camera.farPlane = static_cast<double>(view.farPlane);
    camera.keepsAbove = view.clipPlane.y > 0.0f;
    camera.clipLevel = static_cast<double>(camera.keepsAbove ? -view.clipPlane.w : view.clipPlane.w);
    camera.throughFlatWater = view.flatWater.has_value();
    return camera;
}

/// The settings as the renderer takes them: it does not look through flat water at a bed of few triangles.
Settings asDrawn(Settings settings, const Scene& scene)
{
    RefractionOptions::CameraMode& camera = settings.options.refraction.camera;
    if (camera == RefractionOptions::CameraMode::flat && coarseEdgeUnderWater(scene, settings.water) > longestBedEdge)
        camera = RefractionOptions::CameraMode::snell;
    return settings;
}

/// Waves go as far over and under the level; a clip plane must leave that much, m.
float leastClipOffset(const WaterBody& water)
{
    float amplitude = 0.0f;
    for (const Wave& wave : water.waves) amplitude += std::abs(wave.amplitude);
    return std::max(std::ceil(1000.0f * amplitude - 1e-3f) / 1000.0f, 0.01f);
}

std::string atLeast(int value, int now) { return fmt::format("{}", std::max(value, now)); }

/// Collects the parts of one frame.
struct Parts {
    const Scene& scene;
    const Settings settings;
    const Camera& camera;
    ivec2 size;
    std::vector<BudgetPart> list{};

    const Options& options() const { return settings.options; }
    float aspect() const { return static_cast<float>(size.x) / static_cast<float>(size.y); }
    bool isUnderwater() const { return camera.eye.y < settings.water.level; }

    void add(std::string name, Changes exact, std::function<void(ViewRequest&)> approximate = {})
    {
        list.push_back({std::move(name), std::move(exact), std::move(approximate)});
    }

    void addSurface()
    {
        const WaterOptions& water = options().water;
        const bool focused = water.grid == WaterOptions::Grid::focused;
        add("tessellation", {{"water.grid_size", "1025"}}, [n = water.gridSize, focused](ViewRequest& view) {
            view.gridSize = n;
            view.gridFocused = focused;
        });
        const int normals = water.normals == WaterOptions::Normals::vertex ? water.gridSize : 0;
        add("normals of vertices", {{"water.normals", "pixel"}}, [normals, focused](ViewRequest& view) {
            view.normalGridSize = normals;
            view.gridFocused = focused;
        });
        add("waves below a pixel", {{"water.filter_waves", "true"}, {"reflection.facets", "five"}});
    }

    void addRefraction()
    {
        const RefractionOptions& refraction = options().refraction;
        std::function<void(ViewRequest&)> coverage, intersection, texels;
        if (refraction.enabled && !isUnderwater()) {
            const reference::TargetCamera target =
                targetCamera(refractionView(camera, aspect(), settings.water, options(), false));
            using Method = RefractionOptions::Method;
            const bool planar = refraction.method == Method::planar;
            texels = [target, resolution = refraction.targetSize](ViewRequest& view) {
                view.approximations.refractionTexels = {target, resolution};
            };
            coverage = [target](ViewRequest& view) { view.approximations.refraction = target; };
            // The reference knows the search in a target alone, not the march through a map.
            if (planar || refraction.method == Method::iterative)
                intersection = [target, planar, steps = refraction.steps](ViewRequest& view) {
                    view.approximations.refraction = target;
                    view.approximations.refractionSteps = steps;
                    view.approximations.planarRefraction = planar;
                };
        }
        add("moved camera's coverage", {{"refraction.enabled", "true"}, {"refraction.camera", "flat"}}, coverage);
        add("intersection", {{"refraction.method", "iterative"}, {"refraction.steps", atLeast(24, refraction.steps)}},
            intersection);
        add("refraction texture",
            {{"refraction.target_size", atLeast(2048, refraction.targetSize)}, {"refraction.depth", "depth32f"}},
            texels);
        if (isUnderwater()) add("rays that leave the water", {{"underwater.refraction", "exact"}});
    }

    void addReflection()
    {
        const ReflectionOptions& reflection = options().reflection;
        std::function<void(ViewRequest&)> lookup, texels;
        if (options().water.reflects && reflection.enabled && !isUnderwater()) {
            const reference::TargetCamera target =
                targetCamera(reflectionView(camera, aspect(), settings.water, reflection, false));
            texels = [target, resolution = reflection.targetSize](ViewRequest& view) {
                view.approximations.reflectionTexels = {target, resolution};
            };
            using Method = ReflectionOptions::Method;
            const bool searches = reflection.method == Method::iterative;
            if (searches || reflection.method == Method::distance)
                lookup = [target, steps = searches ? reflection.steps : 0, c = reflection.distance](ViewRequest& view) {
                    view.approximations.reflection = target;
                    view.approximations.reflectionSteps = steps;
                    view.approximations.reflectionDistance = static_cast<double>(c);
                };
        }
        add("reflection lookup",
            {{"reflection.enabled", "true"},
             {"reflection.method", "iterative"},
             {"reflection.steps", atLeast(16, reflection.steps)}},
            lookup);
        add("reflection texture", {{"reflection.target_size", atLeast(2048, reflection.targetSize)}}, texels);
    }

    void addFresnel()
    {
        const WaterOptions& water = options().water;
        if (!water.reflects) {
            add("no reflection", {{"water.reflects", "true"}, {"water.fresnel", "exact"}});
            return;
        }
        if (water.fresnel == WaterOptions::Fresnel::table) {
            std::function<void(ViewRequest&)> lookup;
            if (!isUnderwater())
                lookup = [table =
                              optics::makeFresnelTable(settings.water.ior, water.fresnelTable, water.fresnelFilter)](
                             ViewRequest& view) { view.approximations.fresnelTable = table; };
            add("Fresnel's table", {{"water.fresnel", "exact"}}, lookup);
            return;
        }
        const float exponent = water.fresnel == WaterOptions::Fresnel::schlick ? water.schlickExponent : 0.0f;
        std::function<void(ViewRequest&)> schlick;
        if (!isUnderwater())
            schlick = [exponent](ViewRequest& view) { view.approximations.schlickExponent = exponent; };
        add("Schlick's Fresnel", {{"water.fresnel", "exact"}}, schlick);
    }

    /// Only where it is there: a budget of the exponential has nothing to say of it.
    void addAttenuation()
    {
        const WaterOptions& water = options().water;
        if (water.attenuation == WaterOptions::Attenuation::exponential) return;
        std::function<void(ViewRequest&)> linear;
        if (!isUnderwater())
            linear = [length = water.attenuationLength](ViewRequest& view) {
                view.approximations.attenuationLength = length;
            };
        add("linear attenuation", {{"water.attenuation", "exponential"}}, linear);
    }

    void addSun()
    {
        const CausticsOptions& caustics = options().caustics;
        const CausticsRegion region = causticsRegion(settings.water, camera, caustics);
        const ViewRequest::CausticsTexture texture{.rect = vec4(region.rect.centre, region.rect.halfExtent),
                                                   .texel = 2.0 * static_cast<double>(region.rect.halfExtent.x) /
                                                            caustics.textureSize,
                                                   .filter = caustics.filter};
        add("caustics map",
            {{"caustics.enabled", "true"},
             {"caustics.method", "fetch"},
             {"caustics.texture_size", atLeast(1024, caustics.textureSize)},
             {"caustics.photons", atLeast(1024, caustics.photons)},
             {"caustics.steps", atLeast(8, caustics.steps)}},
            [texture, enabled = caustics.enabled](ViewRequest& view) {
                if (enabled)
                    view.causticsTexture = texture;
                else
                    view.flatLight = true;
            });
        const SunlightOptions& sunlight = options().sunlight;
        std::function<void(ViewRequest&)> shadows;
        if (sunlight.shadows && scene.sun) {
            reference::ShadowTexels map{.cascades = {}, .resolution = sunlight.mapSize, .taps = sunlight.taps};
            const SunVolume volume = sunVolume(settings.water, worldBounds(scene), scene.sun->direction, sunlight);
            for (std::size_t i = 0; i < volume.cascades.size(); ++i)
                map.cascades.push_back({.rect = glm::dvec4(volume.cascades[i].centre, volume.cascades[i].halfExtent),
                                        .bias = static_cast<double>(shadowBias(volume, i, sunlight))});
            shadows = [map](ViewRequest& view) { view.approximations.shadows = map; };
        }
        add("shadow map",
            {{"sunlight.shadows", "true"},
             {"sunlight.map_size", atLeast(4096, sunlight.mapSize)},
             {"sunlight.cascades", "3"},
             {"sunlight.taps", atLeast(3, sunlight.taps)}},
            shadows);
    }

    void addFrame()
    {
        const float least = leastClipOffset(settings.water);
        const auto offset = [&](float now) { return fmt::format("{}", std::min(now, least)); };
        add("clip planes", {{"refraction.clip_offset", offset(options().refraction.clipOffset)},
                            {"reflection.clip_offset", offset(options().reflection.clipOffset)}});
        add("samples of a pixel", {{"frame.antialiasing", "msaa"},
                                   {"frame.msaa", atLeast(4, options().frame.msaa)},
                                   {"frame.scale", fmt::format("{}", std::max(3.0f, options().frame.scale))},
                                   {"frame.anisotropy", "16"}});
    }
};

} // namespace

std::vector<BudgetPart> budgetParts(const Scene& scene, const Settings& settings, const Camera& camera, ivec2 size)
{
    Parts parts{scene, asDrawn(settings, scene), camera, size};
    parts.addSurface();
    parts.addRefraction();
    parts.addReflection();
    parts.addFresnel();
    parts.addAttenuation();
    parts.addSun();
    parts.addFrame();
    return std::move(parts.list);
}

namespace {

/// Frames and references of one view, and how much they differ.
class BudgetBench {
public:
    BudgetBench(const BudgetRequest& request, Session& session, const reference::Tracer& tracer, Progress* progress)
        : request_(request), session_(session), tracer_(tracer), progress_(progress),
          parts_(budgetParts(request.scene, request.settings, request.camera, request.size))
    {}

    ErrorBudget measure()
    {
        ErrorBudget budget;
        budget.quantity = "mean FLIP";
        for (const BudgetPart& part : parts_)
            budget.rows.push_back({part.name, ErrorBudget::none, ErrorBudget::none, ""});
        const reference::Picture exact = measureAlone(budget);
        measureRemoved(budget, shown(request_.truth ? *request_.truth : exact));
        return budget;
    }

private:
    ViewRequest exactView() const
    {
        return {.camera = request_.camera, .time = request_.time, .size = request_.size, .approximations = {}};
    }
    Image shown(const reference::Picture& picture) const
    {
        return displayPicture(picture, request_.settings.options.frame);
    }

    /// Puts the approximations into the reference. Returns it without any.
    reference::Picture measureAlone(ErrorBudget& budget) const
    {
        const reference::ReferenceOptions& options = request_.reference;
        std::vector<reference::Tracer::Request> requests{{exactView(), options}};
        std::vector<double*> figures{nullptr};
        const auto ask = [&](const ViewRequest& view, const reference::ReferenceOptions& how, double& figure) {
            figure = 0.0;
            if (tracer_.identity(view, how) == tracer_.identity(exactView(), options)) return;
            requests.push_back({view, how});
            figures.push_back(&figure);
        };
        ViewRequest whole = exactView();
        // What has the exact picture's light comes first, and shares it.
        const auto askForParts = [&](bool ownLight) {
            for (std::size_t i = 0; i < parts_.size(); ++i) {
                if (!parts_[i].approximate) continue;
                ViewRequest view = exactView();
                parts_[i].approximate(view);
                if ((view.flatLight || view.causticsTexture) != ownLight) continue;
                parts_[i].approximate(whole);
                ask(view, options, budget.rows[i].alone);
            }
        };
        askForParts(false);
        reference::ReferenceOptions other = options;
        constexpr int bouncesThatMatter = 2;
        other.bounces += bouncesThatMatter;
        ask(exactView(), other, budget.unmodelled);
        askForParts(true);
        ask(whole, options, budget.together);
        other = options;
        ++other.seed;
        if (!request_.truth) ask(exactView(), other, budget.noise);

        std::vector<reference::Picture> pictures = tracer_.renderAll(requests, progress_);
        const Image truth = shown(pictures.front());
        for (std::size_t i = 1; i < pictures.size(); ++i) *figures[i] = meanOf(flipMap(truth, shown(pictures[i])));
        return std::move(pictures.front());
    }

    /// Takes them out of the frame.
    void measureRemoved(ErrorBudget& budget, const Image& truth) const
    {
        const Settings& base = request_.settings;
        budget.total = frameError(base, truth);
        Settings exact = base;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            ErrorBudget::Row& row = budget.rows[i];
            const Settings changed = changedSettings(base, parts_[i].exact, parts_[i].name);
            exact = changedSettings(exact, parts_[i].exact, parts_[i].name);
            row.exact = differences(base, parts_[i]);
            row.removed = row.exact.empty() ? 0.0 : budget.total - frameError(changed, truth);
            if (progress_)
                progress_->report(static_cast<double>(i + 1) / static_cast<double>(parts_.size()),
                                  fmt::format("taking out {}", row.part));
        }
        budget.remaining = frameError(exact, truth);
    }

    /// Those of a part's options that the settings do not have.
    static std::string differences(const Settings& base, const BudgetPart& part)
    {
        const std::string baseText = settingsJson(base);
        std::string text;
        for (const auto& [key, value] : part.exact)
            if (settingsJson(changedSettings(base, {{key, value}}, part.name)) != baseText)
                text += fmt::format("{}{}={}", text.empty() ? "" : " ", key, value);
        return text;
    }

    double frameError(Settings settings, const Image& truth) const
    {
        settings.options.glow.enabled = false;
        Renderer& renderer = session_.renderer();
        renderer.setOptions(settings.options, settings.water);
        renderer.render({request_.camera, request_.time, request_.size});
        return meanOf(flipMap(truth, renderer.readDisplay()));
    }

    const BudgetRequest& request_;
    Session& session_;
    const reference::Tracer& tracer_;
    Progress* progress_;
    std::vector<BudgetPart> parts_;
};

} // namespace

ErrorBudget measureBudget(const BudgetRequest& request, Session& session, const reference::Tracer& tracer,
                          Progress* progress)
{
    return BudgetBench(request, session, tracer, progress).measure();
}

} // namespace tarn
