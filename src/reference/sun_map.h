// The sun's light under water, traced: photons from the sun through the true surface onto what they meet first.
//
// A photon map in the coordinates of shaders/shared/sunlight.glsl: a point belongs to the place where light along the
// refracted sun would have entered. That is only a way to number the places of the bed; photons go where Snell's law
// sends them. Since the sun's flux through a cell of that plane is known, the flux that arrives in a texel over the
// texel's area is the irradiance, and no normal or area of the bed has to be known. Texels keep apart what lies at
// different heights (a leaf and the bed in its shade).
#pragma once

#include "reference/light.h"
#include "reference/water_surface.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace tarn {
class Progress;
}

namespace tarn::reference {

/// A place under water that a picture will ask for, and how large a pixel is there.
struct LightQuery {
    dvec3 position;
    double footprint; ///< m
};

class SunMap {
public:
    struct Inputs {
        const Geometry& geometry;
        const WaterSurface& water;
        const Light& light;
        int photons;
        int seed;
    };

    /// Nothing is known: relativeIrradiance is empty everywhere.
    SunMap() = default;

    /// Traces photons where the queries need them: several maps, each with texels as fine as the pixels that look
    /// there (5 mm to 8 cm), or as the photons allow. Deterministic for a seed whatever the number of threads.
    SunMap(const Inputs& inputs, const std::vector<LightQuery>& queries, Progress* progress);

    /// One map with texels of a given size over a rectangle of the level plane (centre x, z and half extent): for
    /// whole-map comparisons.
    /// @param filter radius in texels of a binomial filter over what lookups give, as the viewer's caustics texture has
    SunMap(const Inputs& inputs, const vec4& rect, double texel, Progress* progress, int filter = 0);

    /// The sun's light through a level area at a point, relative to the same above the water: the unit of the
    /// viewer's caustics texture. Empty where no photon was sent.
    std::optional<vec3> relativeIrradiance(const dvec3& point, double footprint) const;

    /// The standard error of what relativeIrradiance gives, relative to the map's mean, RMS over the lit texels of all
    /// maps: from two halves of the photons.
    double noise() const;
    std::size_t photonCount() const { return photons_; }
    /// Share of the photons that entered the water and met nothing.
    double lostFraction() const;

private:
    /// The part of a texel's light that arrives between two heights.
    struct Entry {
        std::int32_t layer;
        vec3 first, second; ///< flux per area, of either half of the photons
    };
    struct Map {
        dvec2 lower{0.0};
        double texel = 0.01; ///< m
        ivec2 size{0};
        std::vector<std::uint32_t> begin; ///< of each texel's entries; one more at the end
        std::vector<Entry> entries;
    };
    struct Landing;

    void trace(const Inputs& inputs, Map& map, std::size_t photons, const std::function<void(double)>& report);
    void fold(Map& map, std::vector<Landing>& landings, const Light& light, double cellArea) const;
    std::optional<vec3> unfiltered(const dvec3& point, double footprint) const;
    static vec3 sumAt(const Map& map, ivec2 texel, int layer, int half);

    std::vector<Map> maps_; ///< finest first
    dvec2 slant_{0.0};      ///< of the refracted sun
    double level_ = 0.0;
    int filter_ = 0;
    std::size_t photons_ = 0, entered_ = 0, lost_ = 0;
};

} // namespace tarn::reference
