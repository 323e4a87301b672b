// Warnings about one file, so many that a person still reads them. Private to src/scene.
#pragma once

#include "base/log.h"

#include <string>

namespace tarn {

/// Prints the first ten as "file:line: message", and how many more there were when it goes out of scope.
class FileWarnings {
public:
    explicit FileWarnings(std::string file) : file_(std::move(file)) {}
    FileWarnings(const FileWarnings&) = delete;
    FileWarnings& operator=(const FileWarnings&) = delete;
    ~FileWarnings()
    {
        if (count_ > shown) log::warning("{}: {} more warnings of this kind", file_, count_ - shown);
    }

    void at(std::size_t line, const std::string& message)
    {
        if (++count_ <= shown) log::warning("{}:{}: {}", file_, line, message);
    }

private:
    static constexpr std::size_t shown = 10;
    std::string file_;
    std::size_t count_ = 0;
};

} // namespace tarn
