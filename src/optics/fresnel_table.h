// Fresnel's formula as a table over the cosine of incidence (shaders/shared/fresnel_table.glsl): filled for the GPU,
// and looked up here as the GPU does.
//
//     const FresnelTable table = makeFresnelTable(1.33f, 1024, TableFilter::nearest);
//     const float reflectance = table.at(cosine).y;
//
// The largest error is at grazing incidence, where the formula is steepest. For n = 1.33 and N texels it is
// (1 + n²) / (N √(n² − 1)) = 3.2 / N for the nearest texel and (1 + n⁴) / ((n² − 1) (N − 1)²) = 5.4 / (N − 1)² for
// blended ones.
#pragma once

#include "base/math.h"

#include <vector>

namespace tarn::optics {

enum class TableFilter { nearest, linear };

struct FresnelTable {
    TableFilter filter = TableFilter::nearest;
    std::vector<vec2> texels; ///< transmittance and reflectance of unpolarised light from the air

    /// Transmittance and reflectance at a cosine, which is held to 0..1.
    vec2 at(float cosine) const;
};

/// @param ior of the water, relative to air   @param size at least 2
FresnelTable makeFresnelTable(float ior, int size, TableFilter filter);

} // namespace tarn::optics
