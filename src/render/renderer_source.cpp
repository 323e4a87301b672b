#include "render/renderer_source.h"

#include "base/progress.h"
#include "gl/context.h"
#include "render/gpu_scene.h"
#include "render/warm_up.h"

#include <utility>

namespace tarn {

RendererSource::RendererSource(std::shared_ptr<GpuScene> uploaded, const Options& options, const WaterBody& water,
                               Progress* progress)
    : scene_(std::move(uploaded)), shaders_(makeShaderLibrary()), renderer_(scene_, options, *shaders_, profiler_, progress),
      progress_(progress), buildsAhead_(!gl::capabilities().llvmpipe), asked_(options), water_(water)
{
    // Else it would be said when passes were asked for, not when they were drawn.
    profiler_.setSynchronous(gl::capabilities().llvmpipe);
    renderer_.setOptions(options, water);
    if (buildsAhead_) warmUp(renderer_, water, progress);
}

RendererSource::~RendererSource() = default;

void RendererSource::prepare(const FrameRequest& request)
{
    if (request.options == asked_ && request.water == water_) return;
    asked_ = request.options;
    water_ = request.water;
    renderer_.setOptions(asked_, water_);
    if (rehearsal_) rehearsal_->setOptions(asked_, water_);
}

/// What the first frame needs, with a count of how much there is to do.
void RendererSource::rehearse(const FrameRequest& request)
{
    rehearsal_ = std::make_unique<Rehearsal>(scene_, *shaders_, asked_, water_, progress_);
    rehearsal_->build({request.camera, request.time, request.size});
}

bool RendererSource::draw(const FrameRequest& request)
{
    shaders_->pollChanges();
    prepare(request);
    if (!buildsAhead_ && !rehearsal_) rehearse(request);
    // Programs that nobody foresaw: the thread's end need not wait for more than one.
    shaders_->watchFirstUses([this](const gl::Program&) {
        if (progress_) progress_->report(1.0, "building shaders");
        return true;
    });
    stats_ = &renderer_.render({request.camera, request.time, request.size, request.view, false, request.sample,
                                request.abandoned.get()});
    shaders_->watchFirstUses({});
    sample_ = request.sample;
    return !stats_->plan.rule(RuleId::keepFrame).applies;
}

bool RendererSource::workAhead()
{
    return rehearsal_ && rehearsal_->buildOthers(1);
}

FrameReport RendererSource::report() const
{
    return {*stats_, profiler_.latest(), 0.0, shaders_->lastError(), asked_, sample_};
}

} // namespace tarn
