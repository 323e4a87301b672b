// One channel of a strip of a picture as floats, and separable filters over it.
#pragma once

#include <cstddef>
#include <vector>

namespace tarn {

/// Rows run from top to bottom, like Image.
struct Plane {
    int width = 0, height = 0;
    std::vector<float> values;

    Plane() = default;
    Plane(int planeWidth, int planeHeight)
        : width(planeWidth), height(planeHeight),
          values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    {}
    float* row(int y) { return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width); }
    const float* row(int y) const { return const_cast<Plane*>(this)->row(y); }
};

/// Weights at the pixels -radius … radius; their count is odd.
using Kernel = std::vector<float>;

inline int radiusOf(const Kernel& kernel) { return static_cast<int>(kernel.size() / 2); }

/// Each row with the kernel; left and right of the plane stands its border's pixel.
Plane filterRows(const Plane& plane, const Kernel& kernel);

/// Each column with the kernel, without the first and last `halo` rows, which are only read: at least the
/// kernel's radius of them, and fewer than half the plane's.
Plane filterColumns(const Plane& plane, const Kernel& kernel, int halo);

} // namespace tarn
