// tarn compare: how different are two pictures, to the eye and in their values?
#include "app/command_flags.h"
#include "app/commands.h"
#include "app/output.h"
#include "base/error.h"
#include "base/log.h"
#include "measure/display.h"
#include "measure/flip.h"
#include "measure/heat.h"
#include "measure/picture_error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>

namespace tarn {

namespace {

/// A picture as its file holds it.
struct Source {
    std::filesystem::path file;
    Image image; ///< 8-bit sRGB, or linear floats of red, green and blue
    bool linear = false;
    std::string settings; ///< a linear picture's "tarn:settings", or ""
};

bool isLinearFile(const std::filesystem::path& file)
{
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == ".exr" || extension == ".hdr";
}

/// R, G and B of a picture that may hold more: a reference has the water's geometry beside them.
Image colourChannels(const NamedImage& picture)
{
    const Image& all = picture.image;
    std::array<std::size_t, 3> places{};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::string name(1, "RGB"[i]);
        const auto found = std::find(picture.channelNames.begin(), picture.channelNames.end(), name);
        if (found == picture.channelNames.end())
            throw Error("{}: has no channel {}; it has {}", all.name, name, fmt::join(picture.channelNames, ", "));
        places[i] = static_cast<std::size_t>(found - picture.channelNames.begin());
    }
    Image result{all.name, all.width, all.height, 3, {}, {}};
    result.floats.reserve(result.size());
    for (std::size_t i = 0; i < all.floats.size(); i += picture.channelNames.size())
        for (const std::size_t place : places) result.floats.push_back(all.floats[i + place]);
    return result;
}

Source readSource(const std::filesystem::path& file)
{
    if (!isLinearFile(file)) {
        Source source{file, readImage(file), false, ""};
        if (source.image.isFloat())
            throw Error("{}: has more than 8 bits; 8-bit pictures and linear .exr files are compared", file.string());
        return source;
    }
    const NamedImage picture = readNamedImage(file);
    const auto settings = picture.metadata.find("tarn:settings");
    Source source{file, colourChannels(picture), true, settings == picture.metadata.end() ? "" : settings->second};
    requireFinite(source.image);
    return source;
}

/// How linear pictures are shown, and where that was said.
struct Showing {
    FrameOptions frame;
    std::string exposureOrigin = "default", toneCurveOrigin = "default";
};

void assignFrame(FrameOptions& frame, const Assignment& assignment)
{
    Options options;
    options.frame = frame;
    assign([&](FieldVisitor& visitor) { visit(visitor, options); }, assignment);
    frame = options.frame;
}

nlohmann::json frameJson(FrameOptions frame)
{
    Options options;
    options.frame = frame;
    return toJson([&](FieldVisitor& visitor) { visit(visitor, options); })["frame"];
}

/// What the header says of exposure and tone curve replaces the defaults. A damaged header is an error: to
/// compare with a guessed exposure would give a wrong figure without a word.
Showing headerShowing(const Source& source)
{
    Showing showing;
    if (source.settings.empty()) return showing;
    const std::string name = source.file.string();
    const auto json = nlohmann::json::parse(source.settings, nullptr, false);
    if (!json.is_object()) throw Error("{}: its tarn:settings are damaged; give --exposure and --tone-curve", name);
    if (!json.contains("frame") || !json["frame"].is_object()) return showing;
    const auto take = [&](const char* key, std::string& origin) {
        if (!json["frame"].contains(key)) return;
        const nlohmann::json& value = json["frame"][key];
        const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
        try {
            assignFrame(showing.frame, {fmt::format("frame.{}", key), text, name});
        } catch (const UsageError& error) { // the file's mistake, not the command line's
            throw Error("{}", error.what());
        }
        origin = "from " + name;
    };
    take("exposure", showing.exposureOrigin);
    take("tone_curve", showing.toneCurveOrigin);
    return showing;
}

/// Command line, else the reference's header, else the test's, else the defaults.
Showing chooseShowing(const CompareCommand& command, const Source& reference, const Source& test)
{
    Showing showing;
    if (!command.exposure || command.toneCurve.empty()) {
        const bool fromReference = !reference.settings.empty();
        showing = headerShowing(fromReference ? reference : test);
        if (fromReference && !test.settings.empty()) {
            const FrameOptions other = headerShowing(test).frame;
            if (other.exposure != showing.frame.exposure || other.toneCurve != showing.frame.toneCurve)
                log::warning("{} was made with another exposure or tone curve than {}; the latter's are used",
                             test.file.string(), reference.file.string());
        }
    }
    if (command.exposure) {
        showing.frame.exposure = static_cast<float>(*command.exposure);
        showing.exposureOrigin = "--exposure";
    }
    if (!command.toneCurve.empty()) {
        assignFrame(showing.frame, {"frame.tone_curve", command.toneCurve, "--tone-curve"});
        showing.toneCurveOrigin = "--tone-curve";
    }
    return showing;
}

struct Comparison {
    bool anyLinear = false, bothLinear = false;
    ivec2 size{0};
    Showing showing;
    Image flip; ///< the map
    double meanFlip = 0.0;
    PictureError error; ///< of the exposed radiance when both are linear, else of the 8-bit pictures
};

Comparison compare(const CompareCommand& command)
{
    const Source reference = readSource(command.reference), test = readSource(command.test);
    requireComparable(reference.image, test.image);
    Comparison result;
    result.anyLinear = reference.linear || test.linear;
    result.bothLinear = reference.linear && test.linear;
    result.size = {reference.image.width, reference.image.height};
    if (!result.anyLinear && (command.exposure || !command.toneCurve.empty()))
        throw UsageError("--exposure and --tone-curve are for linear pictures (.exr); neither is one");
    if (result.anyLinear) result.showing = chooseShowing(command, reference, test);

    const FrameOptions& frame = result.showing.frame;
    const auto exposed = [&](const Source& source) {
        return source.linear ? exposedPicture(source.image, frame.exposure) : source.image;
    };
    const auto shown = [&](const Source& source, const Image& image) {
        return source.linear ? displayPicture(image, frame.toneCurve) : image;
    };
    const Image a = exposed(reference), b = exposed(test);
    const Image shownA = shown(reference, a), shownB = shown(test, b);
    result.flip = flipMap(shownA, shownB, command.pixelsPerDegree);
    result.meanFlip = meanOf(result.flip);
    result.error = result.bothLinear ? pictureError(a, b) : pictureError(shownA, shownB);
    return result;
}

const char* valuesCompared(const Comparison& comparison)
{
    return comparison.bothLinear ? "radiance times exposure" : "8-bit sRGB values as 0 to 1";
}

constexpr std::array channelNames{"red", "green", "blue"};

nlohmann::json toJson(const Comparison& comparison, const CompareCommand& command)
{
    const PictureError& error = comparison.error;
    nlohmann::json json{{"reference", command.reference.string()},
                        {"test", command.test.string()},
                        {"size", {comparison.size.x, comparison.size.y}},
                        {"pixels_per_degree", command.pixelsPerDegree},
                        {"flip", comparison.meanFlip},
                        {"values", valuesCompared(comparison)},
                        {"mean", error.mean},
                        {"rmse", error.rmse},
                        {"psnr", error.psnr}, // null when infinite
                        {"max",
                         {{"value", error.largest},
                          {"at", {error.largestAt.x, error.largestAt.y}},
                          {"channel", channelNames[static_cast<std::size_t>(error.largestChannel)]}}}};
    if (comparison.anyLinear) {
        const nlohmann::json frame = frameJson(comparison.showing.frame);
        json["exposure"] = {{"value", frame["exposure"]}, {"origin", comparison.showing.exposureOrigin}};
        json["tone_curve"] = {{"value", frame["tone_curve"]}, {"origin", comparison.showing.toneCurveOrigin}};
    }
    return json;
}

void print(const Comparison& comparison, const CompareCommand& command)
{
    const auto row = [](const char* name, const std::string& value, const std::string& remark) {
        fmt::print("  {:<18}{:<10}{}\n", name, value, remark);
    };
    fmt::print("{} against {}, {}x{} pixels\n", command.test.string(), command.reference.string(), comparison.size.x,
               comparison.size.y);
    if (comparison.anyLinear) {
        const nlohmann::json frame = frameJson(comparison.showing.frame);
        row("exposure", fmt::format("{}", comparison.showing.frame.exposure), comparison.showing.exposureOrigin);
        row("tone curve", frame["tone_curve"].get<std::string>(), comparison.showing.toneCurveOrigin);
    }
    const PictureError& error = comparison.error;
    row("mean FLIP", fmt::format("{:.6f}", comparison.meanFlip),
        fmt::format("at {:.4g} pixels per degree", command.pixelsPerDegree));
    row("RMSE", fmt::format("{:.6f}", error.rmse), fmt::format("of {}", valuesCompared(comparison)));
    row("PSNR", fmt::format("{:.2f}", error.psnr), "dB below 1");
    row("largest", fmt::format("{:.6f}", error.largest),
        error.largest > 0.0
            ? fmt::format("in {} at pixel {},{}", channelNames[static_cast<std::size_t>(error.largestChannel)],
                          error.largestAt.x, error.largestAt.y)
            : "");
}

void requireWritable(const CompareCommand& command)
{
    requireWritableJson(command.json);
    if (!command.out.empty()) requireWritablePicture(command.out);
}

} // namespace

