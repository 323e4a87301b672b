// tarn reference: ground truth by ray tracing.
#include "app/command_flags.h"
#include "app/commands.h"
#include "app/interrupt.h"
#include "app/output.h"
#include "app/picture_header.h"
#include "app/reference_view.h"
#include "app/scene_setup.h"
#include "app/stereo_files.h"
#include "base/error.h"
#include "reference/reference.h"

#include <nlohmann/json.hpp>

#include <optional>

namespace tarn {

namespace {

/// Beside the picture, so that it is found again by whoever asks for the same picture.
std::filesystem::path unfinishedFile(const std::filesystem::path& out)
{
    std::filesystem::path file = out;
    return file.replace_extension(".unfinished.exr");
}

/// One picture that was asked for: a view of the scene, or one eye's.
struct Shot {
    Camera camera;
    std::filesystem::path out;
    std::optional<Eye> eye;
};

/// One, or two with stereo.output = pair. A reference holds what one eye's rays meet: both in one picture are refused.
std::vector<Shot> shotsOf(const ReferenceCommand& command, const Camera& camera, const StereoOptions& stereo)
{
    switch (stereo.output) {
    case StereoOptions::Output::off: return {{camera, command.out, std::nullopt}};
    case StereoOptions::Output::pair: break;
    case StereoOptions::Output::sideBySide:
    case StereoOptions::Output::anaglyph:
        throw Error("{}: a reference holds what one eye sees; set stereo.output=pair for two, or off", command.out);
    }
    std::vector<Shot> shots;
    for (const Eye eye : bothEyes) shots.push_back({eyeCamera(camera, stereo, eye), eyeFile(command.out, eye), eye});
    return shots;
}

reference::Picture trace(const reference::Tracer& tracer, const ReferenceCommand& command, const Shot& shot,
                         Progress& progress, reference::TraceReport& report)
{
    const std::filesystem::path unfinished = unfinishedFile(shot.out);
    try {
        return tracer.render(
            {.camera = shot.camera, .time = command.view.time, .size = command.view.size, .approximations = {}},
            command.reference, &progress,
            {.file = unfinished, .everySeconds = 30.0, .interrupt = &InterruptGuard::flag()}, &report);
    } catch (const reference::Interrupted&) {
        throw Error("interrupted; {} keeps what is done, the same command goes on from there", unfinished.string());
    }
}

void write(const SceneSetup& sceneSetup, const ReferenceCommand& command, const Shot& shot, reference::Picture& picture)
{
    picture.metadata.merge(pictureHeader(sceneSetup, shot.camera, command.view.time));
    if (shot.eye) picture.metadata["tarn:eye"] = eyeName(*shot.eye);
    if (shot.out.extension() == ".exr")
        reference::writePicture(shot.out, picture);
    else
        writeImage(shot.out, displayPicture(picture, sceneSetup.settings.options.frame), picture.metadata);
    std::error_code ignored; // there is none when the work was short
    std::filesystem::remove(unfinishedFile(shot.out), ignored);
}

nlohmann::json reportJson(const ReferenceCommand& command, const SceneSetup& sceneSetup, const Shot& shot,
                          const reference::TraceReport& report)
{
    nlohmann::json json{{"file", shot.out.string()},
                        {"scene", sceneSetup.scene.file.string()},
                        {"camera", shot.camera.name},
                        {"time", command.view.time},
                        {"size", {command.view.size.x, command.view.size.y}},
                        {"samples", command.reference.samples},
                        {"depth", command.reference.depth},
                        {"bounces", command.reference.bounces},
                        {"seed", command.reference.seed},
                        {"seconds", report.seconds},
                        {"radiance_noise", report.radianceNoise},
                        {"truncated_fraction", report.truncatedFraction},
                        {"photons", report.photons},
                        {"caustics_noise", report.causticsNoise},
                        {"lost_photons", report.lostPhotons}};
    if (shot.eye) json["eye"] = eyeName(*shot.eye);
    return json;
}

void print(const ReferenceCommand& command, const Shot& shot, const reference::TraceReport& report)
{
    fmt::print("{}\n  {} samples, noise {:.2g} of the mean luminance; not followed beyond {} meetings with the water: "
               "at most {:.2g} of the light\n",
               shot.out.string(), command.reference.samples, report.radianceNoise, command.reference.depth,
               report.truncatedFraction);
    if (report.photons > 0)
        fmt::print("  {} photons, noise {:.2g} of the mean irradiance; {:.2g} of them met no bed\n", report.photons,
                   report.causticsNoise, report.lostPhotons);
}

} // namespace

void run(const ReferenceCommand& command)
{
    requireWritablePicture(command.out);
    requireWritableJson(command.json);
    TerminalProgress progress;
    SceneSetup sceneSetup = loadSceneSetup(command.scene, &progress);
    if (!sceneSetup.settings.options.water.enabled) sceneSetup.settings.water.present = false;
    const std::vector<Shot> shots =
        shotsOf(command, chooseCamera(sceneSetup.scene, command.view.camera), sceneSetup.settings.options.stereo);

    const reference::Tracer tracer(sceneSetup.scene, sceneSetup.settings.water,
                                   sceneSetup.settings.options.water.sunSlopeDeviation);
    InterruptGuard guard;
    std::vector<reference::TraceReport> reports;
    for (const Shot& shot : shots) {
        reference::Picture picture = trace(tracer, command, shot, progress, reports.emplace_back());
        write(sceneSetup, command, shot, picture);
    }

    nlohmann::json json = nlohmann::json::array();
    for (std::size_t i = 0; i < shots.size(); ++i) {
        json.push_back(reportJson(command, sceneSetup, shots[i], reports[i]));
        if (command.json != "-") print(command, shots[i], reports[i]);
    }
    writeJson(command.json, shots.size() == 1 ? json.front() : json);
}

MakeCommand defineReference(Flags& flags)
{
    auto command = std::make_shared<ReferenceCommand>();
    ReferenceCommand& c = *command;
    c.view.size = {640, 480};
    addSceneFlags(flags, c.scene);
    addViewFlags(flags, c.view);
    flags.text("--out", "FILE", "Picture: .exr with every channel, .png as it would be shown", c.out);
    flags.count("--samples", "Paths through each pixel", c.reference.samples, 1, 65536);
    flags.count("--depth", "Meetings with the water's surface that a path follows", c.reference.depth, 1, 16);
    flags.count("--bounces", "Diffuse reflections of light between bed, objects and surface", c.reference.bounces, 0,
                64);
    flags.count("--photons", "Photons that find the sun's light under water", c.reference.photons, 10'000,
                2'000'000'000);
    flags.count("--seed", "Of all random numbers", c.reference.seed, 0, 2'000'000'000);
    auto half = std::make_shared<bool>(false);
    flags.toggle("--half", "Half the size, a quarter of the samples and photons: a quick look", *half);
    flags.json(c.json);
    return [command, half]() -> Command {
        if (command->out.empty()) throw UsageError("reference needs --out FILE, such as --out truth.exr");
        ReferenceCommand result = *command;
        if (*half) {
            result.view.size = glm::max(result.view.size / 2, ivec2(1));
            result.reference.samples = std::max(result.reference.samples / 4, 1);
            result.reference.photons = std::max(result.reference.photons / 4, 10'000);
        }
        return result;
    };
}

} // namespace tarn
