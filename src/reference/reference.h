// Ground truth: pictures and per-pixel quantities of a view by ray tracing.
//
//     reference::Tracer tracer(scene, scene.water);
//     const reference::Picture truth = tracer.render({camera, 1.5, {640, 480}}, options);
//
// The scene description is the viewer's; of the passes nothing is shared but shaders/shared.
#pragma once

#include "reference/approximations.h"
#include "reference/options.h"
#include "reference/picture.h"
#include "scene/scene.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>

namespace tarn {
class Progress;
}

namespace tarn::reference {

struct ViewRequest {
    Camera camera;
    double time = 0.0;    ///< s
    ivec2 size{640, 480}; ///< pixels
    /// > 0: the surface that the eye sees is what the viewer's grid draws of it, and its normals are those of a grid's
    /// vertices, interpolated. The sun's light goes through the waves themselves, as in the viewer.
    int gridSize = 0, normalGridSize = 0;
    bool gridFocused = false; ///< whether these grids are focused on the view (water.grid)
    bool flatLight = false;   ///< the sun's light under water as a flat surface lets it through
    /// The sun's light under water as a texture over a part of the level holds it; beside it that of a flat surface.
    struct CausticsTexture {
        vec4 rect{0.0f};    ///< centre x, z and half extent, m
        double texel = 0.1; ///< m
        int filter = 0;     ///< radius, texels
    };
    std::optional<CausticsTexture> causticsTexture{};
    Approximations approximations{};
};

/// What it took and how far it can be trusted; also in the picture's metadata.
struct TraceReport {
    double seconds = 0.0;
    double truncatedFraction = 0.0; ///< upper bound of the mean share of a pixel's light that was not followed
    double causticsNoise = 0.0;     ///< standard error of the sun's light under water, of its mean
    double lostPhotons = 0.0;       ///< share that met no bed
    std::size_t photons = 0;
    double radianceNoise = 0.0; ///< standard error of the pixels' mean luminance, RMS, of the mean luminance
};

/// Where unfinished work is kept, so that it can go on: samples are added in the same order either way, so that an
/// interrupted picture ends bit for bit as an uninterrupted one.
struct Checkpoint {
    std::filesystem::path file; ///< empty: none
    double everySeconds = 60.0;
    const std::atomic<bool>* interrupt = nullptr; ///< when it becomes true: save and throw Interrupted
};

/// The work was stopped from outside; what was done is in the checkpoint.
class Interrupted : public std::exception {
public:
    const char* what() const noexcept override { return "interrupted"; }
};

class Tracer {
public:
    /// Keeps references to both.
    Tracer(const Scene& scene, const WaterBody& water, float sunSlopeDeviation = 0.02f);
    ~Tracer();

    /// Deterministic for the options' seed, whatever the number of threads. Throws Error for a checkpoint of another
    /// picture, and Interrupted.
    Picture render(const ViewRequest& view, const ReferenceOptions& options, Progress* progress = nullptr,
                   const Checkpoint& checkpoint = {}, TraceReport* report = nullptr) const;

    /// One picture of each; neighbours share the sun's light under water where it is the same. Where seeds are equal so
    /// are all random numbers, and two pictures differ by what was asked for alone.
    struct Request {
        ViewRequest view;
        ReferenceOptions options;
    };
    std::vector<Picture> renderAll(const std::vector<Request>& requests, Progress* progress = nullptr) const;

    /// Everything that a picture depends on but its number of samples; also its header's "tarn:reference".
    std::string identity(const ViewRequest& view, const ReferenceOptions& options) const;

    /// Only the quantities (no radiance), with the sun's light under water where options.photons > 0 asks for it.
    Picture quantities(const ViewRequest& view, const ReferenceOptions& options, Progress* progress = nullptr) const;

    /// The sun's light on the bed below a rectangle of the level plane (centre x, z and half extent, m): for a place
    /// (x, z) of the plane, that on the first thing which light along the refracted sun meets there, as
    /// SunMap::relativeIrradiance. Nothing beside the rectangle and the water, or where no ground is met.
    /// The function refers to the tracer.
    /// @param texel over which light is counted, m
    std::function<std::optional<vec3>(const vec2& plane)> lightOnBed(double time, const vec4& rect, double texel,
                                                                     int photons, int seed) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace tarn::reference
