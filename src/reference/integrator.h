// Radiance along a ray: water as a surface that reflects and refracts, everything else as scene.frag shades it, with
// true shadows and traced caustics. The convention is the design's: radiance changes by 1/n² and n² at the surface.
#pragma once

#include "reference/approximations.h"
#include "reference/geometry.h"
#include "reference/light.h"
#include "reference/options.h"
#include "reference/picture.h"
#include "reference/random.h"
#include "reference/sun_map.h"
#include "reference/water_surface.h"

namespace tarn::reference {

/// All that rays run through. References: what they refer to must outlive it.
struct World {
    const Geometry& geometry;
    const WaterSurface* water; ///< null: none
    const Light& light;
    const SunMap& sunMap;            ///< empty where the light under water is that of a flat surface
    float sunSlopeDeviation = 0.02f; ///< slope deviation of the waves that the scene does not model
    ReferenceOptions options;
    Approximations approximations;
};

class Integrator {
public:
    explicit Integrator(const World& world) : world_(world) {}

    /// @param pixelAngle of the pixel that the ray stands for, rad
    /// @param truncated what of the light was not followed further is added here, as a share of all
    vec3 radiance(const Ray& ray, double pixelAngle, Random& random, double& truncated) const;

    /// Where under water a ray's picture asks for the sun's light.
    void lightQueries(const Ray& ray, double pixelAngle, std::vector<LightQuery>& queries) const;

    /// What a pixel's central ray meets, into a picture's planes.
    void quantities(const Ray& ray, double pixelAngle, Picture& picture, std::size_t pixel) const;

private:
    enum class Medium { air, water };
    struct PathState {
        Random& random;
        double& truncated;
        double pixelAngle;
        double length = 0.0;        ///< m behind the eye, for the size of a pixel
        double weight = 1.0;        ///< upper bound of what the ray can add to the pixel
        int events = 0;             ///< meetings with the surface
        int bounces = 0;            ///< diffuse reflections
        bool showsSun = true;       ///< the sun's disc is seen where the ray ends in the sky
        bool fadesLinearly = false; ///< on its way from the surface to the bed: an approximation
        bool isIndirect = false;    ///< light that a surface gathers: sky and sun are counted elsewhere
    };
    struct Meeting {
        double distance;
        std::optional<Hit> hit; ///< of the scene; empty: the water's surface
    };

    std::optional<Meeting> nearest(const Ray& ray, Medium medium) const;
    vec3 incomingRadiance(const Ray& ray, Medium medium, PathState path) const;
    vec3 atSurface(const Ray& ray, double distance, Medium medium, PathState path) const;
    vec3 fromAbove(const Ray& ray, const dvec3& U, PathState path) const;
    vec3 fromBelow(const Ray& ray, const dvec3& U, PathState path) const;
    dvec3 towardsTexel(const TargetTexels& texels, const dvec3& U, const dvec3& direction, Random& chance) const;
    dvec3 shadowUv(const ShadowTexels& map, const SurfacePoint& point, const dvec2& chance) const;
    vec3 lookUpBed(const dvec3& U, const dvec3& refracted, PathState path) const;
    vec3 lookUpMirrored(const dvec3& U, dvec3 reflected, PathState path) const;
    vec3 shade(const Ray& ray, const Hit& hit, Medium medium, PathState path) const;
    vec3 sunInAir(const SurfacePoint& point, const vec3& toEye, PathState& path) const;
    vec3 sunInWater(const SurfacePoint& point, const vec3& toEye, double footprint) const;
    vec3 indirect(const SurfacePoint& point, Medium medium, PathState path) const;
    double reflectance(double cosine) const;
    vec3 letThrough(double path, bool fadesLinearly) const;
    vec3 glint(const dvec3& U, const dvec3& n, const vec3& toEye) const;
    vec3 skyAlong(const dvec3& direction, const PathState& path) const;
    std::optional<vec3> causticsAt(const dvec3& position, double footprint) const;
    Medium mediumAt(const dvec3& point) const;

    const World& world_;
};

} // namespace tarn::reference