void run(const CompareCommand& command)
{
    requireWritable(command);
    const Comparison comparison = compare(command);
    if (!command.out.empty())
        writeImage(command.out,
                   command.out.extension() == ".exr" ? comparison.flip : heatPicture(comparison.flip, 0.0, 1.0));
    writeJson(command.json, toJson(comparison, command));
    if (command.json != "-") print(comparison, command);
    if (command.maxFlip && comparison.meanFlip > *command.maxFlip)
        throw Error("{}: mean FLIP {:.6f} is over --max-flip {}", command.test.string(), comparison.meanFlip,
                    *command.maxFlip);
}

namespace {

std::string parseToneCurve(const std::string& text, const std::string& flag)
{
    Options options; // the option's own check, so that its names stand in one place
    assign([&](FieldVisitor& visitor) { visit(visitor, options); }, {"frame.tone_curve", text, flag});
    return text;
}

} // namespace

MakeCommand defineCompare(Flags& flags)
{
    auto command = std::make_shared<CompareCommand>();
    CompareCommand& c = *command;
    flags.path("REFERENCE", "FILE", "The picture that is right: .png, .jpg, or .exr (linear)", c.reference);
    flags.path("TEST", "FILE", "The picture to judge, of the same size", c.test);
    flags.path("--out", "FILE", "Map of the differences seen: .png as colours, .exr as FLIP's values", c.out);
    flags.number("--exposure", "E", "Factor on linear pictures; the reference's own by default", c.exposure, 0.0,
                 1000.0);
    flags.value("--tone-curve", "NAME", "linear, reinhard or aces; the reference's own by default",
                [&c](const std::string& text, const std::string& flag) { c.toneCurve = parseToneCurve(text, flag); });
    flags.number("--ppd", "P", "Pixels that fill a degree of the viewer's sight", c.pixelsPerDegree,
                 leastPixelsPerDegree, mostPixelsPerDegree);
    flags.number("--max-flip", "X", "Fail when the mean FLIP is over X", c.maxFlip, 0.0, 1.0);
    flags.json(c.json);
    return [command]() -> Command {
        if (command->test.empty())
            throw UsageError("compare needs two pictures, such as compare reference.png test.png");
        return *command;
    };
}

} // namespace tarn
