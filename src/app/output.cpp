#include "app/output.h"

#include "base/error.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <unistd.h>

namespace tarn {

namespace fs = std::filesystem;

void requireWritableFolder(const fs::path& folder)
{
    const fs::path where = folder.empty() ? fs::path(".") : folder;
    std::error_code ignored;
    if (!fs::exists(where, ignored)) throw Error("{}: no such folder; make it first", where.string());
    if (!fs::is_directory(where, ignored)) throw Error("{}: not a folder", where.string());
    if (access(where.c_str(), W_OK | X_OK) != 0)
        throw Error("{}: this folder cannot be written; choose another or change its permissions", where.string());
}

void requireWritablePicture(const fs::path& file)
{
    const std::string extension = file.extension().string();
    if (extension != ".png" && extension != ".exr")
        throw UsageError("--out {}: the name must end in .png (tone-mapped) or .exr (linear)", file.string());
    std::error_code ignored;
    if (fs::is_directory(file, ignored)) throw Error("{}: is a folder; give a file", file.string());
    requireWritableFolder(file.parent_path());
}

namespace {

/// "%d" or "%0Nd" in a pattern.
struct NumberPlace {
    std::size_t begin = 0, end = 0;
    int digits = 0;
};

std::optional<NumberPlace> findNumber(const std::string& pattern, std::size_t from)
{
    for (std::size_t at = pattern.find('%', from); at != std::string::npos; at = pattern.find('%', at + 1)) {
        std::size_t end = at + 1;
        int digits = 0;
        if (end < pattern.size() && pattern[end] == '0') {
            ++end;
            if (end < pattern.size() && pattern[end] >= '1' && pattern[end] <= '9') digits = pattern[end++] - '0';
        }
        if (end < pattern.size() && pattern[end] == 'd') return NumberPlace{at, end + 1, digits};
    }
    return std::nullopt;
}

} // namespace

std::vector<fs::path> sequenceFiles(const std::string& pattern, int frames)
{
    const std::optional<NumberPlace> number = findNumber(pattern, 0);
    if (!number) {
        if (frames == 1) return {pattern};
        throw UsageError("--out {}: {} frames need a number in the name, such as frame_%04d.png", pattern, frames);
    }
    if (findNumber(pattern, number->end)) throw UsageError("--out {}: only one %d may stand in the name", pattern);
    std::vector<fs::path> files;
    for (int frame = 0; frame < frames; ++frame)
        files.emplace_back(pattern.substr(0, number->begin) + fmt::format("{:0{}}", frame, number->digits) +
                           pattern.substr(number->end));
    return files;
}

std::string fileNameFrom(const std::string& name)
{
    std::string result;
    for (const char c : name) {
        const bool fits = std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || c == '.';
        if (fits) {
            result += c;
        } else if (!result.empty() && result.back() != '-') {
            result += '-';
        }
    }
    while (!result.empty() && result.back() == '-') result.pop_back();
    result.erase(0, result.find_first_not_of('.')); // never hidden, never ".."
    return result.empty() ? "unnamed" : result;
}

} // namespace tarn
