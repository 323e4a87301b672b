#include "app/compare_report.h"

#include "app/output.h"
#include "base/error.h"
#include "base/files.h"

#include <algorithm>
#include <set>

namespace tarn {

namespace fs = std::filesystem;

namespace {

constexpr const char *page = "index.html", *pictures = "pictures";

/// The difference in opaque colours: a difference of alpha would else decide how much of it is seen, and show where
/// there is no other.
Image visibleDifference(const Image& expected, const Image& actual)
{
    Image difference = differencePicture(expected, actual);
    if (difference.channels != 4) return difference;
    Image opaque{difference.name, difference.width, difference.height, 3, {}, {}};
    opaque.bytes.reserve(opaque.size());
    for (std::size_t i = 0; i < difference.bytes.size(); i += 4)
        for (std::size_t c = 0; c < 3; ++c)
            opaque.bytes.push_back(std::max(difference.bytes[i + c], difference.bytes[i + 3]));
    return opaque;
}

} // namespace

const char* outcomeName(PictureOutcome outcome)
{
    switch (outcome) {
    case PictureOutcome::good: return "good";
    case PictureOutcome::different: return "different";
    case PictureOutcome::missing: return "missing";
    case PictureOutcome::extra: return "extra";
    case PictureOutcome::error: return "error";
    }
    return "error";
}

void requireReportFolder(const fs::path& folder)
{
    const fs::path target = folder.has_filename() ? folder : folder.parent_path();
    requireWritableFolder(target.parent_path());
    if (!fs::exists(target)) return;
    if (!fs::is_directory(target)) throw Error("--report {}: is a file; give a folder", target.string());
    const std::set<std::string> own{page, pictures};
    for (const fs::directory_entry& entry : fs::directory_iterator(target))
        if (!own.contains(entry.path().filename().string()))
            throw Error("--report {}: holds more than an earlier report ({}); give another folder, or remove that",
                        target.string(), entry.path().filename().string());
}

std::string ReportDraft::writePicture(const char* kind, const Image& image) const
{
    makeFolder(folder_ / pictures);
    const std::string name = fmt::format("{}/{}-{}.png", pictures, failed_.size() + 1, kind);
    writeImage(folder_ / name, image);
    return name;
}

void ReportDraft::add(const PictureResult& result, const Image* expected, const Image* actual)
{
    if (result.outcome == PictureOutcome::good) {
        passed_.push_back({result.name, result.verdict});
        return;
    }
    ComparisonEntry entry{result.name, outcomeName(result.outcome), result.verdict, {}, {}, {}};
    if (expected) entry.expected = writePicture("expected", *expected);
    if (actual) entry.actual = writePicture("actual", *actual);
    if (expected && actual && result.comparison && result.comparison->mismatch.empty())
        entry.difference = writePicture("difference", visibleDifference(*expected, *actual));
    failed_.push_back(std::move(entry));
}

void ReportDraft::finish(const std::string& title) const
{
    writeFile(folder_ / page, comparisonPage(title, failed_, passed_));
}

} // namespace tarn
