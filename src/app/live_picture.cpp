#include "app/live_picture.h"

#include "render/gpu_scene.h"
#include "render/renderer_source.h"

#include <utility>

namespace tarn {

namespace {

/// How often a draft is drawn while nothing but the waves moves: it takes from the cores that build programs.
constexpr std::chrono::milliseconds restingInterval{500};

bool isSameView(const FrameRequest& a, const FrameRequest& b)
{
    return a.camera == b.camera && a.size == b.size && a.options == b.options && a.water == b.water;
}

/// Ends the work that reports to it when the thread is to end.
class StoppableProgress : public Progress {
public:
    StoppableProgress(SharedProgress& shared, const StopSignal& stop) : shared_(shared), stop_(stop) {}

    void report(double fraction, const std::string& what) override
    {
        stop_.throwIfSet();
        shared_.report(fraction, what);
    }

private:
    SharedProgress& shared_;
    const StopSignal& stop_;
};

} // namespace

LivePicture::LivePicture(gl::Context& context, std::function<void()> wake) : context_(context), wake_(std::move(wake))
{
    draft_ = std::make_unique<FrameThread>(
        context_.makeShared(), [this](const StopSignal& stop) { return makeDraft(stop); }, wake_);
}

LivePicture::~LivePicture()
{
    stop();
    draft_.reset();
    full_.reset();
}

void LivePicture::stop()
{
    if (draft_) draft_->stop();
    if (full_) full_->stop();
}

bool LivePicture::hasEnded() const { return (!draft_ || draft_->hasEnded()) && (!full_ || full_->hasEnded()); }

void LivePicture::show(const Scene& scene, const Settings& settings)
{
    times_.note(StartupEvent::loaded);
    if (context_.isSoftware()) builderContext_ = context_.makeShared();
    full_ = std::make_unique<FrameThread>(
        context_.makeShared(),
        [this, &scene, settings](const StopSignal& stop) { return makeFull(scene, settings, stop); }, wake_);
}

std::unique_ptr<FrameSource> LivePicture::makeDraft(const StopSignal& stop)
{
    auto draft = std::make_unique<DraftRenderer>();
    times_.note(StartupEvent::draftPrograms);
    // The scene may never come: its reader fails, or the person leaves.
    while (snapshot_.wait_for(std::chrono::milliseconds(5)) != std::future_status::ready) stop.throwIfSet();
    draft->show(snapshot_.get());
    return draft;
}

std::unique_ptr<FrameSource> LivePicture::makeFull(const Scene& scene, const Settings& settings, const StopSignal& stop)
{
    building_ = std::make_unique<StoppableProgress>(progress_, stop);
    std::shared_ptr<GpuScene> uploaded = uploadScene(scene, settings.options, building_.get());
    gl::Fence there;
    there.place();
    there.wait(); // the draft's context must not draw from it before
    times_.note(StartupEvent::uploaded);
    promise_.set_value(DraftScene(*uploaded));
    return std::make_unique<RendererSource>(std::move(uploaded), settings.options, settings.water, building_.get(),
                                            std::move(builderContext_));
}

void LivePicture::ask(const FrameRequest& request)
{
    if (full_) full_->ask(request);
    if (draft_ && !isFull_) askDraft(request);
}

void LivePicture::askDraft(const FrameRequest& request)
{
    const auto now = std::chrono::steady_clock::now();
    const bool rests = lastDraft_ && isSameView(*lastDraft_, request);
    if (rests && now - lastDraftTime_ < restingInterval) return;
    lastDraft_ = request;
    lastDraftTime_ = now;
    draft_->ask(request);
}

bool LivePicture::take()
{
    bool isNew = false;
    if (draft_ && draft_->take() && !isFull_) {
        adopt(*draft_, false);
        isNew = true;
    }
    if (full_ && full_->take()) {
        adopt(*full_, true);
        if (draft_) draft_->stop();
        isNew = true;
    }
    if (isFull_ && draft_ && draft_->hasEnded()) draft_.reset();
    if (isBuilt()) times_.note(StartupEvent::programs);
    return isNew;
}

void LivePicture::adopt(const FrameThread& thread, bool full)
{
    isFull_ = full;
    ++pictures_;
    delivery_ = thread.delivery();
    if (picture_ != thread.picture()) {
        picture_ = thread.picture();
        source_ = gl::Framebuffer("picture to be shown", {*picture_});
    }
    times_.note(full ? StartupEvent::fullPicture : StartupEvent::draftPicture);
}

bool LivePicture::isPending() const { return (full_ && full_->isPending()) || (draft_ && draft_->isPending()); }

void LivePicture::copyTo(const gl::Framebuffer& destination) const
{
    if (picture_) source_.blitTo(destination, {.filter = gl::Filter::linear});
}

} // namespace tarn
