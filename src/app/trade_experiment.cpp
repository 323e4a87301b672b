#include "app/trade_experiment.h"

#include "app/error_budget.h"
#include "app/machine.h"
#include "app/presets.h"
#include "app/rendered_subject.h"
#include "app/trade_truth.h"
#include "base/error.h"
#include "base/files.h"
#include "measure/flip.h"
#include "measure/heat.h"
#include "measure/statistics.h"
#include "measure/water_quantities.h"

#include <unistd.h>

namespace tarn {

Settings changedSettings(Settings settings, const Changes& changes, const std::string& origin)
{
    const FieldTree tree = fieldTree(settings);
    for (const auto& [key, value] : changes) assign(tree, {key, value, origin});
    return settings;
}

DescribeSettings describerOf(const Settings& base)
{
    return [base](const Changes& changes, const std::string& origin) {
        Settings settings = changedSettings(base, changes, origin);
        return listFields(fieldTree(settings));
    };
}

std::vector<Preset> loadPresets()
{
    std::vector<Preset> presets;
    for (const std::string& name : presetNames()) {
        Preset preset{name, {}};
        for (const Assignment& assignment : readOptionsFile(presetFile(name)))
            preset.changes[assignment.key] = assignment.value;
        presets.push_back(std::move(preset));
    }
    return presets;
}

std::vector<Camera> chooseViews(const Scene& scene, const std::vector<std::string>& names, std::size_t most,
                                const char* flag)
{
    std::vector<Camera> views;
    for (const std::string& name : names) views.push_back(namedCamera(scene, name, flag));
    if (!views.empty()) return views;
    for (const Camera& camera : scene.cameras)
        if (views.size() < most) views.push_back(camera);
    if (views.empty()) views.emplace_back().name = "default";
    return views;
}

namespace {

/// The bytes of a PNG file.
std::string pngOf(const Image& image)
{
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / fmt::format("tarn-{}-picture.png", ::getpid());
    writeImage(file, image);
    std::string bytes = readFile(file);
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    return bytes;
}

Cost costOf(const BenchResult& result, const BenchResult& base, bool skipsTargets)
{
    Cost cost;
    cost.median = skipsTargets ? summarise(result.frame.wallMs).mean : percentile(result.frame.wallMs, 0.5);
    cost.p95 = percentile(result.frame.wallMs, 0.95);
    cost.cpu = skipsTargets ? summarise(result.frame.cpuMs).mean : percentile(result.frame.cpuMs, 0.5);
    cost.ratio = skipsTargets ? totalRatio(result.frame.wallMs, base.frame.wallMs)
                              : medianRatio(result.frame.wallMs, base.frame.wallMs);
    for (const auto& [name, series] : result.passes) cost.passes.push_back({name, percentile(series.wallMs, 0.5)});
    return cost;
}

class RenderedExperiment : public TradeExperiment {
public:
    RenderedExperiment(const SceneSetup& sceneSetup, const ExperimentArguments& arguments, Progress* progress)
        : sceneSetup_(sceneSetup), arguments_(arguments), session_(sceneSetup, arguments.size, progress),
          truth_(sceneSetup, {arguments.size, arguments.samples, arguments.references})
    {}

    ErrorFigures errors(const TradePoint& point, std::size_t view, double time) override
    {
        const Settings settings = settleWithoutGlow(point);
        const Camera& camera = arguments_.views[view];
        WaterQuantities used = readQuantities(session_.renderer(), camera, time, arguments_.size);
        ErrorFigures figures = truth_.judge(used, camera, time, settings.options.frame);
        if (const int interval = longestInterval(settings.options); interval > 1)
            figures.flip = flipInMotion(settings, camera, time, interval);
        return figures;
    }

