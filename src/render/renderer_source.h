// The renderer as what a FrameThread draws with.
#pragma once

#include "gl/profiler.h"
#include "gl/shader_library.h"
#include "render/frame_source.h"

#include <memory>

namespace tarn {

class GpuScene;
class Progress;
class Rehearsal;

class RendererSource : public FrameSource {
public:
    /// On a graphics card it builds every program that frames with these options may ask for, while a draft moves as the
    /// full picture will. On a processor each takes so long that only those of a frame are built before it, and the others
    /// one by one between frames.
    /// @param progress must outlive it; null: none
    RendererSource(std::shared_ptr<GpuScene> uploaded, const Options& options, const WaterBody& water,
                   Progress* progress);
    ~RendererSource() override;

    void prepare(const FrameRequest& request) override;
    bool draw(const FrameRequest& request) override;
    const gl::Framebuffer& picture() const override { return renderer_.display(); }
    FrameReport report() const override;
    bool workAhead() override;
    Renderer* renderer() override { return &renderer_; }

private:
    void rehearse(const FrameRequest& request);

    std::shared_ptr<GpuScene> scene_;
    std::unique_ptr<gl::ShaderLibrary> shaders_;
    gl::Profiler profiler_;
    Renderer renderer_;
    Progress* progress_;
    std::unique_ptr<Rehearsal> rehearsal_; ///< from the first frame on; null: everything was built ahead
    bool buildsAhead_; ///< all at once
    Options asked_; ///< the renderer's own may differ where it must
    WaterBody water_;
    int sample_ = 0;
    const FrameStats* stats_ = nullptr;
};

} // namespace tarn
