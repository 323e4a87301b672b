// One HTML page that shows what a failed picture test expected, what it got and where they differ. It needs
// no other file and no network, so it can be sent along or kept by a build server.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tarn {

/// One case. Pictures are whole PNG files; a missing one is told as such.
struct ComparisonEntry {
    std::string name;        ///< of the case
    std::string description; ///< what the case is there for
    std::string verdict;     ///< PictureComparison::summary(), or what went wrong before
    std::optional<std::string> expectedPng, actualPng, differencePng;
};

/// The page's text. Names and verdicts are escaped.
std::string comparisonPage(const std::string& title, const std::vector<ComparisonEntry>& entries);

/// RFC 4648.
std::string base64(const std::string& bytes);

} // namespace tarn
