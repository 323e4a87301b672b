// The renderer as what a FrameThread draws with.
#pragma once

#include "gl/profiler.h"
#include "gl/shader_library.h"
#include "render/frame_source.h"
#include "render/renderer.h"

#include <memory>

namespace tarn {

namespace gl {
class Context;
}
class GpuScene;
class ProgramBuilder;
class Progress;
class Rehearsal;

class RendererSource : public FrameSource {
public:
    /// On a graphics card it builds every program that frames with these options may ask for, while a draft moves as
    /// the full picture will. On a processor each takes so long that only those of a frame are built before it, in two
    /// threads, and the others in the second thread.
    /// @param progress must outlive it; null: none
    /// @param builderContext of the second thread, on a processor; null: the others are built one by one between frames
    RendererSource(std::shared_ptr<GpuScene> uploaded, const Options& options, const WaterBody& water,
                   Progress* progress, std::unique_ptr<gl::Context> builderContext = nullptr);
    ~RendererSource() override;

    void prepare(const FrameRequest& request) override;
    bool draw(const FrameRequest& request) override;
    const gl::Framebuffer& picture() const override { return renderer_.display(); }
    FrameDelivery delivery() const override;
    Ahead workAhead() override;
    Renderer* renderer() override { return &renderer_; }

private:
    void rehearse(const FrameRequest& request);

    std::shared_ptr<GpuScene> scene_;
    std::unique_ptr<gl::ShaderLibrary> shaders_;
    gl::Profiler profiler_;
    Renderer renderer_;
    Progress* progress_;
    std::unique_ptr<Rehearsal> rehearsal_;    ///< from the first frame on; null: everything was built ahead
    std::unique_ptr<ProgramBuilder> builder_; ///< null: there is no second thread
    std::vector<gl::PassTime> passes_;        ///< of the last frame whose passes were timed
    int frames_ = 0;
    bool buildsAhead_; ///< all at once
    Options asked_;    ///< the renderer's own may differ where it must
    WaterBody water_;
    int sample_ = 0;
    const FrameReport* report_ = nullptr;
};

} // namespace tarn
