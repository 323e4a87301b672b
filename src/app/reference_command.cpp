// tarn reference: ground truth by ray tracing.
#include "app/commands.h"
#include "app/interrupt.h"
#include "app/output.h"
#include "app/picture_header.h"
#include "app/reference_view.h"
#include "app/stage.h"
#include "base/error.h"
#include "reference/reference.h"

#include <nlohmann/json.hpp>

namespace tarn
{

namespace
{

/// Beside the picture, so that it is found again by whoever asks for the same picture.
std::filesystem::path unfinishedFile(const std::filesystem::path& out)
{
    std::filesystem::path file = out;
    return file.replace_extension(".unfinished.exr");
}

nlohmann::json reportJson(const ReferenceCommand& command, const Stage& stage, const Camera& camera,
                          const reference::TraceReport& report)
{
    return {{"file", command.out},
            {"scene", stage.scene.file.string()},
            {"camera", camera.name},
            {"time", command.view.time},
            {"size", {command.view.size.x, command.view.size.y}},
            {"samples", command.reference.samples},
            {"depth", command.reference.depth},
            {"bounces", command.reference.bounces},
            {"seed", command.reference.seed},
            {"seconds", report.seconds},
            {"radiance_noise", report.radianceNoise},
            {"truncated_share", report.truncatedShare},
            {"photons", report.photons},
            {"caustics_noise", report.causticsNoise},
            {"lost_photons", report.lostPhotons}};
}

} // namespace

void run(const ReferenceCommand& command)
{
    requireWritablePicture(command.out);
    requireWritableJson(command.json);
    TerminalProgress progress;
    Stage stage = loadStage(command.scene, &progress);
    if (!stage.settings.options.water.enabled) stage.settings.water.present = false;
    const Camera camera = chooseCamera(stage.scene, command.view.camera);

    const reference::Tracer tracer(stage.scene, stage.settings.water, stage.settings.options.water.sunRoughness);
    const reference::ViewRequest view{.camera = camera, .time = command.view.time, .size = command.view.size, .approximations = {}};
    const std::filesystem::path unfinished = unfinishedFile(command.out);
    InterruptGuard guard;
    reference::TraceReport report;
    reference::Picture picture;
    try {
        picture = tracer.render(view, command.reference, &progress,
                                {.file = unfinished, .everySeconds = 30.0, .interrupt = &InterruptGuard::flag()},
                                &report);
    } catch (const reference::Interrupted&) {
        throw Error("interrupted; {} keeps what is done, the same command goes on from there", unfinished.string());
    }
    picture.metadata.merge(pictureHeader(stage, camera, command.view.time));
    const std::filesystem::path out = command.out;
    if (out.extension() == ".exr") reference::writePicture(out, picture);
    else writeImage(out, displayPicture(picture, stage.settings.options.frame), picture.metadata);
    std::error_code ignored; // there is none when the work was short
    std::filesystem::remove(unfinished, ignored);

    writeJson(command.json, reportJson(command, stage, camera, report));
    if (command.json == "-") return;
    fmt::print("{}\n  {} samples, noise {:.2g} of the mean luminance; not followed beyond {} meetings with the water: "
               "at most {:.2g} of the light\n",
               command.out, command.reference.samples, report.radianceNoise, command.reference.depth,
               report.truncatedShare);
    if (report.photons > 0)
        fmt::print("  {} photons, noise {:.2g} of the mean irradiance; {:.2g} of them met no bed\n", report.photons,
                   report.causticsNoise, report.lostPhotons);
}

} // namespace tarn
