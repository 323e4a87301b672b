#include "gl/workarounds.h"

#include "gl/context.h"

namespace tarn::gl {

bool avoidsAnisotropy() { return capabilities().llvmpipe; }

std::vector<Workaround> workarounds()
{
    return {{"llvmpipe-anisotropy",
             "anisotropic filtering is off: where textures repeat far away a picture would take minutes",
             avoidsAnisotropy()}};
}

} // namespace tarn::gl
