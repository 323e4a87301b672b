// Presets: files of options that come with the program, assets/presets/NAME.toml. ladder.toml beside them is none
// (app/ladder_file.h).
#pragma once

#include "base/fields.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tarn {

/// From the cheapest to the most accurate, then the others: "fast", "low", "medium", "high", "best", "thesis".
std::vector<std::string> presetNames();

/// Its file, in the format of --options. Throws UsageError with the nearest name when there is none.
std::filesystem::path presetFile(const std::string& name);

/// What stands for "auto" on a machine.
struct MachinePreset {
    std::string name;
    std::string why; ///< "llvmpipe draws on the processor: fast"
};
MachinePreset presetForMachine(const std::string& renderer, bool isSoftware);

} // namespace tarn
