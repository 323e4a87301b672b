#include "measure/heat.h"

#include "base/error.h"
#include "measure/colour.h"
#include "optics/optics.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tarn {

namespace {

/// A place on the way through the colours.
struct Stop {
    float hue;    ///< degrees in CIELAB's a*, b* plane
    float chroma; ///< as much as sRGB has at this hue and lightness, and a little less
};
// At x = 0, 1/8, 2/8 … 1. The hues are those that such maps usually take, from night to fire; the chroma is
// near the edge of the gamut, found by trying.
constexpr std::array stops{Stop{290.0f, 0.0f},  Stop{302.0f, 36.0f}, Stop{314.0f, 60.0f},
                           Stop{335.0f, 62.0f}, Stop{360.0f, 62.0f}, Stop{385.0f, 60.0f},
                           Stop{415.0f, 54.0f}, Stop{440.0f, 50.0f}, Stop{465.0f, 14.0f}};

Stop stopAt(float x)
{
    const float position = x * static_cast<float>(stops.size() - 1);
    const std::size_t below = std::min(static_cast<std::size_t>(position), stops.size() - 2);
    const float fraction = position - static_cast<float>(below);
    return {glm::mix(stops[below].hue, stops[below + 1].hue, fraction),
            glm::mix(stops[below].chroma, stops[below + 1].chroma, fraction)};
}

constexpr vec3 nothingMeasured(0.5f);

} // namespace

vec3 heatColour(double x)
{
    if (std::isnan(x)) return nothingMeasured;
    const float position = static_cast<float>(std::clamp(x, 0.0, 1.0));
    const Stop stop = stopAt(position);
    const float hue = glm::radians(stop.hue);
    const vec3 lab(98.0f * position, stop.chroma * std::cos(hue), stop.chroma * std::sin(hue));
    return optics::srgbColour(rgbFromRelative() * relativeFromLab(lab));
}

Image heatPicture(const Image& oneChannel, double lower, double upper)
{
    if (oneChannel.channels != 1 || !oneChannel.isFloat() || oneChannel.floats.size() != oneChannel.size())
        throw Error("{}: a picture of one float channel is wanted", oneChannel.name);
    if (!(lower < upper)) throw Error("{}: no colours from {} to {}", oneChannel.name, lower, upper);
    Image result{oneChannel.name, oneChannel.width, oneChannel.height, 3, {}, {}};
    result.bytes.reserve(result.size());
    for (const float value : oneChannel.floats) {
        const vec3 colour = heatColour((static_cast<double>(value) - lower) / (upper - lower));
        for (int i = 0; i < 3; ++i) result.bytes.push_back(static_cast<std::uint8_t>(std::lround(255.0f * colour[i])));
    }
    return result;
}

} // namespace tarn
