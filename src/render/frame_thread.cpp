#include "render/frame_thread.h"

#include <chrono>
#include <utility>

namespace tarn {

FrameThread::FrameThread(std::unique_ptr<gl::Context> context, Make make, std::function<void()> wake)
    : context_(std::move(context)), wake_(std::move(wake)), thread_([this, make = std::move(make)] { work(make); })
{}

FrameThread::~FrameThread()
{
    stop();
    thread_.join();
}

void FrameThread::stop()
{
    const std::lock_guard lock(mutex_);
    stop_.set();
    changed_.notify_all();
}

void FrameThread::ask(const FrameRequest& request)
{
    const std::lock_guard lock(mutex_);
    asked_ = request;
    changed_.notify_all();
}

void FrameThread::post(Job job)
{
    const std::lock_guard lock(mutex_);
    jobs_.push_back(std::move(job));
    changed_.notify_all();
}

bool FrameThread::take()
{
    const std::lock_guard lock(mutex_);
    if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
    if (!finished_ || !finished_->drawn.passed()) return false;
    if (front_) front_->shown.place();
    front_ = std::exchange(finished_, nullptr);
    shownDelivery_ = std::move(front_->delivery);
    changed_.notify_all();
    return true;
}

bool FrameThread::isPending() const
{
    const std::lock_guard lock(mutex_);
    return finished_ != nullptr;
}

void FrameThread::work(const Make& make)
{
    try {
        context_->makeCurrent();
        const std::unique_ptr<FrameSource> source = make(stop_);
        ready_ = true;
        wake_();
        serve(*source);
    } catch (const StopSignal::Stopped&) {
        // Nobody waits for more.
    } catch (...) {
        const std::lock_guard lock(mutex_);
        error_ = std::current_exception();
    }
    for (Slot& slot : slots_) slot.target = {};
    context_->release();
    ended_ = true;
    wake_();
}

void FrameThread::serve(FrameSource& source)
{
    using Ahead = FrameSource::Ahead;
    constexpr std::chrono::milliseconds later{20};
    Ahead ahead = Ahead::nothing;
    bool jobDrew = false; // what the source says is unchanged may be so since a job, and was never shown
    std::optional<Camera> last;
    const auto workAhead = [&] {
        ahead = source.workAhead();
        idle_ = ahead == Ahead::nothing;
        if (idle_) wake_();
    };
    for (;;) {
        std::unique_lock lock(mutex_);
        const auto isNeeded = [&] { return stop_.isSet() || !jobs_.empty() || (asked_ && !finished_); };
        if (ahead == Ahead::later) changed_.wait_for(lock, later, isNeeded);
        if (ahead != Ahead::nothing && !isNeeded()) {
            lock.unlock();
            workAhead();
            continue;
        }
        changed_.wait(lock, isNeeded);
        if (stop_.isSet()) return;
        if (!jobs_.empty()) {
            const Job job = std::move(jobs_.front());
            jobs_.pop_front();
            lock.unlock();
            job(source);
            jobDrew = true;
            continue;
        }
        const FrameRequest request = *std::exchange(asked_, std::nullopt);
        lock.unlock();
        const auto start = std::chrono::steady_clock::now();
        bool drew = false;
        try {
            drew = source.draw(request) || jobDrew;
        } catch (const FrameAbandoned&) { // the next request is there already, or soon
        }
        if (drew) {
            jobDrew = false;
            deliver(source, start);
        }
        ++answered_;
        wake_();
        // Who moves waits for nothing but frames.
        const bool moves = last && !(*last == request.camera);
        last = request.camera;
        if (!moves)
            workAhead();
        else if (ahead == Ahead::nothing)
            ahead = Ahead::more; // as far as is known
    }
}

void FrameThread::deliver(const FrameSource& source, std::chrono::steady_clock::time_point start)
{
    Slot* back = nullptr;
    {
        const std::lock_guard lock(mutex_);
        for (Slot& slot : slots_)
            if (&slot != front_ && &slot != finished_) back = &slot;
    }
    const gl::Framebuffer& picture = source.picture();
    if (!back->texture || back->texture->size() != picture.size()) {
        const gl::TextureDesc desc{.format = gl::Format::rgba8, .size = picture.size()};
        back->texture = std::make_shared<gl::Texture>(desc, "finished picture");
        back->target = gl::Framebuffer("finished picture", {*back->texture});
    }
    back->shown.holdBack();
    picture.blitTo(back->target, {});
    back->delivery = source.delivery();
    back->drawn.place();
    if (gl::capabilities().llvmpipe) back->drawn.wait(); // else who shows it would poll, on the cores that draw
    const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
    back->delivery.milliseconds = spent.count();
    const std::lock_guard lock(mutex_);
    finished_ = back;
}

} // namespace tarn
