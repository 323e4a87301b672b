// The renderer as what a FrameThread draws with.
#pragma once

#include "gl/profiler.h"
#include "gl/shader_library.h"
#include "render/frame_source.h"

#include <memory>

namespace tarn {

class GpuScene;
class Progress;

class RendererSource : public FrameSource {
public:
    /// Builds every program that frames with these options may ask for.
    RendererSource(std::unique_ptr<GpuScene> uploaded, const Options& options, const WaterBody& water,
                   Progress* progress);
    ~RendererSource() override;

    void prepare(const FrameRequest& request) override;
    bool draw(const FrameRequest& request) override;
    const gl::Framebuffer& picture() const override { return renderer_.display(); }
    FrameReport report() const override;
    Renderer* renderer() override { return &renderer_; }

private:
    std::unique_ptr<gl::ShaderLibrary> shaders_;
    gl::Profiler profiler_;
    Renderer renderer_;
    Options asked_; ///< the renderer's own may differ where it must
    WaterBody water_;
    int sample_ = 0;
    const FrameStats* stats_ = nullptr;
};

} // namespace tarn
