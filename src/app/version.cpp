#include "app/version.h"

namespace tarn {

const char* versionText() { return TARN_VERSION; }

const char* buildText() { return TARN_BUILD; }

} // namespace tarn
