#include "measure/benchmark.h"

#include "base/error.h"
#include "measure/statistics.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <utility>

namespace tarn {

double processCpuSeconds()
{
    std::timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

namespace {

using Clock = std::chrono::steady_clock;

/// Samples of one subject while the benchmark runs.
class Recorder {
public:
    explicit Recorder(std::string name) { result_.name = std::move(name); }

    void frame(double wallMs, double cpuMs)
    {
        result_.frame.wallMs.push_back(wallMs);
        result_.frame.cpuMs.push_back(cpuMs);
    }

    void calls(const gl::Counters& calls)
    {
        for (std::size_t i = 0; i < gl::callCount; ++i) calls_[i].push_back(static_cast<double>(calls.calls[i]));
    }

    void passes(const std::vector<BenchPass>& passes)
    {
        std::uint64_t triangles = 0;
        for (const BenchPass& pass : passes) {
            Row& row = rowOf(pass.name);
            row.series.wallMs.push_back(pass.wallMs);
            if (pass.cpuMs >= 0.0) row.series.cpuMs.push_back(pass.cpuMs);
            row.triangles.push_back(static_cast<double>(pass.triangles));
            triangles += pass.triangles;
        }
        triangles_.push_back(static_cast<double>(triangles));
    }

    BenchResult finish()
    {
        result_.frame.triangles = median(triangles_);
        for (std::size_t i = 0; i < gl::callCount; ++i) result_.calls.calls[i] = median(calls_[i]);
        for (Row& row : rows_) {
            row.series.triangles = median(row.triangles);
            result_.passes.emplace_back(std::move(row.name), std::move(row.series));
        }
        return std::move(result_);
    }

private:
    struct Row {
        std::string name;
        BenchSeries series;
        std::vector<double> triangles;
    };

    static std::uint64_t median(const std::vector<double>& counts)
    {
        return static_cast<std::uint64_t>(percentile(counts, 0.5));
    }

    Row& rowOf(const std::string& name)
    {
        const auto found = std::find_if(rows_.begin(), rows_.end(), [&](const Row& row) { return row.name == name; });
        if (found != rows_.end()) return *found;
        rows_.push_back({name, {}, {}});
        return rows_.back();
    }

    BenchResult result_;
    std::vector<Row> rows_;
    std::vector<double> triangles_;
    std::array<std::vector<double>, gl::callCount> calls_;
};

void measureFrame(BenchSubject& subject, int index, bool followsItself, bool passes, Recorder& recorder)
{
    subject.prepare(index, followsItself);
    const gl::Counters callsBefore = gl::counters();
    const double cpuStart = processCpuSeconds();
    const Clock::time_point start = Clock::now();
    subject.draw(index);
    const double wallMs = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    const double cpuMs = 1e3 * (processCpuSeconds() - cpuStart);
    recorder.frame(wallMs, cpuMs);
    recorder.calls(gl::counters() - callsBefore);
    if (passes) recorder.passes(subject.drawPasses(index));
}

} // namespace

BenchReport runBenchmark(const std::vector<std::unique_ptr<BenchSubject>>& subjects, const BenchPlan& plan,
                         Progress* progress, BenchSubject* yardstick)
{
    if (subjects.empty() || plan.frames < 1 || plan.warmUp < 0 || plan.passesEvery < 1)
        throw Error("a benchmark needs something to measure and at least one frame");
    std::vector<BenchSubject*> all;
    if (yardstick) all.push_back(yardstick);
    for (const auto& subject : subjects) all.push_back(subject.get());
    std::vector<Recorder> recorders;
    for (BenchSubject* subject : all) {
        if (progress) progress->report(0.0, "warming up " + subject->name());
        for (int index = 0; index < plan.warmUp; ++index) subject->draw(index);
        recorders.emplace_back(subject->name());
    }

    const std::size_t count = all.size();
    const BenchSubject* last = plan.warmUp > 0 ? all.back() : nullptr; // that drew
    for (int index = 0; index < plan.frames; ++index) {
        if (progress) progress->report(static_cast<double>(index) / plan.frames, "measuring");
        for (std::size_t turn = 0; turn < count; ++turn) {
            // Every other round runs backwards, so that none always follows the same neighbour.
            const std::size_t which = index % 2 == 0 ? turn : count - 1 - turn;
            BenchSubject& subject = *all[which];
            const bool followsItself = std::exchange(last, &subject) == &subject;
            measureFrame(subject, index, followsItself, index % plan.passesEvery == 0, recorders[which]);
        }
    }

    BenchReport report;
    report.plan = plan;
    for (Recorder& recorder : recorders) report.results.push_back(recorder.finish());
    if (yardstick) {
        report.yardstick = std::move(report.results.front());
        report.results.erase(report.results.begin());
    }
    return report;
}

} // namespace tarn
