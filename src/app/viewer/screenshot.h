// Names of screenshots.
#pragma once

#include <filesystem>

namespace tarn {

/// The first of tarn-0001.png, tarn-0002.png … that does not exist in the folder.
std::filesystem::path nextScreenshot(const std::filesystem::path& folder);

} // namespace tarn
