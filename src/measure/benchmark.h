// What a frame costs: wall and processor time of frames and passes, several configurations side by side.
//
// A subject is one configuration that can draw a frame. All subjects take turns, frame by frame and in
// alternating order, so that whatever the machine does meanwhile strikes all of them alike.
#pragma once

#include "base/progress.h"
#include "gl/counters.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tarn {

struct BenchPass {
    std::string name;
    double wallMs = 0.0;
    double cpuMs = -1.0;         ///< of the whole process while the pass ran; negative: not measured
    std::uint64_t triangles = 0; ///< sent to the GPU
};

class BenchSubject {
public:
    virtual ~BenchSubject() = default;
    virtual std::string name() const = 0;
    /// Called before each measured frame and not counted: for what only taking turns costs.
    /// @param followsItself no other subject has drawn since this one did
    virtual void prepare(int /*index*/, bool /*followsItself*/) {}
    /// Draws frame `index` and returns when the GPU has finished it. What this takes is the frame's time.
    virtual void draw(int index) = 0;
    /// Draws it again, waiting after each pass, which costs a little more than the passes do when they
    /// overlap.
    virtual std::vector<BenchPass> drawPasses(int index) = 0;
};

struct BenchPlan {
    int frames = 60;
    int warmUp = 5;      ///< frames of each subject that are drawn first and not counted
    int passesEvery = 4; ///< of so many frames one is drawn again to time its passes
};

struct BenchSeries {
    std::vector<double> wallMs, cpuMs;
    std::uint64_t triangles = 0; ///< median over the frames
};

struct BenchResult {
    std::string name;
    BenchSeries frame;
    std::vector<std::pair<std::string, BenchSeries>> passes; ///< in drawing order
    gl::Counters calls{};                                    ///< of OpenGL in a frame; medians
};

/// Where and how it was measured, for the report's head: "renderer", "size", "scene" …
using BenchContext = std::vector<std::pair<std::string, std::string>>;

struct BenchReport {
    BenchContext context;
    BenchPlan plan;
    std::vector<BenchResult> results;       ///< ratios are against the last one
    std::optional<BenchResult> yardstick{}; ///< that every result is told as a multiple of, where it was measured
};

/// @param progress may be null
/// @param yardstick takes turns with the subjects and is no result of its own (measure/yardstick.h); null:
/// none
BenchReport runBenchmark(const std::vector<std::unique_ptr<BenchSubject>>& subjects, const BenchPlan& plan,
                         Progress* progress = nullptr, BenchSubject* yardstick = nullptr);

nlohmann::json toJson(const BenchReport& report);
/// For people: a table for each configuration, then the ratios.
std::string toTable(const BenchReport& report);
/// A line for each configuration: how many yardsticks it costs. Empty where none was measured.
std::string yardstickLines(const BenchReport& report);

/// Processor time that all threads of this process have used, seconds.
double processCpuSeconds();

} // namespace tarn
