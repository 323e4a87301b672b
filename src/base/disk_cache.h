// Bytes that take long to make, on disk for the next start.
//
//     DiskCache cache(cacheFolder() / "mip-levels", 64 << 20);
//     if (const auto found = cache.read(key)) use(*found);
//     else cache.write(key, bytes);
//
// What is read is what was written for this very key, or nothing: a damaged, cut or foreign file counts as missing. A
// cache that cannot be written is none, and nobody is told. Several processes may use one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace tarn {

/// $XDG_CACHE_HOME/tarn, or ~/.cache/tarn (XDG Base Directory Specification 0.8); empty where there is neither.
std::filesystem::path cacheFolder();

class DiskCache {
public:
    /// @param folder made when something is first written; empty: nothing is ever found
    /// @param mostBytes of all files; the longest unused go first
    DiskCache(std::filesystem::path folder, std::uintmax_t mostBytes);

    std::optional<std::string> read(std::string_view key) const;
    void write(std::string_view key, std::string_view bytes) const;

private:
    std::filesystem::path fileOf(std::string_view key) const;
    void makeRoom() const;

    std::filesystem::path folder_;
    std::uintmax_t mostBytes_;
};

} // namespace tarn
