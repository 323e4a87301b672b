// What came out of comparing two folders of pictures, and the page that shows it.
#pragma once

#include "measure/comparison_page.h"
#include "measure/image_compare.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tarn {

enum class PictureOutcome {
    good,
    different,
    missing, ///< in the reference's folder only
    extra,   ///< in the test's folder only
    error    ///< one of the two cannot be read
};

const char* outcomeName(PictureOutcome outcome);

struct PictureResult {
    std::string name; ///< relative to both folders
    PictureOutcome outcome = PictureOutcome::error;
    std::string verdict;                         ///< one line
    std::optional<PictureComparison> comparison; ///< where there are two pictures
    std::optional<double> flip;                  ///< their mean, where it was asked for
    double seconds = 0.0;                        ///< that the comparison took
};

/// Throws Error when the folder could not become a report: its parent cannot be written, or it holds something else.
void requireReportFolder(const std::filesystem::path& folder);

/// Fills a folder with index.html and the pictures that it shows: those that fail, each as a file of its own.
class ReportDraft {
public:
    explicit ReportDraft(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// @param expected, actual 8-bit pictures; null: there is none
    void add(const PictureResult& result, const Image* expected, const Image* actual);
    void finish(const std::string& title) const;

private:
    std::string writePicture(const char* kind, const Image& image) const;

    std::filesystem::path folder_;
    std::vector<ComparisonEntry> failed_;
    std::vector<PassedCase> passed_;
};

} // namespace tarn
