// tarn bench: what the frame costs with the water, without it, and with any option changed.
#include "app/commands.h"
#include "app/session.h"
#include "base/error.h"
#include "measure/benchmark.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace tarn
{

namespace
{

constexpr double secondsPerFrame = 1.0 / 30.0;

/// One configuration. All share a renderer, so that textures and buffers are those of one program.
class RenderedSubject : public BenchSubject
{
public:
    RenderedSubject(std::string name, Session& session, Settings settings, const Camera& camera,
                    const ViewArguments& view)
        : name_(std::move(name)), session_(session), settings_(std::move(settings)), camera_(camera),
          view_(view)
    {
    }

    std::string name() const override { return name_; }

    void draw(int index) override
    {
        session_.renderer().setOptions(settings_.options, settings_.water);
        stats_ = &session_.renderer().render({camera_, view_.time + index * secondsPerFrame, view_.size});
        finishGpu();
    }

    std::vector<BenchPass> drawPasses(int index) override
    {
        session_.profiler().setSynchronous(true);
        draw(index);
        // The profiler hands out the newest frame whose results are in: make sure that it is this one.
        draw(index);
        session_.profiler().setSynchronous(false);
        std::vector<BenchPass> passes;
        for (const gl::PassTime& time : session_.profiler().latest())
            if (time.name != "frame")
                passes.push_back({time.name, time.wallMs, time.cpuMs, triangles(time.name)});
        return passes;
    }

private:
    std::uint64_t triangles(const std::string& pass) const
    {
        for (const FrameStats::Pass& stats : stats_->passes)
            if (stats.name == pass) return stats.triangles;
        return 0;
    }

    std::string name_;
    Session& session_;
    Settings settings_;
    const Camera& camera_;
    const ViewArguments& view_;
    const FrameStats* stats_ = nullptr;
};

Settings changed(Settings settings, const std::string& assignment, const char* origin)
{
    assign(fieldTree(settings), parseAssignment(assignment, origin));
    return settings;
}

} // namespace

void run(const BenchCommand& command)
{
    requireWritableJson(command.json);
    TerminalProgress progress;
    const Stage stage = loadStage(command.scene, &progress);
    const Camera camera = chooseCamera(stage.scene, command.view.camera);
    std::vector<std::pair<std::string, Settings>> configurations{{"water", stage.settings}};
    for (const std::string& variant : command.variants)
        configurations.emplace_back(variant, changed(stage.settings, variant, "--vary"));
    configurations.emplace_back("dry", changed(stage.settings, "water.enabled=false", "bench"));

    Session session(stage, command.view.size, &progress);
    std::vector<std::unique_ptr<BenchSubject>> subjects;
    for (const auto& [name, settings] : configurations)
        subjects.push_back(std::make_unique<RenderedSubject>(name, session, settings, camera, command.view));
    BenchReport report =
        runBenchmark(subjects, {.frames = command.frames, .warmUp = command.warmUp}, &progress);
    report.context = {{"renderer", session.context().renderer()},
                      {"OpenGL", session.context().version()},
                      {"scene", stage.scene.file.string()},
                      {"camera", camera.name},
                      {"size", fmt::format("{}x{}", command.view.size.x, command.view.size.y)}};
    writeJson(command.json, toJson(report));
    if (command.json != "-") fmt::print("{}", toTable(report));
}

} // namespace tarn
