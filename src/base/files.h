// Files: read whole, written whole or not at all, and found beside the program.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace tarn {

/// The whole file. Throws Error when it is missing, a directory or unreadable.
std::string readFile(const std::filesystem::path& file);

/// Calls `write` with a temporary name in the same folder (same extension) and moves it into place when that returns;
/// removes it when it throws. Throws Error when the folder is missing or cannot be written.
void writeWhole(const std::filesystem::path& file,
                const std::function<void(const std::filesystem::path& temporary)>& write);

/// writeWhole for text.
void writeFile(const std::filesystem::path& file, std::string_view text);

/// writeWhole for a folder: `write` fills a temporary one beside it, which then takes the place of all that `folder`
/// held. Throws Error when its parent is missing or cannot be written.
void replaceFolder(const std::filesystem::path& folder,
                   const std::function<void(const std::filesystem::path& temporary)>& write);

/// The folder and those above it, where they are missing. Throws Error when one cannot be made.
void makeFolder(const std::filesystem::path& folder);

/// The folder that holds shaders/ and assets/: $TARN_DATA, else found upward from the program, else the source
/// folder it was built from. Throws Error when there is none.
std::filesystem::path projectRoot();

} // namespace tarn
