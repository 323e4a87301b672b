#include "render/program_builder.h"

#include "base/log.h"
#include "base/progress.h"
#include "base/thread_priority.h"
#include "gl/shader_library.h"
#include "render/gpu_scene.h"

#include <utility>

namespace tarn {

/// Thrown between two programs.
class ProgramBuilder::EndOfTask {};

namespace {

/// Asks before each program whether to go on.
template <typename End> class Interruptible : public Progress {
public:
    explicit Interruptible(const std::atomic<bool>& ends) : ends_(ends) {}
    void report(double /*fraction*/, const std::string& /*what*/) override
    {
        if (ends_) throw End{};
    }

private:
    const std::atomic<bool>& ends_;
};

} // namespace

/// What the thread builds with.
class ProgramBuilder::Tools {
public:
    Tools(std::shared_ptr<GpuScene> scene, const Task& task, const std::atomic<bool>& ends)
        : progress_(ends), shaders_(makeShaderLibrary()),
          rehearsal_(std::move(scene), *shaders_, task.options, task.water, &progress_)
    {}

    void run(const Task& task)
    {
        rehearsal_.setOptions(task.options, task.water);
        if (task.view) return rehearsal_.build(*task.view, Rehearsal::Order::oddFirst);
        while (rehearsal_.buildOthers(1)) progress_.report(0.0, "");
    }

private:
    Interruptible<EndOfTask> progress_;
    std::unique_ptr<gl::ShaderLibrary> shaders_;
    Rehearsal rehearsal_;
};

ProgramBuilder::ProgramBuilder(std::unique_ptr<gl::Context> context, std::shared_ptr<GpuScene> scene)
    : context_(std::move(context)), scene_(std::move(scene)), thread_([this] { work(); })
{}

ProgramBuilder::~ProgramBuilder()
{
    {
        const std::lock_guard lock(mutex_);
        isLeaving_ = true;
        ends_ = true;
        changed_.notify_all();
    }
    thread_.join();
}

void ProgramBuilder::begin(std::vector<Task> tasks)
{
    const std::lock_guard lock(mutex_);
    ends_ = isBusy_;
    done_ = tasks.empty();
    tasks_.assign(tasks.begin(), tasks.end());
    changed_.notify_all();
}

void ProgramBuilder::pause()
{
    std::unique_lock lock(mutex_);
    tasks_.clear();
    ends_ = isBusy_;
    changed_.wait(lock, [this] { return !isBusy_; });
    done_ = true;
}

void ProgramBuilder::run(const Task& task)
{
    try {
        if (!tools_) tools_ = std::make_unique<Tools>(scene_, task, ends_);
        tools_->run(task);
    } catch (const EndOfTask&) {
        tools_.reset(); // in the middle of a frame
    } catch (const std::exception& error) {
        log::debug("building programs ahead: {}", error.what());
        tools_.reset();
    }
}

void ProgramBuilder::work()
{
    context_->makeCurrent();
    lowerThreadPriority(); // now: threads that the driver begins for everybody would inherit it
    for (std::unique_lock lock(mutex_);;) {
        changed_.wait(lock, [this] { return isLeaving_ || !tasks_.empty(); });
        if (isLeaving_) break;
        const Task task = std::move(tasks_.front());
        tasks_.pop_front();
        isBusy_ = true;
        ends_ = false;
        lock.unlock();
        run(task);
        lock.lock();
        const bool isLast = tasks_.empty();
        if (isLast) {
            lock.unlock();
            tools_.reset();
            lock.lock();
        }
        isBusy_ = false;
        if (tasks_.empty()) done_ = true;
        changed_.notify_all();
    }
    tools_.reset();
    context_->release();
}

} // namespace tarn
