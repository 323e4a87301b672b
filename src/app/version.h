// Which Tarn this is.
#pragma once

namespace tarn {

/// "0.1.0"
const char* versionText();

/// "Release, GCC 12.2.0"
const char* buildText();

} // namespace tarn
