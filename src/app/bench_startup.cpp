// tarn bench --startup: how long a person waits for the scene, the first picture and the full one. The process measures
// itself, as the viewer would go through it, without a window; what a driver's cache of shaders holds is part of the
// answer.
#include "app/commands.h"
#include "app/live_picture.h"
#include "app/machine.h"
#include "app/session.h"
#include "app/spare_memory.h"
#include "app/startup_times.h"
#include "base/memory.h"
#include "gl/context.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <thread>

namespace tarn {

namespace {

/// Wakes the thread that shows pictures.
class Bell {
public:
    void ring()
    {
        const std::lock_guard lock(mutex_);
        rung_ = true;
        changed_.notify_all();
    }
    void wait()
    {
        std::unique_lock lock(mutex_);
        changed_.wait_for(lock, std::chrono::milliseconds(20), [&] { return rung_; });
        rung_ = false;
    }

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    bool rung_ = false;
};

std::string cacheText()
{
    const auto variable = [](const char* name) {
        const char* value = std::getenv(name);
        return std::string(value ? value : "");
    };
    if (const std::string off = variable("MESA_SHADER_CACHE_DISABLE"); !off.empty())
        return "MESA_SHADER_CACHE_DISABLE=" + off;
    const std::string folder = variable("MESA_SHADER_CACHE_DIR");
    return folder.empty() ? "the driver's own" : folder;
}

nlohmann::json toJson(const StartupTimes& times)
{
    nlohmann::json json;
    for (std::size_t i = 0; i < startupEventCount; ++i)
        if (const auto time = times.at(static_cast<StartupEvent>(i)))
            json[startupEvents[i].name] = {{"wall_s", time->wall}, {"processor_s", time->processor}};
    return json;
}

std::string toTable(const StartupTimes& times)
{
    std::string text = fmt::format("{:<36}{:>10}{:>14}\n", "since the process began", "wall s", "processor s");
    std::vector<std::pair<StartupTime, const char*>> rows;
    for (std::size_t i = 0; i < startupEventCount; ++i)
        if (const auto time = times.at(static_cast<StartupEvent>(i))) rows.emplace_back(*time, startupEvents[i].what);
    std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.first.wall < b.first.wall; });
    for (const auto& [time, what] : rows)
        text += fmt::format("  {:<34}{:>10.2f}{:>14.2f}\n", what, time.wall, time.processor);
    return text;
}

/// Until the picture with all settings is there, and then until the programs of all other views are, too.
void showUntilBuilt(LivePicture& picture, const FrameRequest& request, SpareMemory& spare, Bell& bell,
                    Progress& progress)
{
    while (!picture.isBuilt()) {
        if (!picture.isFull()) picture.ask(request);
        bell.wait();
        picture.take();
        spare.release(picture);
        const SharedProgress::State state = picture.progress();
        progress.report(state.fraction, state.what);
    }
    spare.release(picture);
}

} // namespace

void benchStartup(const BenchCommand& command)
{
    TerminalProgress progress;
    const auto context = gl::makeHeadlessContext(command.view.size);
    requireDrawable(command.view.size);
    Bell bell;
    SceneSetup sceneSetup; // outlives what shows it
    LivePicture picture(*context, [&bell] { bell.ring(); });
    picture.times().note(StartupEvent::context);
    sceneSetup = loadSceneSetup(command.scene, &progress);
    const Camera camera = chooseCamera(sceneSetup.scene, command.view.camera);
    picture.show(sceneSetup.scene, sceneSetup.settings);
    SpareMemory spare(sceneSetup.scene);
    showUntilBuilt(picture,
                   {camera, command.view.time, command.view.size, DebugView::final, sceneSetup.settings.options,
                    sceneSetup.settings.water},
                   spare, bell, progress);

    const ProcessMemory memory = processMemory();
    nlohmann::json json{
        {"machine", machineText()},
        {"renderer", context->renderer()},
        {"OpenGL", context->version()},
        {"shader_cache", cacheText()},
        {"scene", sceneSetup.scene.file.string()},
        {"size", fmt::format("{}x{}", command.view.size.x, command.view.size.y)},
        {"events", toJson(picture.times())},
        {"memory", {{"resident_bytes", memory.resident}, {"file_bytes", memory.files}, {"peak_bytes", memory.peak}}}};
    writeJson(command.json, json);
    if (command.json == "-") return;
    fmt::print("{}, shader cache: {}\n", context->renderer(), cacheText());
    fmt::print("{}{} MB of memory ({} of them of mapped files), {} at most\n", toTable(picture.times()),
               memory.resident / 1'000'000, memory.files / 1'000'000, memory.peak / 1'000'000);
}

} // namespace tarn
