// tarn render: pictures of a scene, one, a sequence, or one from each camera.
#include "app/command_flags.h"
#include "app/commands.h"
#include "app/output.h"
#include "app/picture_header.h"
#include "app/plan_report.h"
#include "app/render_error.h"
#include "app/session.h"
#include "app/stereo_files.h"
#include "base/error.h"
#include "base/log.h"

#include <fmt/format.h>
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

namespace {

DebugView parseDebugView(const std::string& text, const std::string& flag)
{
    if (const auto view = debugViewFromName(text)) return *view;
    const std::vector<std::string> names(debugViewNames.begin(), debugViewNames.end());
    throw UsageError("{} {}: no such view; there are {}", flag, text, fmt::join(names, ", "));
}

ErrorKind parseErrorKind(const std::string& text, const std::string& flag)
{
    std::vector<std::string> names;
    for (std::size_t i = 0; i < errorKinds.size(); ++i) {
        if (text == errorKinds[i].name) return static_cast<ErrorKind>(i);
        names.emplace_back(errorKinds[i].name);
    }
    throw UsageError("{} {}: no such error; there are {}", flag, text, fmt::join(names, ", "));
}

void addErrorMap(Flags& flags, RenderCommand& c)
{
    flags.value("--error", "KIND",
                "A map of what the water has wrong: refraction, reflection, fresnel, path or caustics",
                [&c](const std::string& text, const std::string& flag) { c.error = parseErrorKind(text, flag); });
    flags.path("--reference", "FILE", "What --error compares with; gives camera, time and size", c.reference);
    flags.number("--error-scale", "X", "Error that --error shows in full colour, in m, degrees or as a fraction",
                 c.errorScale, 1e-9, 1e9);
}

void requireMeaning(const RenderCommand& c)
{
    if (!c.error && !c.reference.empty())
        throw UsageError("--reference is for --error; name one, such as --error path");
    if (!c.error && c.errorScale > 0.0)
        throw UsageError("--error-scale is for --error; name one, such as --error path");
    if (!c.error) return;
    if (c.reference.empty())
        throw UsageError("--error needs --reference FILE; make one with: tarn reference --out truth.exr");
    if (c.frames > 1 || c.allCameras || c.debugView != DebugView::final)
        throw UsageError("--error makes one map; leave --frames, --all-cameras and --view away");
}

} // namespace

MakeCommand defineRender(Flags& flags)
{
    auto command = std::make_shared<RenderCommand>();
    RenderCommand& c = *command;
    c.view.size = {1024, 768};
    addSceneFlags(flags, c.scene);
    addViewFlags(flags, c.view);
    const std::string views = fmt::format("Show an intermediate picture: {}",
                                          fmt::join(debugViewNames.begin() + 1, debugViewNames.end(), ", "));
    flags.value("--view", "NAME", views.c_str(),
                [&c](const std::string& text, const std::string& flag) { c.debugView = parseDebugView(text, flag); });
    flags.text("--out", "FILE", "Picture: .png tone-mapped, .exr linear; name_%04d.png for a sequence", c.out);
    flags.count("--frames", "Pictures in the sequence", c.frames, 1, 1000000);
    flags.number("--fps", "F", "Pictures per second of the sequence", c.fps, 1e-3, 1e4);
    flags.toggle("--all-cameras", "A picture from each camera; --out names their folder", c.allCameras);
    flags.toggle("--check", "Fail when a pass makes NaN, infinity or negative radiance", c.check);
    addErrorMap(flags, c);
    flags.json(c.json);
    return [command]() -> Command {
        if (command->out.empty()) throw UsageError("render needs --out FILE, such as --out lake.png");
        if (command->allCameras && command->frames > 1)
            throw UsageError("--all-cameras makes one picture each; leave --frames away");
        if (command->allCameras && !command->view.camera.name.empty())
            throw UsageError("--all-cameras renders every camera; leave --camera away");
        requireMeaning(*command);
        return *command;
    };
}

} // namespace tarn
