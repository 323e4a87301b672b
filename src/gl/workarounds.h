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

/// "llvmpipe-anisotropy": Mesa's software rasteriser (22.3 measured) walks every texel under a pixel of an anisotropic
/// texture, on the smallest level too: a picture repeated hundreds of times under a pixel takes minutes. With several
/// samples a pixel any picture takes tens of times as long.
bool avoidsAnisotropy();

} // namespace tarn::gl
