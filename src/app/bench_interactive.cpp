// tarn bench --interactive: frames and the delay from input to picture on a recorded flight.
#include "app/bench_interactive.h"

#include "app/machine.h"
#include "app/recorded_flight.h"
#include "app/session.h"
#include "measure/benchmark.h"
#include "measure/interactive.h"
#include "render/warm_up.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>

namespace tarn {

namespace {

double steadySeconds()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// A frame from each camera: textures, targets and programs are then where they will be needed.
void drawEachCamera(Session& session, const std::vector<Camera>& cameras, const ViewArguments& view)
{
    for (const Camera& camera : cameras) {
        session.renderer().render({camera, view.time, view.size});
        finishGpu();
    }
}

} // namespace

void runInteractive(const BenchCommand& command)
{
    requireWritableJson(command.json);
    TerminalProgress progress;
    const SceneSetup sceneSetup = loadSceneSetup(command.scene, &progress);
    const std::vector<Camera>& cameras = sceneSetup.scene.cameras;
    Session session(sceneSetup, command.view.size, &progress);
    warmUp(session.renderer(), sceneSetup.settings.water, &progress);
    drawEachCamera(session, cameras, command.view);

    const std::vector<RecordedInput> inputs = recordFlight(cameras.size(), command.seconds);
    std::vector<double> due;
    for (const RecordedInput& input : inputs) due.push_back(input.due);
    RecordedPilot pilot(cameras);
    const auto draw = [&](const InteractiveFrame& frame) {
        progress.report(frame.time / command.seconds, "flying");
        pilot.take(std::span(inputs).subspan(frame.firstInput, frame.inputCount), frame.time);
        session.renderer().render({pilot.camera(), command.view.time + frame.time, command.view.size});
        finishGpu();
    };
    const double cpuStart = processCpuSeconds();
    const InteractiveTimes times = playInputs(due, steadySeconds, draw);
    const double cpuMs = 1e3 * (processCpuSeconds() - cpuStart) / static_cast<double>(times.frameMs.size());

    const BenchContext context = {{"machine", machineText()},
                                  {"renderer", session.context().renderer()},
                                  {"OpenGL", session.context().version()},
                                  {"scene", sceneSetup.scene.file.string()},
                                  {"flight", fmt::format("{} s past {} cameras", command.seconds, cameras.size())},
                                  {"size", fmt::format("{}x{}", command.view.size.x, command.view.size.y)}};
    nlohmann::json json = toJson(times);
    for (const auto& [key, value] : context) json["context"][key] = value;
    json["seconds"] = command.seconds;
    json["cpu_ms_per_frame"] = cpuMs;
    writeJson(command.json, json);
    if (command.json == "-") return;
    for (const auto& [key, value] : context) fmt::print("{:<16}{}\n", key, value);
    fmt::print("\n{}\nprocessor time of a frame, mean: {:.1f} ms\n", toTable(times), cpuMs);
}

} // namespace tarn
