// The scene's triangles as rays find them, and what stands at a hit: the same materials as passes/scene.frag shades,
// sampled bilinearly at full resolution (many rays a pixel do the filtering).
#pragma once

#include "scene/scene.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace tarn::reference {

using glm::dvec2;
using glm::dvec3;

struct Ray {
    dvec3 origin;    ///< world, m
    dvec3 direction; ///< unit
};

/// A place where a ray meets a triangle.
struct Hit {
    double distance = 0.0; ///< m
    unsigned instance = 0, triangle = 0;
    float u = 0.0f, v = 0.0f; ///< barycentric, of the second and third corner
};

/// What stands there.
struct SurfacePoint {
    dvec3 position;
    vec3 geometricNormal; ///< unit, towards the ray's origin
    vec3 normal;          ///< shading normal as scene.frag has it
    vec3 albedo;          ///< diffuse reflectance
    vec3 emitted;         ///< radiance
    const Material* material = nullptr;
};

/// Which triangles a ray sees.
enum class Sides : unsigned {
    asDrawn, ///< one-sided materials only from the front, as the viewer draws them
    both,    ///< what stands in the way of light
};

class Geometry {
public:
    /// Keeps a reference to the scene. Throws Error when Embree fails.
    explicit Geometry(const Scene& scene);
    ~Geometry();
    Geometry(const Geometry&) = delete;
    Geometry& operator=(const Geometry&) = delete;

    /// The nearest hit with tMin < distance < tMax. Alpha-tested surfaces are there where their alpha reaches the
    /// cutoff. Thread-safe, like all of these.
    std::optional<Hit> intersect(const Ray& ray, double tMin, double tMax, Sides sides = Sides::asDrawn) const;

    /// Whether anything stands between two distances, seen from both sides.
    bool occluded(const Ray& ray, double tMin, double tMax) const;

    SurfacePoint surfaceAt(const Ray& ray, const Hit& hit) const;

    const Bounds& bounds() const { return bounds_; }

private:
    struct State;
    std::unique_ptr<State> state_;
    Bounds bounds_;
};

} // namespace tarn::reference
