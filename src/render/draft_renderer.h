// A quick picture of a scene, drawn with a handful of short programs: what is shown while those of the real one are
// built.
//
//     DraftRenderer draft;                          // builds its programs; the scene may still be loading
//     DraftScene snapshot(gpuScene);                // in the thread that owns the scene on the card
//     draft.show(snapshot);
//     draft.draw(request);
#pragma once

#include "gl/buffer.h"
#include "gl/shader_library.h"
#include "gl/target.h"
#include "gl/vertex_array.h"
#include "optics/blocks.h"
#include "render/frame_source.h"
#include "render/gpu_scene.h"
#include "render/passes/present.h"
#include "render/visibility.h"

#include <memory>
#include <vector>

namespace tarn {

/// What the draft shows of a GpuScene: of full detail, and as it was when this was made; the buffers and textures are
/// that scene's and must outlive it. Another thread may change the GpuScene meanwhile.
struct DraftScene {
    explicit DraftScene(const GpuScene& scene);

    const Scene& scene;
    const SkyModel& sky;
    const gl::Texture& skyMap;
    std::vector<MeshBuffers> meshes;
    std::vector<Instance> instances;
    Chunks chunks;
    std::vector<const gl::Texture*> diffuseMaps, alphaMaps; ///< per material; null: none
};

class DraftRenderer : public FrameSource {
public:
    /// With the programs' first draws done, which on some drivers is what takes the time. Needs a current context.
    DraftRenderer();

    void show(const DraftScene& scene);

    bool draw(const FrameRequest& request) override;
    const gl::Framebuffer& picture() const override { return present_.target().framebuffer(); }
    FrameDelivery delivery() const override { return {report_, {}, 0.0, ""}; }

    /// How many programs it has.
    std::size_t programs() const { return shaders_->built(); }

private:
    struct Placed { ///< what only a scene brings
        DraftScene snapshot;
        std::vector<gl::VertexArray> meshes;    ///< of this context
        std::vector<mat3> worldFromModelNormal; ///< per instance
    };

    void warmUp();
    void drawScene(const FrameRequest& request, const View& view);
    void drawChunk(const Chunk& chunk, const Material& material, gl::Program& program);
    void drawSky(const gl::Texture& skyMap, bool underwater);
    void drawWater(const gl::Texture& skyMap, bool underwater);
    gl::Program& skyProgram(bool underwater);
    gl::Program& waterProgram(bool underwater);
    ivec2 sizeFor(ivec2 asked) const;

    std::unique_ptr<gl::ShaderLibrary> shaders_;
    std::shared_ptr<gl::Program> opaque_, cutOut_;
    std::shared_ptr<gl::Program> sky_[2], water_[2]; ///< seen from the air, from under water
    gl::UniformBuffer<blocks::FrameBlock> frameBlock_;
    gl::UniformBuffer<blocks::ViewBlock> viewBlock_;
    gl::UniformBuffer<blocks::WavesBlock> wavesBlock_;
    gl::Texture white_;
    gl::Target frame_{"draft"};
    PresentPass present_;
    gl::FullscreenTriangle triangle_;
    gl::VertexArray rectangle_{"draft water"};
    std::unique_ptr<Placed> placed_;
    FrameReport report_;
    float scale_ = 1.0f; ///< of the picture's edges to the asked ones
};

} // namespace tarn
