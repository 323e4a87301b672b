#include "gl/workarounds.h"

#include "gl/context.h"

namespace tarn::gl {

bool avoidsAnisotropyWithSamples() { return capabilities().llvmpipe; }

std::vector<Workaround> workarounds()
{
    return {{"llvmpipe-msaa-anisotropy",
             "anisotropic filtering is off while frame.msaa is over 1: together they take tens of times as long",
             avoidsAnisotropyWithSamples()}};
}

} // namespace tarn::gl
