// Draws the static scene and its sky from any view: what the scene, refraction and reflection passes share.
#pragma once

#include "gl/profiler.h"
#include "gl/shader_library.h"
#include "gl/state.h"
#include "render/frame.h"
#include "render/gpu_scene.h"

#include <map>
#include <memory>
#include <optional>

namespace tarn {

/// How a view of the scene differs from the plain one.
struct SceneVariant {
    bool underwaterEye = false;             ///< between eye and submerged things there is water
    const gl::Texture* waterline = nullptr; ///< or only where this says so, pixel by pixel (passes/waterline.h)
    bool sunDisc = false;                   ///< the sky shows the sun itself
    bool alphaToCoverage = false;           ///< the target has several samples: foliage edges use them
    bool dithersCutOuts = false; ///< foliage is there by chance of its share of a pixel: pixels' means are what counts
    bool debugNormals = false;   ///< world-space normals in place of radiance
    bool shadows = false;        ///< sunlight is looked up in the shadow maps
    bool caustics = false;       ///< and what reaches the bed in the caustics texture
    bool throughFlatWater = false; ///< what lies under the level is drawn where a flat surface shows it
    bool depthOnly = false;        ///< no colour
    bool depthFirst =
        false; ///< cut-outs are drawn twice, first their depth alone: what is hidden is not shaded. One sample only
    bool depthIsDrawn = false; ///< the second of the two: where the depth is equal, a cut-out is there
    bool bothSides = false;    ///< faces are there seen from behind, too: whatever side the sun sees casts a shadow
    bool forMap = false;       ///< all but the sun's light under water, and beside it how that would be answered
    bool countsFaces = false;  ///< adds 1 for each face that is seen from the front and takes 1 for each from behind
    std::optional<gl::PixelRect> scissor{}; ///< beside it nothing is drawn
    bool sky = true;                        ///< fill what no geometry covers with the sky (or, under water, with water)
};

/// What the sun's light is looked up in. Null: not there, and not asked for by any variant.
struct SunMaps {
    const gl::Texture* depth = nullptr;    ///< of SunlightPass
    const gl::Texture* caustics = nullptr; ///< irradiance on the bed relative to the sun's above the water
    int taps = 2;                          ///< comparisons along an edge of the shadow filter
};

class SceneRenderer {
public:
    SceneRenderer(const GpuScene& scene, gl::ShaderLibrary& shaders);

    /// Compiles what the scene's materials need in a variant, so that the first frame does not wait for it.
    void prepare(const SceneVariant& variant);

    /// For all draws from now on: what is drawn wholly in the air, or wholly under water, leaves out the other's light.
    /// Null: there is no water. Must outlive the draws.
    void setWater(const WaterBody* water);

    /// For all draws from now on; the textures must outlive them.
    void setSunMaps(const SunMaps& maps) { sunMaps_ = maps; }
    const SunMaps& sunMaps() const { return sunMaps_; }

    /// Of all chunks that are drawn with a program, one triangle is enough (Renderer::setWarmingUp).
    void setWarmingUp(bool warmingUp) { warmingUp_ = warmingUp; }

    /// Draws into the bound target. FrameBlock and the view's ViewBlock must be bound.
    void draw(const View& view, const SceneVariant& variant, const WaterCover& cover, bool cull,
              FrameReport::Pass& stats);

private:
    /// What a material asks of the shader. Bits of a key.
    unsigned features(const Chunk& chunk) const;
    gl::Program& sceneProgram(unsigned features, const SceneVariant& variant);
    gl::Program& skyProgram(const SceneVariant& variant);
    void setMaterial(gl::Program& program, const Material& material, bool dithers) const;
    void drawChunks(const std::vector<const Chunk*>& chunks, const View& view, const SceneVariant& variant,
                    FrameReport::Pass& stats);
    void drawDepthFirst(const std::vector<const Chunk*>& chunks, const View& view, const SceneVariant& variant,
                        FrameReport::Pass& stats);
    void drawSky(const SceneVariant& variant);
    const gl::VertexArray& meshArray(int mesh);

    const GpuScene& scene_;
    gl::ShaderLibrary& shaders_;
    std::vector<Medium> media_; ///< per chunk
    const WaterBody* water_ = nullptr;
    int lightCount_ = 0; ///< point and spot lights
    bool warmingUp_ = false;
    SunMaps sunMaps_;
    gl::Texture allUnderwater_{{.format = gl::Format::r8, .filter = gl::Filter::nearest}, "all under water"};
    std::map<std::pair<unsigned, int>, std::shared_ptr<gl::Program>> scenePrograms_; ///< by features and taps
    std::map<unsigned, std::shared_ptr<gl::Program>> skyPrograms_;
    struct MeshArray {
        std::shared_ptr<gl::Buffer> indices; ///< that it was made with
        gl::VertexArray array;
    };
    std::vector<MeshArray> meshArrays_;      ///< of this context; made when they are first drawn
    std::vector<mat3> worldFromModelNormal_; ///< per instance
    gl::FullscreenTriangle triangle_;
};

} // namespace tarn
