// What particular drivers need done differently. Each has a name and a reason; `tarn info` lists those in force.
#pragma once

#include <vector>

namespace tarn::gl {

struct Workaround {
    const char* name;
    const char* reason;
    bool active; ///< for the current context
};

/// All that there are.
std::vector<Workaround> workarounds();

/// "llvmpipe-msaa-anisotropy": Mesa's software rasteriser (22.3 measured) takes tens of times as long for a
/// multisampled draw with anisotropic filtering as for either alone.
bool avoidsAnisotropyWithSamples();

} // namespace tarn::gl
