#include "measure/display.h"

#include "base/error.h"
#include "optics/optics.h"

#include <cmath>

namespace tarn {

namespace {

void requireLinear(const Image& image)
{
    if (!image.isFloat() || image.channels < 3 || image.floats.size() != image.size())
        throw Error("{}: a linear picture of red, green and blue is wanted", image.name);
}

vec3 toneMapped(const vec3& colour, FrameOptions::ToneCurve curve)
{
    switch (curve) {
    case FrameOptions::ToneCurve::linear: return optics::toneLinear(colour);
    case FrameOptions::ToneCurve::reinhard: return optics::toneReinhard(colour);
    case FrameOptions::ToneCurve::aces: break;
    }
    return optics::toneAces(colour);
}

/// Calls `use` with the first three channels of each pixel.
template <typename Use> void forPixels(const Image& image, const Use& use)
{
    const auto channels = static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0; i + 2 < image.floats.size(); i += channels)
        use(vec3(image.floats[i], image.floats[i + 1], image.floats[i + 2]));
}

} // namespace

Image exposedPicture(const Image& linear, float exposure)
{
    requireLinear(linear);
    Image result{linear.name, linear.width, linear.height, 3, {}, {}};
    result.floats.reserve(result.size());
    forPixels(linear, [&](const vec3& radiance) {
        for (int i = 0; i < 3; ++i) result.floats.push_back(exposure * radiance[i]);
    });
    return result;
}

Image displayPicture(const Image& exposed, FrameOptions::ToneCurve curve)
{
    requireLinear(exposed);
    Image result{exposed.name, exposed.width, exposed.height, 3, {}, {}};
    result.bytes.reserve(result.size());
    forPixels(exposed, [&](const vec3& colour) {
        const vec3 shown = optics::srgbColour(toneMapped(colour, curve));
        for (int i = 0; i < 3; ++i) result.bytes.push_back(static_cast<std::uint8_t>(std::lround(255.0f * shown[i])));
    });
    return result;
}

} // namespace tarn
