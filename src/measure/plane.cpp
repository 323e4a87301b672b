#include "measure/plane.h"

#include <algorithm>

namespace tarn {

namespace {

/// sum[x] += weight * values[x]: the one loop that the time goes into, kept plain so that it is vectorised.
void addScaled(float* sum, const float* values, float weight, int count)
{
    for (int x = 0; x < count; ++x) sum[x] += weight * values[x];
}

} // namespace

Plane filterRows(const Plane& plane, const Kernel& kernel)
{
    Plane result(plane.width, plane.height);
    const int radius = radiusOf(kernel), width = plane.width;
    std::vector<float> padded(static_cast<std::size_t>(width + 2 * radius));
    for (int y = 0; y < plane.height; ++y) {
        const float* row = plane.row(y);
        std::fill_n(padded.begin(), radius, row[0]);
        std::copy_n(row, width, padded.begin() + radius);
        std::fill(padded.begin() + radius + width, padded.end(), row[width - 1]);
        for (std::size_t tap = 0; tap < kernel.size(); ++tap)
            addScaled(result.row(y), padded.data() + tap, kernel[tap], width);
    }
    return result;
}

Plane filterColumns(const Plane& plane, const Kernel& kernel, int halo)
{
    Plane result(plane.width, plane.height - 2 * halo);
    const int radius = radiusOf(kernel);
    for (int y = 0; y < result.height; ++y)
        for (int tap = -radius; tap <= radius; ++tap)
            addScaled(result.row(y), plane.row(y + halo + tap), kernel[static_cast<std::size_t>(tap + radius)],
                      plane.width);
    return result;
}

} // namespace tarn
