#include "render/renderer_source.h"

#include "base/progress.h"
#include "gl/context.h"
#include "plan/ladder.h"
#include "render/gpu_scene.h"
#include "render/program_builder.h"
#include "render/sun_passes.h"
#include "render/warm_up.h"

#include <utility>

namespace tarn {

namespace {

/// Whether options ask something else of the uploaded scene than others do.
bool changesScene(const Options& from, const Options& to)
{
    return from.detail != to.detail || from.frame.anisotropy != to.frame.anisotropy ||
           dithersCutOuts(from.frame) != dithersCutOuts(to.frame);
}

} // namespace

RendererSource::RendererSource(std::shared_ptr<GpuScene> uploaded, const Options& options, const WaterBody& water,
                               Progress* progress, std::unique_ptr<gl::Context> builderContext)
    : scene_(std::move(uploaded)), shaders_(makeShaderLibrary()),
      renderer_(scene_, options, *shaders_, profiler_, progress), progress_(progress),
      buildsAhead_(!gl::capabilities().llvmpipe), asked_(options), water_(water)
{
    renderer_.setOptions(options, water);
    if (buildsAhead_)
        warmUp(renderer_, water, progress);
    else if (builderContext)
        builder_ = std::make_unique<ProgramBuilder>(std::move(builderContext), scene_);
}

RendererSource::~RendererSource() = default;

void RendererSource::prepare(const FrameRequest& request)
{
    if (request.options == asked_ && request.water == water_) return;
    const bool isServed = programsServe(asked_, request.options) && request.water == water_;
    if (builder_ && changesScene(asked_, request.options)) builder_->pause();
    asked_ = request.options;
    water_ = request.water;
    renderer_.setOptions(asked_, water_);
    if (!rehearsal_) return;
    rehearsal_->setOptions(asked_, water_);
    if (builder_ && !isServed) builder_->begin({{asked_, water_}});
}

/// What the first frame needs, with a count of how much there is to do.
void RendererSource::rehearse(const FrameRequest& request)
{
    const Rehearsal::View view{request.camera, request.time, request.size};
    if (builder_) builder_->begin({{asked_, water_, view}, {asked_, water_}});
    rehearsal_ = std::make_unique<Rehearsal>(scene_, *shaders_, asked_, water_, progress_);
    rehearsal_->build(view);
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
    // A software driver draws a pass while the next one is prepared, and knows the time of none unless each is waited
    // for.
    constexpr int framesBetweenTimed = 16;
    profiler_.setSynchronous(gl::capabilities().llvmpipe && frames_++ % framesBetweenTimed == 0);
    report_ = &renderer_.render(
        {request.camera, request.time, request.size, request.view, false, request.sample, request.abandoned.get()});
    shaders_->watchFirstUses({});
    if (profiler_.isSynchronous() || !gl::capabilities().llvmpipe) passes_ = profiler_.latest();
    sample_ = request.sample;
    return !report_->rule(RuleId::keepFrame).applies;
}

RendererSource::Ahead RendererSource::workAhead()
{
    if (!rehearsal_) return Ahead::nothing;
    if (builder_ && !builder_->isDone()) {
        if (progress_) progress_->report(1.0, "building shaders of other views");
        return Ahead::later;
    }
    return rehearsal_->buildOthers(1) ? Ahead::more : Ahead::nothing;
}

FrameDelivery RendererSource::delivery() const
{
    return {*report_, passes_, 0.0, shaders_->lastError(), asked_, sample_};
}

} // namespace tarn