    std::vector<Cost> costs(std::span<const TradePoint> points, std::size_t view) override
    {
        const SubjectView subjectView{arguments_.views[view], arguments_.times[view], arguments_.size};
        std::vector<std::unique_ptr<BenchSubject>> subjects;
        for (const TradePoint& point : points)
            subjects.push_back(
                std::make_unique<RenderedSubject>(point.label, session_, settingsOf(point), subjectView));
        const BenchReport report =
            runBenchmark(subjects, {.frames = arguments_.frames, .warmUp = 0}); // these warm themselves
        std::vector<Cost> costs;
        for (std::size_t i = 0; i < points.size(); ++i)
            costs.push_back(
                costOf(report.results[i], report.results.front(), longestInterval(settingsOf(points[i]).options) > 1));
        return costs;
    }

    TradePictures pictures(const TradePoint& point, std::size_t view) override
    {
        const Settings settings = settleWithoutGlow(point);
        const Camera& camera = arguments_.views[view];
        session_.renderer().render({camera, arguments_.times[view], arguments_.size});
        const Image shown = session_.renderer().readDisplay();
        const Image truth = truth_.display(camera, arguments_.times[view], settings.options.frame);
        return {pngOf(shown), pngOf(truth), pngOf(heatPicture(flipMap(truth, shown), 0.0, 1.0))};
    }

    /// Each takes as long as a dozen pictures of fewer samples and some slow frames: the first views must do.
    std::optional<ErrorBudget> budget(std::size_t view) override
    {
        constexpr std::size_t mostBudgets = 2;
        const Settings& settings = sceneSetup_.settings;
        if (view >= mostBudgets || !settings.water.present || !settings.options.water.enabled) return std::nullopt;
        const Camera& camera = arguments_.views[view];
        // Approximated and exact pictures have their noise in common, so that few samples tell what differs.
        reference::ReferenceOptions few = truth_.options();
        few.samples = std::max(few.samples / 4, 1);
        few.photons /= 5;
        return measureBudget({.scene = sceneSetup_.scene,
                              .settings = settings,
                              .camera = camera,
                              .time = arguments_.times[view],
                              .size = arguments_.size,
                              .reference = few,
                              .truth = &truth_.picture(camera, arguments_.times[view])},
                             session_, truth_.tracer(), nullptr);
    }

    std::string machine() const override { return fmt::format("{}; {}", session_.context().renderer(), machineText()); }

private:
    Settings settingsOf(const TradePoint& point) const
    {
        return changedSettings(sceneSetup_.settings, point.changes, point.label);
    }

    /// Mean FLIP of the picture at the end of a flight towards it, while targets of earlier frames are looked up: of as
    /// many flights as there are frames from one drawing to the next, each ending at another of these.
    double flipInMotion(const Settings& settings, const Camera& camera, double time, int interval)
    {
        constexpr float metresPerFrame = 4.0f / 30.0f; // as the viewer flies
        constexpr double secondsPerFrame = 1.0 / 30.0;
        const vec3 step = metresPerFrame * glm::normalize(camera.target - camera.eye);
        const Image truth = truth_.display(camera, time, settings.options.frame);
        double sum = 0.0;
        for (int flight = 0; flight < interval; ++flight) {
            for (int before = 2 * interval; before >= 0; --before) { // one more than twice: the next ends one frame on
                Camera then = camera;
                then.eye -= static_cast<float>(before) * step;
                then.target -= static_cast<float>(before) * step;
                session_.renderer().render({then, time - before * secondsPerFrame, arguments_.size});
            }
            sum += meanOf(flipMap(truth, session_.renderer().readDisplay()));
        }
        return sum / interval;
    }

    /// Glow is an effect of the lens, which the reference has not; it is timed, but not judged.
    Settings settleWithoutGlow(const TradePoint& point)
    {
        Settings settings = settingsOf(point);
        settings.options.glow.enabled = false;
        session_.renderer().setOptions(settings.options, settings.water);
        return settings;
    }

    const SceneSetup& sceneSetup_;
    ExperimentArguments arguments_;
    Session session_;
    TradeTruth truth_;
};

} // namespace

std::unique_ptr<TradeExperiment> makeTradeExperiment(const SceneSetup& sceneSetup, const ExperimentArguments& arguments,
                                                     Progress* progress)
{
    return std::make_unique<RenderedExperiment>(sceneSetup, arguments, progress);
}

} // namespace tarn
