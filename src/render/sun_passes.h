// What the sun gives a frame: its shadow maps and the caustics, drawn where the plan wants them and an earlier frame
// did not leave them as they are.
#pragma once

#include "render/caustics_map.h"
#include "render/eye_frame.h"
#include "render/frame_context.h"
#include "render/passes/caustics.h"
#include "render/passes/sunlight.h"
#include "render/sun_views.h"

#include <optional>

namespace tarn {

class SunPasses {
public:
    explicit SunPasses(gl::ShaderLibrary& shaders);

    /// Before the first eye of a frame.
    void beginFrame() { hasSunlight_ = hasCaustics_ = isPlaced_ = false; }

    /// Finds what the maps of an eye's frame cover and uploads it. The maps are the same for both eyes: placed for the
    /// camera between them. In a frame that draws no lookups all stays as it is.
    void begin(const EyeFrame& eye, const FrameCache& cache);
    /// Draws the maps that are missing, and gives them to the scene renderer.
    void draw(const EyeFrame& eye, FrameContext& context);

    /// What of the sun's light the passes look up.
    const SceneVariant& lit() const { return lit_; }
    const SunVolume& volume() const { return volume_; }

    const gl::Target& caustics() const { return caustics_.target(); }
    /// The caustics texture as it is. Waits for the GPU.
    CausticsMap readCaustics(const WaterBody& water) const;

private:
    SunlightPass::Inputs sunlightInputs(const EyeFrame& eye) const;
    void drawSunlight(const EyeFrame& eye, FrameContext& context);
    void drawCaustics(const EyeFrame& eye, const CausticsKey& key, FrameContext& context);

    gl::UniformBuffer<blocks::SunBlock> block_;
    SunlightPass sunlight_;
    CausticsPass caustics_;
    SunVolume volume_;
    vec3 toSunBelow_{0.0f}; ///< the refracted sun's direction in the last frame
    CausticsRegion region_;
    SceneVariant lit_;
    bool hasSunlight_ = false;       ///< this frame's maps of the sun are drawn, or kept
    bool isPlaced_ = false;          ///< this frame's region_ is known
    bool usesCausticsAgain_ = false; ///< this frame looks up those of an earlier one
    bool hasCaustics_ = false;       ///< this frame's caustics are drawn; they are the same for both eyes
};

/// Foliage by chance of its share of a pixel is right in the mean of several pixels, and noise where one must do.
inline bool dithersCutOuts(const FrameOptions& options) { return options.scale >= 2.0f; }

} // namespace tarn
