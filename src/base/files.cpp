#include "base/files.h"

#include "base/error.h"
#include "base/log.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <mutex>
#include <system_error>

namespace tarn {

namespace fs = std::filesystem;

namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

std::string reason() { return std::generic_category().message(errno); }

bool isRoot(const fs::path& folder)
{
    std::error_code ignored;
    return fs::is_directory(folder / "shaders", ignored) && fs::is_directory(folder / "assets", ignored);
}

/// Beside the target, so that the final rename stays within one file system; the extension stays last because
/// picture writers choose the format by it.
fs::path temporaryName(const fs::path& file)
{
    static std::atomic<int> counter{0};
    return file.parent_path() /
           fmt::format(".{}.{}-{}{}", file.stem().string(), ::getpid(), counter++, file.extension().string());
}

} // namespace

std::string readFile(const fs::path& file)
{
    std::error_code error;
    const auto status = fs::status(file, error);
    if (status.type() == fs::file_type::not_found) throw Error("{}: no such file; check the path", file.string());
    if (fs::is_directory(status)) throw Error("{}: is a directory; name a file in it", file.string());

    const File handle(std::fopen(file.c_str(), "rb"));
    if (!handle) throw Error("{}: cannot be read ({})", file.string(), reason());

    std::string text;
    const auto size = fs::file_size(file, error);
    if (!error) text.reserve(static_cast<std::size_t>(size));
    char block[1 << 16];
    while (const std::size_t count = std::fread(block, 1, sizeof block, handle.get())) text.append(block, count);
    if (std::ferror(handle.get())) throw Error("{}: cannot be read ({})", file.string(), reason());
    return text;
}

void writeWhole(const fs::path& file, const std::function<void(const fs::path&)>& write)
{
    std::error_code error;
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, error))
        throw Error("{}: cannot be written, there is no folder {}", file.string(), folder.string());
    if (fs::is_directory(file, error))
        throw Error("{}: cannot be written, it is a directory; name a file in it", file.string());

    const fs::path temporary = temporaryName(file);
    try {
        write(temporary);
        fs::rename(temporary, file, error);
        if (error) throw Error("{}: cannot be written ({})", file.string(), error.message());
    } catch (...) {
        fs::remove(temporary, error);
        throw;
    }
}

void writeFile(const fs::path& file, std::string_view text)
{
    writeWhole(file, [&](const fs::path& temporary) {
        File handle(std::fopen(temporary.c_str(), "wb"));
        if (!handle) throw Error("{}: cannot be written ({})", file.string(), reason());
        const bool written = std::fwrite(text.data(), 1, text.size(), handle.get()) == text.size();
        // A full disk may show only when the buffer is flushed.
        if (!written || std::fclose(handle.release()) != 0)
            throw Error("{}: cannot be written ({})", file.string(), reason());
    });
}

void replaceFolder(const fs::path& folder, const std::function<void(const fs::path&)>& write)
{
    const fs::path target = folder.has_filename() ? folder : folder.parent_path(); // "report/" is "report"
    const fs::path temporary = temporaryName(target), old = temporaryName(target);
    std::error_code error;
    try {
        fs::create_directory(temporary, error);
        if (error) throw Error("{}: this folder cannot be made: {}", target.string(), error.message());
        write(temporary);
        const bool isThere = fs::exists(target, error);
        if (isThere) fs::rename(target, old, error);
        if (!error) fs::rename(temporary, target, error);
        if (error) {
            std::error_code ignored;
            if (isThere) fs::rename(old, target, ignored);
            throw Error("{}: cannot be written ({})", target.string(), error.message());
        }
    } catch (...) {
        fs::remove_all(temporary, error);
        throw;
    }
    fs::remove_all(old, error);
}

void makeFolder(const fs::path& folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw Error("{}: this folder cannot be made: {}", folder.string(), error.message());
}

fs::path projectRoot()
{
    for (const char* variable : {"TARN_DATA", "TARN_ROOT"}) {
        const char* root = std::getenv(variable);
        if (!root || !*root) continue;
        if (!isRoot(root)) throw Error("{}={}: that folder does not hold shaders/ and assets/", variable, root);
        static std::once_flag said;
        if (std::string_view(variable) == "TARN_ROOT")
            std::call_once(said, [] { log::warning("TARN_ROOT is now called TARN_DATA"); });
        return root;
    }
    std::error_code error;
    for (fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path(); !folder.empty();
         folder = folder.parent_path()) {
        if (isRoot(folder)) return folder;
        if (isRoot(folder / "share" / "tarn")) return folder / "share" / "tarn";
        if (folder == folder.root_path()) break;
    }
    if (isRoot(TARN_SOURCE_ROOT)) return TARN_SOURCE_ROOT;
    throw Error("the folders shaders/ and assets/ were not found; set TARN_DATA to the folder that holds them");
}

} // namespace tarn
