#include "base/disk_cache.h"

#include "base/error.h"
#include "base/files.h"
#include "base/hash.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <vector>

namespace tarn {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view magic = "tarn cache 1\n";

void append(std::string& text, std::uint64_t number)
{
    char bytes[sizeof number];
    std::memcpy(bytes, &number, sizeof number);
    text.append(bytes, sizeof number);
}

/// Takes a number off the front; nothing when there are too few bytes.
std::optional<std::uint64_t> takeNumber(std::string_view& rest)
{
    std::uint64_t number = 0;
    if (rest.size() < sizeof number) return std::nullopt;
    std::memcpy(&number, rest.data(), sizeof number);
    rest.remove_prefix(sizeof number);
    return number;
}

/// Takes a text, its length and its hash off the front; nothing when they do not fit together.
std::optional<std::string_view> takeText(std::string_view& rest)
{
    const auto length = takeNumber(rest), hash = takeNumber(rest);
    if (!length || !hash || *length > rest.size()) return std::nullopt;
    const std::string_view text = rest.substr(0, static_cast<std::size_t>(*length));
    if (hashOf(text) != *hash) return std::nullopt;
    rest.remove_prefix(text.size());
    return text;
}

void appendText(std::string& file, std::string_view text)
{
    append(file, text.size());
    append(file, hashOf(text));
    file += text;
}

} // namespace

fs::path cacheFolder()
{
    // A relative path is to be ignored, says the specification.
    if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && fs::path(cache).is_absolute())
        return fs::path(cache) / "tarn";
    if (const char* home = std::getenv("HOME"); home && fs::path(home).is_absolute())
        return fs::path(home) / ".cache" / "tarn";
    return {};
}

DiskCache::DiskCache(fs::path folder, std::uintmax_t mostBytes) : folder_(std::move(folder)), mostBytes_(mostBytes) {}

fs::path DiskCache::fileOf(std::string_view key) const { return folder_ / fmt::format("{:016x}", hashOf(key)); }

std::optional<std::string> DiskCache::read(std::string_view key) const
{
    if (folder_.empty()) return std::nullopt;
    const fs::path file = fileOf(key);
    std::error_code error;
    if (!fs::is_regular_file(file, error)) return std::nullopt;
    try {
        const std::string text = readFile(file);
        std::string_view rest = text;
        if (!rest.starts_with(magic)) return std::nullopt;
        rest.remove_prefix(magic.size());
        const auto storedKey = takeText(rest);
        if (!storedKey || *storedKey != key) return std::nullopt;
        const auto bytes = takeText(rest);
        if (!bytes || !rest.empty()) return std::nullopt;
        fs::last_write_time(file, fs::file_time_type::clock::now(), error); // it was of use
        return std::string(*bytes);
    } catch (const Error&) { // another process has just removed it
        return std::nullopt;
    }
}

void DiskCache::write(std::string_view key, std::string_view bytes) const
{
    if (folder_.empty()) return;
    std::string file(magic);
    appendText(file, key);
    appendText(file, bytes);
    if (file.size() > mostBytes_) return;
    try {
        makeFolder(folder_);
        writeFile(fileOf(key), file);
        makeRoom();
    } catch (const std::exception&) {
        // A full or read-only disk: the next start makes it again.
    }
}

/// Temporary files of others are counted, and removed only when they are as old as the rest.
void DiskCache::makeRoom() const
{
    struct Entry {
        fs::file_time_type time;
        std::uintmax_t size;
        fs::path file;
    };
    std::vector<Entry> entries;
    std::uintmax_t total = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
        std::error_code error;
        if (!entry.is_regular_file(error)) continue;
        entries.push_back({entry.last_write_time(error), entry.file_size(error), entry.path()});
        if (error)
            entries.pop_back(); // gone meanwhile
        else
            total += entries.back().size;
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.time < b.time; });
    for (const Entry& entry : entries) {
        if (total <= mostBytes_) return;
        std::error_code error;
        fs::remove(entry.file, error);
        total -= entry.size;
    }
}

} // namespace tarn
