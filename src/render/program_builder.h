// Builds programs in a thread and a context of its own, before the thread that draws needs them. A software driver
// keeps what it has compiled in its cache, not in the context: there a program that was built here is at hand in a
// tenth of the time.
//
//     ProgramBuilder builder(window.makeShared(), scene);
//     builder.begin({{options, water, view}, {options, water, {}}});
//     …
//     if (builder.isDone()) …
//
// The thread gives way to all others. It holds nothing once it is done.
#pragma once

#include "gl/context.h"
#include "render/warm_up.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace tarn {

class ProgramBuilder {
public:
    struct Task {
        Options options;
        WaterBody water;
        /// What it needs, the programs that somebody else begins with last; none: what all other views need.
        std::optional<Rehearsal::View> view{};
    };

    /// @param scene what options ask of it beside the drawing must be there (GpuScene::ensureDetail and the like)
    ProgramBuilder(std::unique_ptr<gl::Context> context, std::shared_ptr<GpuScene> scene);
    /// Waits for the program that is being built.
    ~ProgramBuilder();
    ProgramBuilder(const ProgramBuilder&) = delete;
    ProgramBuilder& operator=(const ProgramBuilder&) = delete;

    /// In this order, in place of what was left of the tasks before.
    void begin(std::vector<Task> tasks);
    /// Ends what it does, and waits for that: nothing of the scene is in use any more.
    void pause();
    /// Nothing is left to be built. An error ends the thread's work too: whoever draws will meet it, and says so.
    bool isDone() const { return done_; }

private:
    class Tools;
    class EndOfTask;

    void work();
    void run(const Task& task);

    std::unique_ptr<gl::Context> context_;
    std::shared_ptr<GpuScene> scene_;
    std::unique_ptr<Tools> tools_; ///< of the thread

    std::mutex mutex_; ///< of what follows
    std::condition_variable changed_;
    std::deque<Task> tasks_;
    bool isBusy_ = false, isLeaving_ = false;
    std::atomic<bool> ends_ = false; ///< the task under way
    std::atomic<bool> done_ = true;

    std::thread thread_; // last: it uses all of the above
};

} // namespace tarn
