#include "render/pixel_check.h"

#include <cmath>

namespace tarn {

BadPixels countBadPixels(std::string pass, std::span<const float> rgba)
{
    BadPixels bad;
    bad.pass = std::move(pass);
    for (std::size_t i = 0; i < rgba.size(); ++i) {
        if (i % 4 == 3) continue;
        if (std::isnan(rgba[i]))
            ++bad.nan;
        else if (std::isinf(rgba[i]))
            ++bad.infinite;
        else if (rgba[i] < 0.0f)
            ++bad.negative;
    }
    return bad;
}

BadPixels checkTarget(std::string pass, const gl::Target& target)
{
    target.resolve();
    return countBadPixels(std::move(pass), target.framebuffer().readFloats());
}

} // namespace tarn
