// Names of output files, and whether they can be written, found out before any time is spent on rendering.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tarn {

/// Throws UsageError when `file` does not end in .png or .exr, and Error when its folder does not exist or
/// cannot be written, or when `file` is a folder.
void requireWritablePicture(const std::filesystem::path& file);

/// Throws Error when the folder does not exist or cannot be written.
void requireWritableFolder(const std::filesystem::path& folder);

/// The files of a sequence: "name_%04d.png" gives name_0000.png, name_0001.png … The number may stand as %d
/// or %0Nd, once. A name without it does for a single frame. Throws UsageError otherwise.
std::vector<std::filesystem::path> sequenceFiles(const std::string& pattern, int frames);

/// A name made fit for a file: letters, digits, '-', '_' and '.' stay, each run of others becomes one '-'.
std::string fileNameFrom(const std::string& name);

} // namespace tarn
