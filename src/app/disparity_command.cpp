// tarn disparity: whether both eyes of a drawn pair agree on where things in the water are, as the reference's pair
// does.
#include "app/command_flags.h"
#include "app/commands.h"
#include "app/output.h"
#include "app/picture_header.h"
#include "app/reference_view.h"
#include "app/session.h"
#include "app/stereo_files.h"
#include "base/error.h"
#include "measure/heat.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace tarn {

namespace {

/// One eye's reference, and the view that its header tells.
struct TrueEye {
    reference::Picture picture;
    ReferenceView view;
};

TrueEye readEye(const std::filesystem::path& file, Eye eye, const SceneSetup& sceneSetup)
{
    TrueEye result{reference::readPicture(file), {}};
    const auto made = result.picture.metadata.find("tarn:eye");
    if (made == result.picture.metadata.end() || made->second != eyeName(eye))
        throw Error("{}: is not the {} eye's; make both with: tarn reference --set stereo.output=pair", file.string(),
                    eyeName(eye));
    result.view = referenceView(result.picture, sceneSetup.scene, file);
    requireSameScene(result.picture, sceneSetup, file);
    return result;
}

void requirePair(const DisparityCommand& command, const TrueEye& left, const TrueEye& right)
{
    const std::string name = command.reference.string();
    if (left.picture.size != right.picture.size)
        throw Error("{}: the left eye's picture has {}x{} pixels, the right eye's {}x{}", name, left.picture.size.x,
                    left.picture.size.y, right.picture.size.x, right.picture.size.y);
    if (std::abs(left.view.time - right.view.time) > 1e-6)
        throw Error("{}: the left eye's picture is of {} s, the right eye's of {} s", name, left.view.time,
                    right.view.time);
}

/// Of the pictures that the settings draw for the same eyes, by both ways in which water shows things.
std::array<DisparityErrors, 2> measure(Session& session, const SceneSetup& sceneSetup, const TrueEye& left,
                                       const TrueEye& right)
{
    const auto drawn = [&](const TrueEye& eye) {
        return readQuantities(session.renderer(), eye.view.camera, eye.view.time, eye.picture.size);
    };
    const WaterQuantities usedLeft = drawn(left), usedRight = drawn(right);
    const auto errors = [&](ShownBy way) {
        return disparityErrors(
            {pointsShown(usedLeft, left.view.camera, way), pointsShown(usedRight, right.view.camera, way)},
            {pointsShown(left.picture, left.view.camera, way), pointsShown(right.picture, right.view.camera, way)},
            sceneSetup.settings.water, way);
    };
    return {errors(ShownBy::refraction), errors(ShownBy::reflection)};
}

struct Row {
    const char* name;
    const char* unit;
    const char* doc;
    double DisparityErrors::*member;
};
constexpr std::array rows{
    Row{"median", "px", "Horizontal disparity error, median", &DisparityErrors::median},
    Row{"p95", "px", "Horizontal disparity error, 95th percentile", &DisparityErrors::p95},
    Row{"max", "px", "Horizontal disparity error, maximum", &DisparityErrors::maximum},
    Row{"bias", "px", "Its mean with its sign: over 0 seems too far away", &DisparityErrors::bias},
    Row{"vertical_median", "px", "Vertical disparity error, median", &DisparityErrors::verticalMedian},
    Row{"vertical_p95", "px", "Vertical disparity error, 95th percentile", &DisparityErrors::verticalP95},
    Row{"true_median", "px", "The reference's own horizontal disparity, median", &DisparityErrors::trueMedian},
    Row{"alone", "", "Share of pixels whose point the right eye does not see, drawn", &DisparityErrors::alone},
    Row{"alone_in_reference", "", "The same in the reference", &DisparityErrors::aloneInTruth},
};

nlohmann::json toJson(const DisparityErrors& errors)
{
    nlohmann::json json{{"pixels", errors.pixels}, {"compared", errors.compared}};
    for (const Row& row : rows) {
        const double value = errors.*row.member;
        json[row.name] = std::isnan(value) ? nlohmann::json(nullptr) : nlohmann::json(value);
    }
    return json;
}

void print(ShownBy way, const DisparityErrors& errors)
{
    fmt::print("  {}: {} pixels of the left picture, {} of them compared\n",
               shownByNames[static_cast<std::size_t>(way)], errors.pixels, errors.compared);
    for (const Row& row : rows)
        if (const double value = errors.*row.member; !std::isnan(value))
            fmt::print("    {:<20}{:>12.5g} {:<4} {}\n", row.name, value, row.unit, row.doc);
}

void writeMap(const DisparityCommand& command, const Image& map, std::map<std::string, std::string> header)
{
    if (command.out.empty()) return;
    header["tarn:error"] = "disparity";
    header["tarn:error-unit"] = "px";
    header["tarn:error-scale"] = fmt::format("{}", command.scale);
    if (command.out.extension() == ".exr")
        writeImage(command.out, map, header, {"Y"});
    else
        writeImage(command.out, heatPicture(map, 0.0, command.scale), header);
}

} // namespace

