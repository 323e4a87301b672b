// One HTML page that shows what a failed picture test expected, what it got and where they differ. It needs
// no network, and where its pictures are embedded no other file, so it can be sent along or kept by a build server.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tarn {

/// One case. A picture is the `src` of an <img>: what embeddedPng() returns, or a file's name relative to the page; a
/// missing one is told as such.
struct ComparisonEntry {
    std::string name;        ///< of the case
    std::string description; ///< what the case is there for
    std::string verdict;     ///< PictureComparison::summary(), or what went wrong before
    std::optional<std::string> expected, actual, difference;
};

/// A case that passed: no pictures.
struct PassedCase {
    std::string name, verdict;
};

/// The page's text. Names and verdicts are escaped.
std::string comparisonPage(const std::string& title, const std::vector<ComparisonEntry>& entries,
                           const std::vector<PassedCase>& passed = {});

/// A whole PNG file as a data URL.
std::string embeddedPng(const std::string& png);

/// RFC 4648.
std::string base64(const std::string& bytes);

} // namespace tarn
