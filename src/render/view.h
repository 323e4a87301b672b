// The cameras of a frame: the main one, and those that the refraction and reflection targets are rendered from.
#pragma once

#include "optics/blocks.h"
#include "plan/options.h"
#include "plan/water_bounds.h"
#include "scene/scene.h"

#include <optional>

namespace tarn {

/// A camera ready for a pass. All in world space; metres.
struct View {
    mat4 viewFromWorld{1.0f};
    mat4 clipFromView{1.0f};
    vec3 eye{0.0f};
    vec4 clipPlane{0.0f};  ///< keeps what has dot(plane, (p, 1)) >= 0; zero keeps everything
    bool mirrored = false; ///< handedness is flipped, so front faces run clockwise
    float nearPlane = 0.1f, farPlane = 1000.0f;
    std::optional<float> flatWater; ///< level of a flat surface through which the eye, above it, sees what is below

    TargetBounds lookedUp; ///< the rest of its target need not be drawn

    /// By how much geometry may be off, m: for each metre of its distance from the eye, or anywhere in a parallel
    /// projection. 0: full detail.
    float geometryError = 0.0f;

    bool isParallel() const { return clipFromView[2][3] == 0.0f; }
    mat4 clipFromWorld() const { return clipFromView * viewFromWorld; }
    Frustum frustum() const; ///< of what is looked up, world space
    bool clips() const { return clipPlane != vec4(0.0f); }
};

View mainView(const Camera& camera, float aspect);

/// The refraction target's camera. Above the water: the underwater part, from a camera that is turned about the point
/// O by the angle of refraction (Mihálik 2008, eq. 1–2), stands where the main one does, or stands there and sees
/// through a flat surface (shaders/shared/refraction.glsl, flatApparent), which hides nothing that refraction shows.
/// Under water: what is above, as published from the main camera (section 7.5), else from where it would be at the
/// level, straight above: rays that leave the water at a small angle pass there, so that what hides what is theirs.
View refractionView(const Camera& camera, float aspect, const WaterBody& water, const Options& options,
                    bool underwater);

/// The main camera mirrored in the water's plane; sees what is above it, or below it for an eye under water.
View reflectionView(const Camera& camera, float aspect, const WaterBody& water, const ReflectionOptions& options,
                    bool underwater);

/// View::geometryError that moves nothing in the view's target by more than a number of pixels.
/// @param size of the target, pixels
float geometryErrorOf(const View& view, ivec2 size, float pixels);

/// @param size of the target, pixels
blocks::ViewBlock viewBlock(const View& view, ivec2 size);

} // namespace tarn
