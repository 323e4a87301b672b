// The water's surface as rays meet it: the wave function itself, or the triangles that the viewer makes of it.
#pragma once

#include "optics/optics.h"
#include "optics/water_grid.h"
#include "optics/waves.h"
#include "reference/geometry.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace tarn::reference {

class WaterSurface {
public:
    using Grid = std::optional<optics64::WaterGrid>;

    /// @param grid nothing: the wave function, else the triangles that passes/water.vert makes of it
    /// @param normalGrid nothing: the waves' own normals, else those of the vertices of such a grid, in between them
    /// interpolated
    /// @param normalMap the picture of the body's normal map, which must outlive this; null: none
    WaterSurface(const WaterBody& water, double time, const Grid& grid = {}, const Grid& normalGrid = {},
                 const Image* normalMap = nullptr);

    /// Whether a point is over or under the water's rectangle.
    bool spans(double x, double z) const;
    /// Height of the surface, world y.
    double height(double x, double z) const;
    /// Whether a point lies in the water.
    bool contains(const dvec3& point) const;
    /// Unit, up; with the ripples of the normal map.
    dvec3 normal(double x, double z) const;
    /// A direction that leaves the surface for one side of it. Ripples are on no real surface, and may send what they
    /// mirror into it: the waves mirror that once more, as the passes have it.
    dvec3 keptOn(const dvec3& direction, const dvec3& U, bool above) const;

    /// Distance to the first place where a ray leaves its medium through the surface, with tMin < t < tMax: exact to
    /// 1e-5 m. The surface is a function of x and z that changes by less than Σ A k per metre, so that steps of
    /// distance / that bound cannot pass it (sphere tracing, Hart 1996); bracketed Newton's method ends the search.
    /// @param fromAbove the ray starts in the air
    std::optional<double> intersect(const Ray& ray, double tMin, double tMax, bool fromAbove) const;

    double level() const { return level_; }
    double amplitude() const { return amplitude_; } ///< the surface stays within level ± this
    dvec2 lower() const { return lower_; }
    dvec2 upper() const { return upper_; }

private:
    dvec3 waveNormal(double x, double z) const;
    dvec3 drawnNormal(double x, double z) const;
    dvec2 rippleSlope(double x, double z) const;
    double heightAbove(const dvec3& point) const;
    double polish(const Ray& ray, double t, double side) const;
    std::optional<double> intersectGrid(const Ray& ray, double tMin, double tMax, double side) const;

    std::vector<optics64::WaveTerm> waves_;
    double time_ = 0.0, level_ = 0.0, amplitude_ = 0.0;
    dvec2 lower_{0.0}, upper_{0.0};
    Grid grid_, normalGrid_;
    const Image* normalMap_ = nullptr;
    double tile_ = 1.0, bump_ = 1.0;           ///< of the normal map, m and factor
    std::array<dvec2, 4> offsets_{};           ///< of its layers
    std::array<std::vector<double>, 2> lines_; ///< where the grid's lines stand along x and z, m
};

} // namespace tarn::reference
