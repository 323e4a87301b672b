// What each pass of a frame costs. One RAII object per pass is its debug group, its GPU timer and its name:
//
//     profiler.beginFrame();
//     { PassScope pass(profiler, "water"); … draw … }
//     profiler.endFrame();
//     for (const PassTime& t : profiler.latest()) …
//
// GPU results are read frames later and never waited for. On a software rasteriser drawing is deferred and
// its timestamps mean little: there, and for `tarn bench`, setSynchronous(true) makes each pass wait for its
// own work, so that wall and process CPU time are its true cost.
#pragma once

#include "gl/object.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tarn::gl {

struct PassTime {
    std::string name;
    double gpuMs = -1.0; ///< negative: not known
    double wallMs = 0.0; ///< between begin and end of the scope on the CPU
    double cpuMs = 0.0;  ///< of all threads of the process in that time
};

class Profiler {
public:
    void beginFrame();
    void endFrame();

    /// Wait for the GPU at both ends of each pass.
    void setSynchronous(bool on) { synchronous_ = on; }
    bool isSynchronous() const { return synchronous_; }

    /// The pass that is being drawn, the innermost; "frame" between passes.
    std::string_view openPass() const { return open_.empty() ? std::string_view() : open_.back(); }

    /// The newest frame whose results are all in: its passes in the order they began (those of one name added
    /// up), the whole frame first under the name "frame". Empty at first.
    const std::vector<PassTime>& latest() const { return latest_; }

private:
    friend class PassScope;
    struct Record {
        std::string name;
        Object begin, end; ///< timestamp queries, reused frame after frame
        double wallStart = 0.0, cpuStart = 0.0;
        double wallMs = 0.0, cpuMs = 0.0;
    };
    struct Frame {
        std::vector<Record> records;
        std::size_t used = 0;
        bool pending = false; ///< ended, results not yet read
    };
    static constexpr std::size_t framesInFlight = 4;

    std::size_t begin(std::string_view name);
    void end(std::size_t record);
    bool collect(Frame& frame);

    std::array<Frame, framesInFlight> frames_;
    std::size_t current_ = 0;
    bool inFrame_ = false;
    bool synchronous_ = false;
    std::vector<std::string> open_;
    std::vector<PassTime> latest_;
};

class PassScope {
public:
    PassScope(Profiler& profiler, std::string_view name) : profiler_(profiler), record_(profiler.begin(name)) {}
    ~PassScope() { profiler_.end(record_); }
    PassScope(const PassScope&) = delete;
    PassScope& operator=(const PassScope&) = delete;

private:
    Profiler& profiler_;
    std::size_t record_;
};

} // namespace tarn::gl
