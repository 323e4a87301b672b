// The approximations of the real-time frame, one by one, made inside the reference: for the error budget.
#pragma once

#include "base/math.h"
#include "optics/fresnel_table.h"

#include <optional>
#include <vector>

namespace tarn::reference {

/// The camera of one of the frame's targets. Rays stand for its texels, so that it sees all that they could
/// hold.
struct TargetCamera {
    glm::dmat4 viewFromWorld{1.0}; ///< looks along -z; may mirror
    glm::dvec2 tangents{1.0};      ///< of half its field of view, across and up
    double farPlane = 1000.0;      ///< m; what is farther is not there
    double clipLevel = 0.0;        ///< world y at which what it draws begins or ends, m
    bool keepsAbove = false;       ///< it draws what stands over that level, else what lies under it
    bool throughFlatWater = false; ///< its rays are refracted by a flat surface at the water's level
};

/// The grid of a target's texels, laid over the truth.
struct TargetTexels {
    TargetCamera camera;
    int resolution = 512; ///< texels
};

/// The sun's depth map over the water's level (shaders/passes/sun_maps.glsl); rays stand for its depths.
struct ShadowTexels {
    struct Cascade {
        glm::dvec4 rect{0.0}; ///< centre x, z and half extent, m
        double bias = 0.02;   ///< m
    };
    std::vector<Cascade> cascades; ///< finest first
    int resolution = 2048;         ///< texels of each
    int taps = 2;                  ///< comparisons along one edge of its filter
};

/// Everything off is the truth. Each is what the viewer does, at the viewer's parameters but with rays in
/// place of textures, so that only the named thing is approximate. All concern what the eye sees of the
/// surface from above, at its ray's first meeting with it.
struct Approximations {
    float schlickExponent = 0.0f;   ///< > 0: Fresnel by Schlick
    float attenuationLength = 0.0f; ///< > 0: the bed fades linearly over so many metres from the surface
    std::optional<optics::FresnelTable> fresnelTable; ///< Fresnel from a table

    std::optional<TargetCamera> refraction; ///< the bed is what this camera sees where W is
    int refractionSteps = 0;       ///< depth samples that the search for W takes (Mihálik 2008, 7.1); 0: the true W
    bool planarRefraction = false; ///< the first approximation stands for the search

    std::optional<TargetCamera> reflection; ///< what is mirrored is what this camera sees
    int reflectionSteps = 0;                ///< depth samples of the search; 0: at `reflectionDistance` instead
    double reflectionDistance = 1.0;        ///< c of W = U + cR (eq. 6), m

    std::optional<TargetTexels> refractionTexels,
        reflectionTexels;                ///< rays end in the middle of a texel near W
    std::optional<ShadowTexels> shadows; ///< of the sun over the water, wherever the eye looks
};

} // namespace tarn::reference
