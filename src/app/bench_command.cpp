// tarn bench: what the frame costs with the water, without it, and with any option changed; or a table of the
// thesis, measured here.
#include "app/commands.h"
#include "app/session.h"
#include "base/error.h"
#include "measure/benchmark.h"
#include "measure/paper_tables.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <thread>

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

/// Draws a frame before each that counts: the row before had targets of another size, and making them anew is
/// no part of this one's cost.
class TableSubject : public RenderedSubject
{
public:
    using RenderedSubject::RenderedSubject;
    void prepare(int index) override { draw(index); }
};

/// The processor, which is the renderer as well where OpenGL is drawn in software.
std::string machineText()
{
    const unsigned int threads = std::thread::hardware_concurrency();
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (const auto colon = line.find(": "); line.starts_with("model name") && colon != std::string::npos)
            return fmt::format("{}, {} threads", line.substr(colon + 2), threads);
    return fmt::format("{} threads", threads);
}

Settings changed(Settings settings, const std::string& assignment, const char* origin)
{
    assign(fieldTree(settings), parseAssignment(assignment, origin));
    return settings;
}

using Configuration = std::pair<std::string, Settings>;

std::vector<Configuration> configurationsOf(const BenchCommand& command, const Settings& settings)
{
    std::vector<Configuration> configurations;
    if (command.table) {
        const std::string origin = fmt::format("--table {}", command.table->number);
        for (const PaperRow& row : command.table->rows) {
            Settings rowSettings = settings;
            for (const std::string& assignment : row.assignments)
                rowSettings = changed(std::move(rowSettings), assignment, origin.c_str());
            configurations.emplace_back(row.name, std::move(rowSettings));
        }
        return configurations;
    }
    configurations.emplace_back("water", settings);
    for (const std::string& variant : command.variants)
        configurations.emplace_back(variant, changed(settings, variant, "--vary"));
    configurations.emplace_back("dry", changed(settings, "water.enabled=false", "bench"));
    return configurations;
}

} // namespace

void run(const BenchCommand& command)
{
    requireWritableJson(command.json);
    TerminalProgress progress;
    const Stage stage = loadStage(command.scene, &progress);
    const Camera camera = chooseCamera(stage.scene, command.view.camera);
    const std::vector<Configuration> configurations = configurationsOf(command, stage.settings);

    Session session(stage, command.view.size, &progress);
    std::vector<std::unique_ptr<BenchSubject>> subjects;
    for (const auto& [name, settings] : configurations) {
        if (command.table)
            subjects.push_back(std::make_unique<TableSubject>(name, session, settings, camera, command.view));
        else
            subjects.push_back(
                std::make_unique<RenderedSubject>(name, session, settings, camera, command.view));
    }
    BenchReport report =
        runBenchmark(subjects, {.frames = command.frames, .warmUp = command.warmUp}, &progress);
    report.context = {{"machine", machineText()},
                      {"renderer", session.context().renderer()},
                      {"OpenGL", session.context().version()},
                      {"scene", stage.scene.file.string()},
                      {"camera", camera.name},
                      {"size", fmt::format("{}x{}", command.view.size.x, command.view.size.y)}};
    writeJson(command.json, command.table ? toJson(*command.table, report) : toJson(report));
    if (command.json != "-")
        fmt::print("{}", command.table ? toMarkdown(*command.table, report) : toTable(report));
}

} // namespace tarn