void run(const DisparityCommand& command)
{
    if (!command.out.empty()) requireWritablePicture(command.out);
    requireWritableJson(command.json);
    TerminalProgress progress;
    const SceneSetup sceneSetup = loadSceneSetup(command.scene, &progress);
    requireOneEye(sceneSetup.settings, "the eyes are the reference's");
    const TrueEye left = readEye(eyeFile(command.reference, Eye::left), Eye::left, sceneSetup);
    const TrueEye right = readEye(eyeFile(command.reference, Eye::right), Eye::right, sceneSetup);
    requirePair(command, left, right);
    Session session(sceneSetup, left.picture.size, &progress);
    const auto errors = measure(session, sceneSetup, left, right);

    writeMap(command, errors[static_cast<std::size_t>(command.mapped)].map,
             pictureHeader(sceneSetup, left.view.camera, left.view.time));
    nlohmann::json json{{"reference", command.reference.string()},
                        {"scene", sceneSetup.scene.file.string()},
                        {"camera", left.view.camera.name},
                        {"time", left.view.time},
                        {"size", {left.picture.size.x, left.picture.size.y}},
                        {"settings", nlohmann::json::parse(settingsJson(sceneSetup.settings))}};
    for (std::size_t way = 0; way < errors.size(); ++way) json[shownByNames[way]] = toJson(errors[way]);
    writeJson(command.json, json);
    if (command.json == "-") return;
    fmt::print("{} at {} s, {}x{} pixels an eye\n", left.view.camera.name, left.view.time, left.picture.size.x,
               left.picture.size.y);
    for (std::size_t way = 0; way < errors.size(); ++way) print(static_cast<ShownBy>(way), errors[way]);
}

MakeCommand defineDisparity(Flags& flags)
{
    auto command = std::make_shared<DisparityCommand>();
    DisparityCommand& c = *command;
    addSceneFlags(flags, c.scene);
    flags.path("--reference", "FILE", "NAME.exr, for the pair NAME-left.exr and NAME-right.exr of tarn reference",
               c.reference);
    flags.path("--out", "FILE", "Map of the error over the left picture: .png as colours, .exr as pixels", c.out);
    flags.value("--of", "WAY", "What the map shows: refraction (by default) or reflection",
                [&c](const std::string& text, const std::string& flag) {
                    const auto found = std::find(shownByNames.begin(), shownByNames.end(), text);
                    if (found == shownByNames.end())
                        throw UsageError("{} {}: no such way; there are {}", flag, text, fmt::join(shownByNames, ", "));
                    c.mapped = static_cast<ShownBy>(found - shownByNames.begin());
                });
    flags.number("--scale", "PX", "Error that the map shows in full colour, pixels", c.scale, 1e-6, 1e6);
    flags.json(c.json);
    return [command]() -> Command {
        if (command->reference.empty())
            throw UsageError("disparity needs --reference FILE; make the pair with: tarn reference --set "
                             "stereo.output=pair --out truth.exr");
        return *command;
    };
}

} // namespace tarn
