#include "optics/fresnel_table.h"

#include "optics/optics.h"

#include <algorithm>
#include <cmath>

namespace tarn::optics {

FresnelTable makeFresnelTable(float ior, int size, TableFilter filter)
{
    FresnelTable table{filter, {}};
    const double eta = 1.0 / static_cast<double>(ior);
    for (int i = 0; i < size; ++i) {
        const double cosine = optics64::fresnelTableCosine(i, size, filter == TableFilter::linear);
        const double reflectance = optics64::fresnelExact(cosine, eta);
        table.texels.emplace_back(1.0 - reflectance, reflectance);
    }
    return table;
}

vec2 FresnelTable::at(float cosine) const
{
    const int size = static_cast<int>(texels.size());
    const bool blends = filter == TableFilter::linear;
    const float coordinate =
        fresnelTableCoordinate(cosine, size, blends) * static_cast<float>(size) - (blends ? 0.5f : 0.0f);
    const int first = std::clamp(static_cast<int>(std::floor(coordinate)), 0, size - 1);
    if (!blends) return texels[static_cast<std::size_t>(first)];
    const int second = std::min(first + 1, size - 1);
    return glm::mix(texels[static_cast<std::size_t>(first)], texels[static_cast<std::size_t>(second)],
                    std::clamp(coordinate - static_cast<float>(first), 0.0f, 1.0f));
}

} // namespace tarn::optics
