#include "measure/error_map.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tarn
{

namespace
{

/// Black, violet, red, orange, yellow, white over 0 to 1: brighter is always more.
vec3 heat(double x)
{
    static constexpr vec3 stops[] = {{0.0f, 0.0f, 0.02f}, {0.34f, 0.06f, 0.43f}, {0.73f, 0.21f, 0.33f},
                                     {0.98f, 0.55f, 0.04f}, {0.96f, 0.86f, 0.32f}, {1.0f, 1.0f, 0.94f}};
    constexpr int last = static_cast<int>(std::size(stops)) - 1;
    const double place = std::clamp(x, 0.0, 1.0) * last;
    const int below = std::min(static_cast<int>(place), last - 1);
    return glm::mix(stops[below], stops[below + 1], static_cast<float>(place - below));
}

} // namespace

Image errorMap(ErrorKind kind, const WaterQuantities& used, const reference::Picture& truth)
{
    if (used.size != truth.size)
        throw Error("a picture of {}x{} pixels cannot be compared with a reference of {}x{}", used.size.x,
                    used.size.y, truth.size.x, truth.size.y);
    Image map;
    map.name = std::string(infoOf(kind).name) + " error";
    map.width = used.size.x;
    map.height = used.size.y;
    map.channels = 1;
    map.floats.reserve(used.pixels());
    for (std::size_t pixel = 0; pixel < used.pixels(); ++pixel) {
        const std::optional<double> error = errorAt(kind, used, truth, pixel);
        map.floats.push_back(error ? static_cast<float>(*error) : std::numeric_limits<float>::quiet_NaN());
    }
    return map;
}

Image heatPicture(const Image& map, double scale)
{
    constexpr vec3 grey(0.4f);
    Image picture;
    picture.name = map.name;
    picture.width = map.width;
    picture.height = map.height;
    picture.channels = 3;
    picture.bytes.reserve(picture.size());
    for (const float error : map.floats) {
        const vec3 colour = std::isnan(error) ? grey : heat(static_cast<double>(error) / scale);
        for (int c = 0; c < 3; ++c)
            picture.bytes.push_back(static_cast<std::uint8_t>(std::lround(255.0f * colour[c])));
    }
    return picture;
}

} // namespace tarn
