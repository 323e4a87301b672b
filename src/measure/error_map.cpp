#include "measure/error_map.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tarn {

Image errorMap(ErrorKind kind, const WaterQuantities& used, const reference::Picture& truth)
{
    if (used.size != truth.size)
        throw Error("a picture of {}x{} pixels cannot be compared with a reference of {}x{}", used.size.x, used.size.y,
                    truth.size.x, truth.size.y);
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

} // namespace tarn
