#include "app/compare_folders.h"

#include "app/commands.h"
#include "app/compare_report.h"
#include "app/compared_picture.h"
#include "app/interrupt.h"
#include "app/output.h"
#include "base/error.h"
#include "base/files.h"
#include "base/progress.h"
#include "measure/flip.h"
#include "measure/junit.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <map>
#include <set>

namespace tarn {

namespace fs = std::filesystem;

namespace {

bool isPictureName(const fs::path& file)
{
    static const std::set<std::string> extensions{".png", ".jpg",  ".jpeg", ".bmp", ".tga",
                                                  ".tif", ".tiff", ".exr",  ".hdr"};
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extensions.contains(extension);
}

/// Names of the pictures in a folder and those below it, relative to it.
std::set<std::string> picturesIn(const fs::path& folder)
{
    std::set<std::string> names;
    try {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
            if (entry.is_regular_file() && isPictureName(entry.path()))
                names.insert(entry.path().lexically_relative(folder).generic_string());
    } catch (const fs::filesystem_error& error) {
        throw Error("{}: cannot be read ({})", error.path1().string(), error.code().message());
    }
    return names;
}

/// The path without "..", links or a slash at its end, so that two of them can be compared.
fs::path resolved(const fs::path& path)
{
    std::error_code error;
    const fs::path result = fs::weakly_canonical(fs::absolute(path), error);
    if (error) throw Error("{}: cannot be read ({})", path.string(), error.message());
    return result.has_filename() ? result : result.parent_path();
}

bool isWithin(const fs::path& path, const fs::path& folder)
{
    const fs::path relative = resolved(path).lexically_relative(resolved(folder));
    return !relative.empty() && *relative.begin() != "..";
}

/// No output may touch what is compared, or be taken for a picture of it the next time.
void requireApart(const CompareCommand& command)
{
    for (const fs::path& input : {command.reference, command.test}) {
        if (!command.report.empty() && (isWithin(command.report, input) || isWithin(input, command.report)))
            throw UsageError("--report {}: is one with {}, whose pictures are compared; give a folder beside it",
                             command.report.string(), input.string());
        for (const auto& [file, flag] : {std::pair{command.junit, "--junit"}, {fs::path(command.json), "--json"}})
            if (!file.empty() && isPictureName(file) && isWithin(file, input))
                throw UsageError("{} {}: would be taken for a picture of {}", flag, file.string(), input.string());
    }
    for (const auto& [file, flag] : {std::pair{command.junit, "--junit"}, {fs::path(command.json), "--json"}})
        if (!file.empty() && !command.report.empty() && isWithin(file, command.report))
            throw UsageError("{} {}: lies in --report {}, which is written anew; put it beside that folder", flag,
                             file.string(), command.report.string());
}

void requireWritable(const CompareCommand& command)
{
    requireWritableJson(command.json);
    if (!command.junit.empty()) {
        if (fs::is_directory(command.junit))
            throw Error("--junit {}: is a folder; give a file", command.junit.string());
        requireWritableFolder(command.junit.parent_path());
    }
    if (!command.report.empty()) requireReportFolder(command.report);
}

void requireTwoFolders(const CompareCommand& command)
{
    for (const fs::path& folder : {command.reference, command.test})
        if (!fs::is_directory(folder))
            throw UsageError("{}: is no folder; compare two pictures, or two folders of pictures", folder.string());
    if (!command.out.empty())
        throw UsageError("--out is the map of two pictures; of two folders --report DIR shows the differences");
    if (resolved(command.reference) == resolved(command.test))
        throw UsageError("{} and {} are the same folder, of which no picture can differ", command.reference.string(),
                         command.test.string());
    requireApart(command);
}

/// Flags that would do nothing are refused.
void requireUse(const CompareCommand& command, const std::set<std::string>& names)
{
    const bool anyLinear =
        std::any_of(names.begin(), names.end(), [](const fs::path& name) { return isLinearFile(name); });
    if (!anyLinear && (command.exposure || !command.toneCurve.empty()))
        throw UsageError("--exposure and --tone-curve are for linear pictures (.exr); {} holds none",
                         command.reference.string());
    if (command.pixelsPerDegree != defaultPixelsPerDegree && !command.maxFlip)
        throw UsageError("--ppd is for FLIP; of two folders --max-flip X asks for it");
}

PictureTolerance toleranceOf(const FolderTolerance& given)
{
    PictureTolerance tolerance;
    tolerance.channel = given.channel.value_or(tolerance.channel);
    tolerance.fraction = given.fraction.value_or(tolerance.fraction);
    tolerance.hardLimit = given.hardLimit.value_or(tolerance.hardLimit);
    tolerance.hardLimitFraction = given.hardFraction.value_or(tolerance.hardLimitFraction);
    tolerance.mean = given.mean.value_or(tolerance.mean);
    if (tolerance.hardLimit < tolerance.channel)
        throw UsageError("--hard-limit {} is below --tolerance {}; it is for differences that pass that",
                         tolerance.hardLimit, tolerance.channel);
    return tolerance;
}

/// Both pictures as 8-bit ones.
struct ShownPair {
    Image expected, actual;
};

ShownPair readPair(const CompareCommand& command, const std::string& name)
{
    const ComparedPicture reference = readComparedPicture(command.reference / name);
    const ComparedPicture test = readComparedPicture(command.test / name);
    Showing showing;
    if (reference.isLinear || test.isLinear) showing = chooseShowing(command, reference, test);
    return {shown(reference, exposed(reference, showing), showing), shown(test, exposed(test, showing), showing)};
}

void judge(const CompareCommand& command, const PictureTolerance& tolerance, const ShownPair& pair,
           PictureResult& result)
{
    result.comparison = comparePictures(pair.expected, pair.actual, tolerance);
    result.verdict = result.comparison->summary();
    bool isGood = result.comparison->same();
    if (command.maxFlip && result.comparison->mismatch.empty()) {
        result.flip = meanFlip(pair.expected, pair.actual, command.pixelsPerDegree);
        const bool isOver = *result.flip > *command.maxFlip;
        result.verdict +=
            fmt::format("; mean FLIP {:.6f}{}", *result.flip, isOver ? fmt::format(", over {}", *command.maxFlip) : "");
        isGood = isGood && !isOver;
    }
    result.outcome = isGood ? PictureOutcome::good : PictureOutcome::different;
}

/// @param draft where pictures for the report go; none: no report
PictureResult compareOne(const CompareCommand& command, const PictureTolerance& tolerance, const std::string& name,
                         ReportDraft* draft)
{
    const auto start = std::chrono::steady_clock::now();
    PictureResult result{.name = name, .outcome = PictureOutcome::error, .verdict = "", .comparison = {}, .flip = {}};
    try {
        const ShownPair pair = readPair(command, name);
        judge(command, tolerance, pair, result);
        if (draft) draft->add(result, &pair.expected, &pair.actual);
    } catch (const Error& error) {
        result.outcome = PictureOutcome::error;
        result.verdict = error.what();
        if (draft) draft->add(result, nullptr, nullptr);
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

/// A picture that one of the folders does not have.
PictureResult lonely(const CompareCommand& command, const std::string& name, PictureOutcome outcome, ReportDraft* draft)
{
    const bool isMissing = outcome == PictureOutcome::missing;
    const fs::path& with = isMissing ? command.reference : command.test;
    const fs::path& without = isMissing ? command.test : command.reference;
    PictureResult result{
        .name = name,
        .outcome = outcome,
        .verdict = fmt::format("{} is in {} only; there is no {}", name, with.string(), (without / name).string()),
        .comparison = {},
        .flip = {}};
    if (!draft) return result;
    try {
        const ComparedPicture picture = readComparedPicture(with / name);
        const Showing showing = picture.isLinear ? chooseShowing(command, picture, picture) : Showing{};
        const Image image = shown(picture, exposed(picture, showing), showing);
        draft->add(result, isMissing ? &image : nullptr, isMissing ? nullptr : &image);
    } catch (const Error& error) {
        result.verdict += fmt::format("; {}", error.what());
        draft->add(result, nullptr, nullptr);
    }
    return result;
}

std::vector<PictureResult> compareAll(const CompareCommand& command, ReportDraft* draft)
{
    const PictureTolerance tolerance = toleranceOf(command.tolerance);
    const std::set<std::string> expected = picturesIn(command.reference), actual = picturesIn(command.test);
    if (expected.empty()) throw Error("{}: holds no pictures to compare with", command.reference.string());
    requireUse(command, expected);
    std::set<std::string> names = expected;
    names.insert(actual.begin(), actual.end());

    TerminalProgress progress;
    const InterruptGuard guard;
    std::vector<PictureResult> results;
    for (const std::string& name : names) {
        if (InterruptGuard::flag()) throw Error("interrupted; nothing was written");
        progress.report(static_cast<double>(results.size()) / static_cast<double>(names.size()), "comparing " + name);
        if (!actual.contains(name))
            results.push_back(lonely(command, name, PictureOutcome::missing, draft));
        else if (!expected.contains(name))
            results.push_back(lonely(command, name, PictureOutcome::extra, draft));
        else
            results.push_back(compareOne(command, tolerance, name, draft));
    }
    return results;
}

std::string junitText(const CompareCommand& command, const std::vector<PictureResult>& results)
{
    std::vector<JUnitCase> cases;
    for (const PictureResult& picture : results) {
        JUnitCase test{.name = picture.name,
                       .seconds = picture.seconds,
                       .result = JUnitCase::Result::failed,
                       .type = outcomeName(picture.outcome),
                       .message = picture.verdict};
        if (picture.outcome == PictureOutcome::good) test.result = JUnitCase::Result::passed;
        if (picture.outcome == PictureOutcome::error) test.result = JUnitCase::Result::error;
        cases.push_back(std::move(test));
    }
    return junitXml(command.reference.string(), cases);
}

nlohmann::json toJson(const CompareCommand& command, const std::vector<PictureResult>& results)
{
    nlohmann::json pictures = nlohmann::json::array();
    for (const PictureResult& picture : results) {
        nlohmann::json json{
            {"name", picture.name}, {"result", outcomeName(picture.outcome)}, {"verdict", picture.verdict}};
        if (picture.comparison && picture.comparison->mismatch.empty()) {
            json["pixels"] = picture.comparison->pixels;
            json["over_tolerance"] = picture.comparison->overChannel;
            json["over_hard_limit"] = picture.comparison->overHardLimit;
            json["largest"] = picture.comparison->largest;
            json["mean"] = picture.comparison->mean;
        }
        if (picture.flip) json["flip"] = *picture.flip;
        pictures.push_back(std::move(json));
    }
    return {{"reference", command.reference.string()}, {"test", command.test.string()}, {"pictures", pictures}};
}

void print(const std::vector<PictureResult>& results)
{
    std::map<PictureOutcome, std::size_t> counts;
    for (const PictureResult& picture : results) {
        ++counts[picture.outcome];
        if (picture.outcome != PictureOutcome::good)
            fmt::print("{:<10}{}: {}\n", outcomeName(picture.outcome), picture.name, picture.verdict);
    }
    std::string line = fmt::format("{} pictures", results.size());
    const char* separator = ": ";
    for (const auto& [outcome, count] : counts) {
        line += fmt::format("{}{} {}", separator, count, outcomeName(outcome));
        separator = ", ";
    }
    fmt::print("{}\n", line);
}

} // namespace

void compareFolders(const CompareCommand& command)
{
    requireTwoFolders(command);
    requireWritable(command);
    std::vector<PictureResult> results;
    if (command.report.empty()) {
        results = compareAll(command, nullptr);
    } else {
        replaceFolder(command.report, [&](const fs::path& folder) {
            ReportDraft draft(folder);
            results = compareAll(command, &draft);
            draft.finish(fmt::format("{} against {}", command.test.string(), command.reference.string()));
        });
    }
    if (!command.junit.empty()) writeFile(command.junit, junitText(command, results));
    writeJson(command.json, toJson(command, results));
    if (command.json != "-") print(results);
    const auto failed = std::count_if(results.begin(), results.end(), [](const PictureResult& picture) {
        return picture.outcome != PictureOutcome::good;
    });
    if (failed > 0)
        throw Error("{}: {} of {} pictures fail against {}{}", command.test.string(), failed, results.size(),
                    command.reference.string(),
                    command.report.empty() ? ""
                                           : fmt::format("; they are in {}", (command.report / "index.html").string()));
}

} // namespace tarn
