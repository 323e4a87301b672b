// Reads a file that `tarn trade --write-ladder` wrote.
#pragma once

#include "plan/ladder.h"

#include <filesystem>

namespace tarn {

/// The ladder that comes with the program.
std::filesystem::path shippedLadder();

/// Throws Error with file, line and what is wrong: TOML that is none, unknown or missing keys, options that are none,
/// costs that do not fall and errors that do.
Ladder readLadder(const std::filesystem::path& file);

} // namespace tarn
