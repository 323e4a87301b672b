// What a target of the real-time frame shows, by rays: for the error budget. Private to src/reference.
#pragma once

#include "reference/approximations.h"
#include "reference/geometry.h"

namespace tarn::reference {

using glm::dmat3;

class TargetPicture {
public:
    /// Keeps a reference to the geometry.
    /// @param level,ior of the flat water that the camera may look through
    TargetPicture(const TargetCamera& camera, const Geometry& geometry, double level, double ior);

    struct Seen {
        Ray ray;                ///< its last leg
        std::optional<Hit> hit; ///< along that; empty: only the far plane
        dvec3 point;            ///< world, m
    };
    /// What stands at a position's pixel, before or behind it; past the picture's border, at its border.
    Seen seenAt(const dvec3& position) const;

    /// The middle of one of the four texels about a position, as deep in the picture as that, by chance of its
    /// bilinear weight.
    /// @param chance two numbers from 0 to 1
    dvec3 inTexel(const dvec3& position, int resolution, const dvec2& chance) const;

    /// W: where a ray from the surface meets what the picture shows, found as passes/water.frag finds it.
    /// @param A what the search takes for the point there
    dvec3 search(const dvec3& U, const dvec3& direction, int steps, bool planar, dvec3& A) const;
    /// W of a reflected ray.
    dvec3 searchMirrored(const dvec3& U, const dvec3& direction, int steps) const;

private:
    dvec3 inView(const dvec3& point) const { return dvec3(camera_.viewFromWorld * glm::dvec4(point, 1.0)); }
    dvec3 inWorld(const dvec3& point) const { return dvec3(worldFromView_ * glm::dvec4(point, 1.0)); }
    Seen alongLine(const dvec3& direction) const;
    Seen seenFrom(const Ray& ray, double from, double to) const;

    const TargetCamera& camera_;
    const Geometry& geometry_;
    glm::dmat4 worldFromView_;
    dvec3 eye_;
    double level_, ior_;
};

} // namespace tarn::reference
