// tarn render: pictures of a scene, one, a sequence, or one from each camera.
#include "app/commands.h"
#include "app/output.h"
#include "app/picture_header.h"
#include "app/plan_report.h"
#include "app/render_error.h"
#include "app/session.h"
#include "app/stereo_files.h"
#include "base/error.h"
#include "base/log.h"

#include <nlohmann/json.hpp>

#include <set>

namespace tarn {

namespace {

struct Shot {
    Camera camera;
    double time = 0.0;
    std::filesystem::path file; ///< with stereo.output = pair, what both files' names are made from
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
        for (int i = 2; !taken.insert(name).second; ++i) name = fmt::format("{}-{}", stem, i);
        shots.push_back(
            {chooseCamera(scene, arguments), command.view.time, std::filesystem::path(command.out) / (name + ".png")});
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

/// An anaglyph is refused here, before any work.
void requireRadiance(const Settings& settings, const Shot& shot)
{
    if (settings.options.stereo.output == StereoOptions::Output::anaglyph && shot.file.extension() == ".exr")
        throw Error(
            "{}: an anaglyph is made of what a display shows; write a .png, or set stereo.output=side_by_side or "
            "pair",
            shot.file.string());
}

void requireClean(const Renderer& renderer, const Shot& shot)
{
    for (const BadPixels& bad : renderer.badPixels())
        if (bad.any())
            throw Error("{}: pass {} made {} NaN, {} infinite and {} negative values (camera {}, time {} s)",
                        shot.file.string(), bad.pass, bad.nan, bad.infinite, bad.negative, shot.camera.name, shot.time);
    if (gl::debugErrorCount() > 0) throw Error("{}: OpenGL reported: {}", shot.file.string(), gl::lastDebugError());
}

/// What a picture's header says of the view it shows.
std::map<std::string, std::string> metadata(const RenderCommand& command, const SceneSetup& sceneSetup,
                                            const Camera& camera, double time)
{
    std::map<std::string, std::string> header = pictureHeader(sceneSetup, camera, time);
    header["tarn:view"] = debugViewNames[static_cast<std::size_t>(command.debugView)];
    return header;
}

/// Returns the names of the files.
std::vector<std::filesystem::path> writePictures(const Renderer& renderer, const RenderCommand& command,
                                                 const SceneSetup& sceneSetup, const Shot& shot)
{
    const bool linear = shot.file.extension() == ".exr";
    const Image image = linear ? renderer.readLinear() : renderer.readDisplay();
    const StereoOptions& stereo = sceneSetup.settings.options.stereo;
    if (stereo.output != StereoOptions::Output::pair) {
        writeImage(shot.file, image, metadata(command, sceneSetup, shot.camera, shot.time));
        return {shot.file};
    }
    std::vector<std::filesystem::path> files;
    for (const Eye eye : bothEyes) {
        auto header = metadata(command, sceneSetup, eyeCamera(shot.camera, stereo, eye), shot.time);
        header["tarn:eye"] = eyeName(eye);
        files.push_back(eyeFile(shot.file, eye));
        writeImage(files.back(), eyeHalf(image, eye), header);
    }
    return files;
}

nlohmann::json reportJson(const FrameReport& report, const Shot& shot, const std::vector<std::filesystem::path>& files)
{
    std::vector<std::string> names;
    for (const std::filesystem::path& file : files) names.push_back(file.string());
    nlohmann::json json{{"file", names.front()},           {"files", names},
                        {"camera", shot.camera.name},      {"time", shot.time},
                        {"triangles", report.triangles()}, {"passes", nlohmann::json::array()},
                        {"plan", toJson(report)}};
    for (const FrameReport::Pass& pass : report.passes)
        json["passes"].push_back({{"name", pass.name}, {"triangles", pass.triangles}, {"draw_calls", pass.drawCalls}});
    return json;
}

} // namespace

void run(const RenderCommand& command)
{
    requireWritable(command);
    if (command.error) return renderError(command);
    TerminalProgress progress;
    const SceneSetup sceneSetup = loadSceneSetup(command.scene, &progress);
    const std::vector<Shot> shots =
        command.allCameras ? cameraShots(command, sceneSetup.scene) : sequenceShots(command, sceneSetup.scene);
    for (const Shot& shot : shots) requireRadiance(sceneSetup.settings, shot);
    Session session(sceneSetup, presentedSize(command.view.size, sceneSetup.settings.options.stereo.output), &progress);
    Renderer& renderer = session.renderer();
    renderer.setChecking(command.check);

    nlohmann::json json{{"renderer", session.context().renderer()},
                        {"scene", sceneSetup.scene.file.string()},
                        {"size", {command.view.size.x, command.view.size.y}},
                        {"settings", nlohmann::json::parse(settingsJson(sceneSetup.settings))},
                        {"frames", nlohmann::json::array()}};
    std::vector<std::filesystem::path> written;
    for (std::size_t i = 0; i < shots.size(); ++i) {
        const Shot& shot = shots[i];
        progress.report(static_cast<double>(i) / static_cast<double>(shots.size()),
                        "rendering " + shot.file.filename().string());
        const FrameReport& report = renderer.render({shot.camera, shot.time, command.view.size, command.debugView});
        if (command.check) requireClean(renderer, shot);
        const auto files = writePictures(renderer, command, sceneSetup, shot);
        json["frames"].push_back(reportJson(report, shot, files));
        written.insert(written.end(), files.begin(), files.end());
    }
    writeJson(command.json, json);
    if (command.json != "-")
        for (const std::filesystem::path& file : written) fmt::print("{}\n", file.string());
}

} // namespace tarn
