// tarn compare: how different are two pictures, to the eye and in their values? Two folders of pictures are compared in
// compare_folders.cpp.
#include "app/command_flags.h"
#include "app/commands.h"
#include "app/compare_folders.h"
#include "app/compared_picture.h"
#include "app/output.h"
#include "base/error.h"
#include "measure/flip.h"
#include "measure/heat.h"
#include "measure/image_compare.h"
#include "measure/picture_error.h"

#include <nlohmann/json.hpp>

#include <array>

namespace tarn {

namespace {

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
    const ComparedPicture reference = readComparedPicture(command.reference), test = readComparedPicture(command.test);
    requireComparable(reference.image, test.image);
    Comparison result;
    result.anyLinear = reference.isLinear || test.isLinear;
    result.bothLinear = reference.isLinear && test.isLinear;
    result.size = {reference.image.width, reference.image.height};
    if (!result.anyLinear && (command.exposure || !command.toneCurve.empty()))
        throw UsageError("--exposure and --tone-curve are for linear pictures (.exr); neither is one");
    if (result.anyLinear) result.showing = chooseShowing(command, reference, test);

    const Image a = exposed(reference, result.showing), b = exposed(test, result.showing);
    const Image shownA = shown(reference, a, result.showing), shownB = shown(test, b, result.showing);
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

bool isFolder(const std::filesystem::path& path)
{
    std::error_code error;
    return std::filesystem::is_directory(path, error);
}

/// Whatever is for two folders is refused, not ignored.
void requireForPictures(const CompareCommand& command)
{
    const FolderTolerance& tolerance = command.tolerance;
    const std::pair<bool, const char*> given[] = {{!command.junit.empty(), "--junit"},
                                                  {!command.report.empty(), "--report"},
                                                  {tolerance.channel.has_value(), "--tolerance"},
                                                  {tolerance.fraction.has_value(), "--fraction"},
                                                  {tolerance.hardLimit.has_value(), "--hard-limit"},
                                                  {tolerance.hardFraction.has_value(), "--hard-fraction"},
                                                  {tolerance.mean.has_value(), "--mean-limit"}};
    for (const auto& [isGiven, flag] : given)
        if (isGiven)
            throw UsageError("{} is for two folders of pictures; {} is none", flag, command.reference.string());
}

void requireWritable(const CompareCommand& command)
{
    requireWritableJson(command.json);
    if (!command.out.empty()) requireWritablePicture(command.out);
}

} // namespace

void run(const CompareCommand& command)
{
    if (isFolder(command.reference) || isFolder(command.test)) return compareFolders(command);
    requireForPictures(command);
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

void addFolderFlags(Flags& flags, CompareCommand& c)
{
    flags.path("--junit", "FILE", "Of two folders: write a test for each picture as JUnit's XML", c.junit);
    flags.path("--report", "DIR",
               "Of two folders: write a page (index.html) of the pictures that fail, and how they differ", c.report);
    const PictureTolerance usual;
    FolderTolerance& tolerance = c.tolerance;
    const auto doc = [](const char* text, auto value) {
        return fmt::format("Of two folders: {} ({} by default)", text, value);
    };
    flags.count("--tolerance", doc("difference of a channel, of 255, that does not count", usual.channel).c_str(),
                tolerance.channel, 0, 255);
    flags.number("--fraction", "F",
                 doc("fraction of the pixels that may differ by more than --tolerance", usual.fraction).c_str(),
                 tolerance.fraction, 0.0, 1.0);
    flags.count("--hard-limit",
                doc("difference of a channel, of 255, that hardly any pixel may have", usual.hardLimit).c_str(),
                tolerance.hardLimit, 0, 255);
    flags.number(
        "--hard-fraction", "F",
        doc("fraction of the pixels that may differ by more than --hard-limit", usual.hardLimitFraction).c_str(),
        tolerance.hardFraction, 0.0, 1.0);
    flags.number("--mean-limit", "X",
                 doc("signed mean difference of a channel, of 255, that passes", usual.mean).c_str(), tolerance.mean,
                 0.0, 255.0);
}

} // namespace

MakeCommand defineCompare(Flags& flags)
{
    auto command = std::make_shared<CompareCommand>();
    CompareCommand& c = *command;
    flags.path("REFERENCE", "FILE", "The picture that is right: .png, .jpg, or .exr (linear); or a folder of them",
               c.reference);
    flags.path("TEST", "FILE", "The picture to judge, of the same size; or a folder with pictures of the same names",
               c.test);
    flags.path("--out", "FILE", "Map of the differences seen: .png as colours, .exr as FLIP's values", c.out);
    flags.number("--exposure", "E", "Factor on linear pictures; the reference's own by default", c.exposure, 0.0,
                 1000.0);
    flags.value("--tone-curve", "NAME", "linear, reinhard or aces; the reference's own by default",
                [&c](const std::string& text, const std::string& flag) { c.toneCurve = parseToneCurve(text, flag); });
    flags.number("--ppd", "P", "Pixels that fill a degree of the viewer's sight", c.pixelsPerDegree,
                 leastPixelsPerDegree, mostPixelsPerDegree);
    flags.number("--max-flip", "X", "Fail when the mean FLIP is over X", c.maxFlip, 0.0, 1.0);
    addFolderFlags(flags, c);
    flags.json(c.json);
    return [command]() -> Command {
        if (command->test.empty())
            throw UsageError("compare needs two pictures, such as compare reference.png test.png, or two folders");
        return *command;
    };
}

} // namespace tarn
