#include "app/viewer/screenshot.h"

#include "base/error.h"

namespace tarn {

std::filesystem::path nextScreenshot(const std::filesystem::path& folder)
{
    for (int number = 1; number < 1000000; ++number) {
        std::filesystem::path file = folder / fmt::format("tarn-{:04}.png", number);
        std::error_code ignored;
        // A dangling link counts as taken too.
        if (!std::filesystem::exists(std::filesystem::symlink_status(file, ignored))) return file;
    }
    throw Error("{}: too many screenshots; clear some away", folder.string());
}

} // namespace tarn
