// Presets: files of options that come with the program, assets/presets/NAME.toml.
#pragma once

#include "base/fields.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tarn {

/// From the cheapest to the most accurate, then the others: "low", "medium", "high", "best", "thesis".
std::vector<std::string> presetNames();

/// Its file, in the format of --options. Throws UsageError with the nearest name when there is none.
std::filesystem::path presetFile(const std::string& name);

} // namespace tarn
