// Draws frames in a thread with a context of its own, so that whoever shows them waits neither for a long frame nor for
// the programs that it needs: the last finished picture stays there meanwhile.
//
//     FrameThread thread(window.makeShared(), [&](const StopSignal& stop) { return makeSource(stop); }, wake);
//     …                                   // in the thread that shows them:
//     thread.ask(request);                // the newest one counts
//     if (thread.take()) show(*thread.picture());
//
// Three pictures go round: one is shown, one is finished, one is being drawn. No frame is begun while a finished one
// waits to be shown, so that pictures are drawn no faster than they are shown.
#pragma once

#include "gl/context.h"
#include "gl/fence.h"
#include "render/frame_source.h"

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace tarn {

/// Ends long work in a thread that is no longer needed.
class StopSignal {
public:
    struct Stopped {}; ///< thrown; nothing but FrameThread catches it
    void set() { set_ = true; }
    bool isSet() const { return set_; }
    void throwIfSet() const
    {
        if (set_) throw Stopped{};
    }

private:
    std::atomic<bool> set_ = false;
};

class FrameThread {
public:
    using Make = std::function<std::unique_ptr<FrameSource>(const StopSignal&)>;
    using Job = std::function<void(FrameSource&)>;

    /// @param make called in the thread, with its context current
    /// @param wake called in the thread when there is something new: a picture, the source, an error
    FrameThread(std::unique_ptr<gl::Context> context, Make make, std::function<void()> wake);
    /// Waits until the thread has ended.
    ~FrameThread();
    FrameThread(const FrameThread&) = delete;
    FrameThread& operator=(const FrameThread&) = delete;

    /// The thread ends with what it is doing: a frame, or the building of one program.
    void stop();
    bool hasEnded() const { return ended_; }
    /// The source is made.
    bool isReady() const { return ready_; }

    void ask(const FrameRequest& request);
    /// Between two frames, once the source is made.
    void post(Job job);

    /// True when a finished picture is newer than the one that was shown; it is now picture(). Throws what the thread
    /// threw.
    bool take();
    /// A picture is finished for the thread that draws, but not yet for its GPU: look again soon.
    bool isPending() const;
    /// Null before the first take().
    std::shared_ptr<const gl::Texture> picture() const { return front_ ? front_->texture : nullptr; }
    const FrameDelivery& delivery() const { return shownDelivery_; } ///< of picture()
    /// The source had nothing left to do ahead when it last had the time.
    bool isIdle() const { return idle_; }
    /// Requests that have been drawn, those whose picture had not changed among them.
    int answered() const { return answered_; }

private:
    struct Slot {
        std::shared_ptr<gl::Texture> texture;
        gl::Framebuffer target; ///< in the drawing thread's context
        gl::Fence drawn, shown;
        FrameDelivery delivery;
    };

    void work(const Make& make);
    void serve(FrameSource& source);
    void deliver(const FrameSource& source, std::chrono::steady_clock::time_point start);

    std::unique_ptr<gl::Context> context_;
    std::function<void()> wake_;
    StopSignal stop_;
    std::atomic<bool> ended_ = false, ready_ = false, idle_ = false;
    std::atomic<int> answered_ = 0;

    mutable std::mutex mutex_; ///< of what follows
    std::condition_variable changed_;
    std::optional<FrameRequest> asked_;
    std::deque<Job> jobs_;
    std::exception_ptr error_;
    std::array<Slot, 3> slots_;
    Slot* finished_ = nullptr;    ///< not yet taken
    Slot* front_ = nullptr;       ///< shown
    FrameDelivery shownDelivery_; ///< of the showing thread

    std::thread thread_; // last: it uses all of the above
};

} // namespace tarn
