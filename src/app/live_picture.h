// The picture of a scene that is there soon and then gets better: a draft with few programs until all that the settings
// need are built, then the renderer's. Both are drawn in threads of their own, so that who shows them never waits.
//
//     LivePicture picture(window, wake);      // builds the draft's programs while the scene is read
//     picture.show(sceneSetup);
//     …
//     picture.ask(request);
//     if (picture.take()) picture.copyTo(screen);
#pragma once

#include "app/settings.h"
#include "app/startup_times.h"
#include "base/progress.h"
#include "gl/framebuffer.h"
#include "render/draft_renderer.h"
#include "render/frame_thread.h"

#include <chrono>
#include <functional>
#include <future>
#include <memory>

namespace tarn {

class LivePicture {
public:
    /// @param context of the thread that shows the picture; must outlive it
    /// @param wake called in another thread when there is something new
    LivePicture(gl::Context& context, std::function<void()> wake);
    /// Waits for the threads, at most until each has built one program or drawn one frame.
    ~LivePicture();

    /// Call it once. The scene must outlive it.
    void show(const Scene& scene, const Settings& settings);

    void ask(const FrameRequest& request);
    /// True when there is a picture newer than the one that was shown. Throws what went wrong in a thread.
    bool take();
    /// One is finished, but not yet on the GPU: look again soon.
    bool isPending() const;
    /// Fills the destination, which must be of this thread's context. Nothing before the first take().
    void copyTo(const gl::Framebuffer& destination) const;

    bool hasPicture() const { return picture_ != nullptr; }
    /// The picture is the renderer's.
    bool isFull() const { return isFull_; }
    const FrameDelivery& delivery() const { return delivery_; }
    /// How many pictures were taken.
    int pictures() const { return pictures_; }
    /// Requests that the renderer has drawn, those whose picture had not changed among them.
    int answered() const { return full_ ? full_->answered() : 0; }

    /// Of building what the settings need.
    SharedProgress::State progress() const { return progress_.state(); }
    /// With the renderer, between two of its frames; it waits until that is built.
    void post(FrameThread::Job job) { full_->post(std::move(job)); }
    /// All programs that the settings may need are built.
    bool isBuilt() const { return isFull_ && full_->isIdle(); }
    const StartupTimes& times() const { return times_; }
    StartupTimes& times() { return times_; }

    /// Both threads end as soon as they can.
    void stop();
    bool hasEnded() const;

private:
    std::unique_ptr<FrameSource> makeDraft(const StopSignal& stop);
    std::unique_ptr<FrameSource> makeFull(const Scene& scene, const Settings& settings, const StopSignal& stop);
    void askDraft(const FrameRequest& request);
    void adopt(const FrameThread& thread, bool full);

    gl::Context& context_;
    std::function<void()> wake_;
    StartupTimes times_;
    SharedProgress progress_;
    std::unique_ptr<Progress> building_;          ///< of the renderer's thread
    std::unique_ptr<gl::Context> builderContext_; ///< until the renderer is made
    std::promise<DraftScene> promise_;
    std::future<DraftScene> snapshot_ = promise_.get_future();

    std::shared_ptr<const gl::Texture> picture_;
    gl::Framebuffer source_; ///< of picture_, in this thread's context
    FrameDelivery delivery_;
    bool isFull_ = false;
    int pictures_ = 0;

    std::optional<FrameRequest> lastDraft_;
    std::chrono::steady_clock::time_point lastDraftTime_{};

    // The draft draws from what the renderer owns, and goes first.
    std::unique_ptr<FrameThread> full_, draft_;
};

} // namespace tarn
