#include "app/render_error.h"

#include "app/commands.h"
#include "app/picture_header.h"
#include "app/reference_view.h"
#include "app/session.h"
#include "base/error.h"
#include "base/log.h"
#include "measure/error_map.h"
#include "measure/heat.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace tarn {

namespace {

/// The reference's view, in which the command line may replace parts at its own risk.
ReferenceView viewOf(const RenderCommand& command, const reference::Picture& truth, const SceneSetup& sceneSetup)
{
    const std::string file = command.reference.string();
    if (command.view.sizeGiven && command.view.size != truth.size)
        throw Error("--size {}x{}: {} has {}x{} pixels; leave --size away", command.view.size.x, command.view.size.y,
                    file, truth.size.x, truth.size.y);
    ReferenceView view = referenceView(truth, sceneSetup.scene, command.reference);
    requireSameScene(truth, sceneSetup, command.reference);
    if (command.view.camera.isGiven()) {
        const Camera asked = chooseCamera(sceneSetup.scene, command.view.camera);
        if (!isSameView(asked, view.camera)) log::warning("{}: was seen by another camera", file);
        view.camera = asked;
    }
    if (command.view.timeGiven) {
        if (std::abs(command.view.time - view.time) > 1e-6) log::warning("{}: shows the time {} s", file, view.time);
        view.time = command.view.time;
    }
    return view;
}

void writeMap(const RenderCommand& command, const Image& map, double scale, std::map<std::string, std::string> header)
{
    const ErrorKindInfo& kind = infoOf(*command.error);
    header["tarn:error"] = kind.name;
    header["tarn:error-unit"] = kind.unit;
    header["tarn:error-scale"] = fmt::format("{}", scale);
    header["tarn:reference"] = command.reference.filename().string();
    const std::filesystem::path out = command.out;
    if (out.extension() == ".exr")
        writeImage(out, map, header, {"Y"});
    else
        writeImage(out, heatPicture(map, 0.0, scale), header);
}

nlohmann::json figuresJson(const ErrorFigures& figures)
{
    nlohmann::json json;
    for (const FigureField& field : errorFigureFields()) {
        const double value = figures.*field.member;
        json[field.name] = std::isnan(value) ? nlohmann::json(nullptr) : nlohmann::json(value);
    }
    return json;
}

/// Only what was measured.
void printFigures(const ErrorFigures& figures)
{
    for (const FigureField& field : errorFigureFields())
        if (const double value = figures.*field.member; !std::isnan(value))
            fmt::print("  {:<24}{:>12.5g} {:<4} {}\n", field.name, value, field.unit, field.doc);
}

} // namespace

void renderError(const RenderCommand& command)
{
    const reference::Picture truth = reference::readPicture(command.reference);
    TerminalProgress progress;
    const SceneSetup sceneSetup = loadSceneSetup(command.scene, &progress);
    requireOneEye(sceneSetup.settings, "errors are measured in one eye's picture");
    const ReferenceView view = viewOf(command, truth, sceneSetup);
    Session session(sceneSetup, truth.size, &progress);
    session.renderer().setChecking(command.check);
    const WaterQuantities used = readQuantities(session.renderer(), view.camera, view.time, truth.size);
    for (const BadPixels& bad : session.renderer().badPixels())
        throw Error("{}: pass {} made {} NaN, {} infinite and {} negative values", command.out, bad.pass, bad.nan,
                    bad.infinite, bad.negative);

    const ErrorKindInfo& kind = infoOf(*command.error);
    const double scale = command.errorScale > 0.0 ? command.errorScale : kind.scale;
    writeMap(command, errorMap(*command.error, used, truth), scale, pictureHeader(sceneSetup, view.camera, view.time));
    const ErrorFigures figures = errorFigures(used, truth);
    const WaterAgreement agreement = waterAgreement(used, truth);
    writeJson(command.json,
              {{"file", command.out},
               {"reference", command.reference.string()},
               {"scene", sceneSetup.scene.file.string()},
               {"camera", view.camera.name},
               {"time", view.time},
               {"size", {truth.size.x, truth.size.y}},
               {"error", kind.name},
               {"scale", scale},
               {"unit", kind.unit},
               {"figures", figuresJson(figures)},
               {"water_pixels",
                {{"both", agreement.both}, {"only_here", agreement.onlyUsed}, {"only_reference", agreement.onlyTruth}}},
               {"settings", nlohmann::json::parse(settingsJson(sceneSetup.settings))}});
    if (command.json == "-") return;
    fmt::print("{}\n  error {} {}\n  full colour at {:g}{}{}; grey: not known\n", command.out, kind.name, kind.doc,
               scale, *kind.unit ? " " : "", kind.unit);
    fmt::print("  water in {} pixels, in {} only here, in {} only in the reference\n", agreement.both,
               agreement.onlyUsed, agreement.onlyTruth);
    printFigures(figures);
}

} // namespace tarn
