// tarn render: pictures of a scene, one, a sequence, or one from each camera.
#include "app/commands.h"
#include "app/output.h"
#include "app/picture_header.h"
#include "app/plan_report.h"
#include "app/render_error.h"
#include "app/session.h"
#include "base/error.h"
#include "base/log.h"

#include <nlohmann/json.hpp>

#include <set>

namespace tarn
{

namespace
{

struct Shot {
    Camera camera;
    double time = 0.0;
    std::filesystem::path file;
};

std::vector<Shot> sequenceShots(const RenderCommand& command, const Scene& scene)
{
    const Camera camera = chooseCamera(scene, command.view.camera);
    std::vector<Shot> shots;
    for (const std::filesystem::path& file : sequenceFiles(command.out, command.frames))
        shots.push_back({camera, command.view.time + static_cast<double>(shots.size()) / command.fps, file});
    return shots;
}

std::vector<Shot> cameraShots(const RenderCommand& command, const Scene& scene)
{
    std::vector<Shot> shots;
    std::set<std::string> taken;
    for (const Camera& named : scene.cameras) {
        CameraArguments arguments = command.view.camera;
        arguments.name = named.name;
        const std::string stem = fileNameFrom(named.name);
        std::string name = stem;
        for (int i = 2; !taken.insert(name).second; ++i)
            name = fmt::format("{}-{}", stem, i);
        shots.push_back({chooseCamera(scene, arguments), command.view.time,
                         std::filesystem::path(command.out) / (name + ".png")});
    }
    return shots;
}

/// All that can be said before the scene is loaded.
void requireWritable(const RenderCommand& command)
{
    requireWritableJson(command.json);
    if (command.allCameras) {
        requireWritableFolder(command.out);
    } else {
        requireWritablePicture(sequenceFiles(command.out, command.frames).front());
    }
}

std::map<std::string, std::string> metadata(const RenderCommand& command, const Stage& stage,
                                            const Shot& shot)
{
    std::map<std::string, std::string> header = pictureHeader(stage, shot.camera, shot.time);
    header["tarn:view"] = debugViewNames[static_cast<std::size_t>(command.debugView)];
    return header;
}

void requireClean(const Renderer& renderer, const Shot& shot)
{
    for (const BadPixels& bad : renderer.badPixels())
        if (bad.any())
            throw Error("{}: pass {} made {} NaN, {} infinite and {} negative values (camera {}, time {} s)",
                        shot.file.string(), bad.pass, bad.nan, bad.infinite, bad.negative, shot.camera.name,
                        shot.time);
    if (gl::debugErrorCount() > 0)
        throw Error("{}: OpenGL reported: {}", shot.file.string(), gl::lastDebugError());
}

void writePicture(const Renderer& renderer, const Shot& shot,
                  const std::map<std::string, std::string>& header)
{
    const bool linear = shot.file.extension() == ".exr";
    writeImage(shot.file, linear ? renderer.readLinear() : renderer.readDisplay(), header);
}

nlohmann::json statsJson(const FrameStats& stats, const Shot& shot)
{
    nlohmann::json json{{"file", shot.file.string()},
                        {"camera", shot.camera.name},
                        {"time", shot.time},
                        {"triangles", stats.triangles()},
                        {"plan", toJson(stats.plan)}};
    for (const FrameStats::Pass& pass : stats.passes)
        json["passes"].push_back(
            {{"name", pass.name}, {"triangles", pass.triangles}, {"draw_calls", pass.drawCalls}});
    return json;
}

} // namespace

void run(const RenderCommand& command)
{
    requireWritable(command);
    if (command.error) return renderError(command);
    TerminalProgress progress;
    const Stage stage = loadStage(command.scene, &progress);
    const std::vector<Shot> shots =
        command.allCameras ? cameraShots(command, stage.scene) : sequenceShots(command, stage.scene);
    Session session(stage, command.view.size, &progress);
    Renderer& renderer = session.renderer();
    renderer.setChecking(command.check);

    nlohmann::json json{{"renderer", session.context().renderer()},
                        {"scene", stage.scene.file.string()},
                        {"size", {command.view.size.x, command.view.size.y}},
                        {"settings", nlohmann::json::parse(settingsJson(stage.settings))},
                        {"frames", nlohmann::json::array()}};
    for (std::size_t i = 0; i < shots.size(); ++i) {
        const Shot& shot = shots[i];
        progress.report(static_cast<double>(i) / static_cast<double>(shots.size()),
                        "rendering " + shot.file.filename().string());
        const FrameStats& stats =
            renderer.render({shot.camera, shot.time, command.view.size, command.debugView});
        if (command.check) requireClean(renderer, shot);
        writePicture(renderer, shot, metadata(command, stage, shot));
        json["frames"].push_back(statsJson(stats, shot));
    }
    writeJson(command.json, json);
    if (command.json != "-")
        for (const Shot& shot : shots)
            fmt::print("{}\n", shot.file.string());
}

} // namespace tarn
