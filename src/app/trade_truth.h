// The reference of each view and time that `tarn trade` judges frames by.
#pragma once

#include "app/scene_setup.h"
#include "measure/error_figures.h"
#include "measure/water_errors.h"
#include "reference/reference.h"
#include "scene/image.h"

#include <filesystem>
#include <optional>

namespace tarn {

struct TruthArguments {
    ivec2 size{320, 240};         ///< pixels
    int samples = 96;             ///< paths through each pixel
    std::filesystem::path folder; ///< keeps the pictures for the next run; empty: nowhere
};

/// Traces a view when it is first asked for. Keeps one of them at a time: callers go view by view.
class TradeTruth {
public:
    /// Keeps a reference to the set-up.
    TradeTruth(const SceneSetup& sceneSetup, const TruthArguments& arguments);

    /// The figures of a frame against the truth. The frame must be without glow, which is an effect of the lens.
    ErrorFigures judge(const WaterQuantities& used, const Camera& camera, double time, const FrameOptions& options);

    /// As the viewer would show it.
    Image display(const Camera& camera, double time, const FrameOptions& options);

    const reference::Picture& picture(const Camera& camera, double time);
    const reference::Tracer& tracer() const { return tracer_; }
    const reference::ReferenceOptions& options() const { return options_; }

private:
    /// Light on the bed under the caustics texture of a frame of this view, or of one that is about as large.
    const TrueIrradiance& lightFor(const CausticsMap& map, double time);

    const SceneSetup& sceneSetup_;
    TruthArguments arguments_;
    WaterBody water_;
    reference::Tracer tracer_;
    reference::ReferenceOptions options_;
    struct Traced {
        Camera camera;
        double time = 0.0;
        reference::Picture picture;
        std::optional<vec4> rect; ///< that `light` knows
        TrueIrradiance light;
    };
    std::optional<Traced> kept_;
};

} // namespace tarn
