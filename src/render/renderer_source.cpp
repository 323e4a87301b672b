#include "render/renderer_source.h"

#include "gl/context.h"
#include "render/gpu_scene.h"
#include "render/warm_up.h"

namespace tarn {

RendererSource::RendererSource(std::unique_ptr<GpuScene> uploaded, const Options& options, const WaterBody& water,
                               Progress* progress)
    : shaders_(makeShaderLibrary()), renderer_(std::move(uploaded), options, *shaders_, profiler_, progress),
      asked_(options), water_(water)
{
    // Else it would be said when passes were asked for, not when they were drawn.
    profiler_.setSynchronous(gl::capabilities().llvmpipe);
    renderer_.setOptions(options, water);
    warmUp(renderer_, water, progress);
}

RendererSource::~RendererSource() = default;

void RendererSource::prepare(const FrameRequest& request)
{
    if (request.options == asked_ && request.water == water_) return;
    asked_ = request.options;
    water_ = request.water;
    renderer_.setOptions(asked_, water_);
}

bool RendererSource::draw(const FrameRequest& request)
{
    shaders_->pollChanges();
    prepare(request);
    stats_ = &renderer_.render({request.camera, request.time, request.size, request.view, false, request.sample,
                                request.abandoned.get()});
    sample_ = request.sample;
    return !stats_->plan.rule(RuleId::keepFrame).applies;
}

FrameReport RendererSource::report() const
{
    return {*stats_, profiler_.latest(), 0.0, shaders_->lastError(), asked_, sample_};
}

} // namespace tarn
