// Percentiles against worked examples, and a benchmark of subjects whose cost is known.

#include "base/error.h"
#include "measure/benchmark.h"
#include "measure/statistics.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <thread>

namespace tarn {
namespace {

TEST(Statistics, PercentileInterpolatesBetweenNeighbours)
{
    const std::vector<double> samples{4.0, 1.0, 3.0, 2.0}; // unsorted on purpose
    EXPECT_DOUBLE_EQ(percentile(samples, 0.0), 1.0);
    EXPECT_DOUBLE_EQ(percentile(samples, 0.5), 2.5);
    EXPECT_DOUBLE_EQ(percentile(samples, 0.95), 3.85); // rank 2.85 from 0
    EXPECT_DOUBLE_EQ(percentile(samples, 1.0), 4.0);
}

TEST(Statistics, PercentileTakesFractionsBeyondTheEndsAsTheEnds)
{
    const std::vector<double> samples{1.0, 2.0};
    EXPECT_DOUBLE_EQ(percentile(samples, -1.0), 1.0);
    EXPECT_DOUBLE_EQ(percentile(samples, 7.0), 2.0);
}

TEST(Statistics, OneSampleIsEveryPercentile)
{
    const Summary s = summarise(std::vector<double>{7.0});
    EXPECT_EQ(s.count, 1u);
    for (const double value : {s.minimum, s.median, s.mean, s.p95, s.maximum}) EXPECT_DOUBLE_EQ(value, 7.0);
}

TEST(Statistics, SummaryOfOddAndSkewedSamples)
{
    const Summary s = summarise(std::vector<double>{10.0, 1.0, 1.0, 2.0, 1.0});
    EXPECT_DOUBLE_EQ(s.minimum, 1.0);
    EXPECT_DOUBLE_EQ(s.median, 1.0);
    EXPECT_DOUBLE_EQ(s.mean, 3.0);
    EXPECT_DOUBLE_EQ(s.p95, 8.4);
    EXPECT_DOUBLE_EQ(s.p99, 9.68);
    EXPECT_DOUBLE_EQ(s.maximum, 10.0);
}

TEST(Statistics, NothingCannotBeSummarised)
{
    EXPECT_THROW(percentile({}, 0.5), Error);
    EXPECT_THROW(summarise({}), Error);
    EXPECT_THROW(medianRatio({}, {}), Error);
}

TEST(Statistics, PairedRatioIgnoresDriftThatStrikesBoth)
{
    // The machine becomes ten times slower half-way: the ratio of neighbours stays 2.
    const std::vector<double> base{1.0, 1.0, 1.0, 10.0, 10.0};
    const std::vector<double> twice{2.0, 2.0, 2.0, 20.0, 20.0};
    EXPECT_DOUBLE_EQ(medianRatio(twice, base), 2.0);
    EXPECT_DOUBLE_EQ(totalRatio(std::vector<double>{1.0, 9.0}, std::vector<double>{1.0, 3.0}), 2.5);
    EXPECT_THROW(totalRatio({}, {}), Error);
    EXPECT_THROW(totalRatio(std::vector<double>{1.0, 2.0}, std::vector<double>{1.0}), Error);
    EXPECT_THROW(medianRatio(std::vector<double>{1.0, 2.0}, std::vector<double>{1.0}), Error);
}

/// Writes its name and frame into a log; sleeps as long as it is told.
class FakeSubject : public BenchSubject {
public:
    FakeSubject(std::string name, int milliseconds, std::vector<std::string>& log)
        : name_(std::move(name)), milliseconds_(milliseconds), log_(log)
    {}
    std::string name() const override { return name_; }
    void draw(int index) override
    {
        log_.push_back(name_ + std::to_string(index));
        std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds_));
    }
    std::vector<BenchPass> drawPasses(int) override { return {{"scene", 1.5, 1.0, 1000}, {"water", 0.5, -1.0, 24}}; }

private:
    std::string name_;
    int milliseconds_;
    std::vector<std::string>& log_;
};

BenchReport benchFakes(std::vector<std::string>& log, const BenchPlan& plan)
{
    std::vector<std::unique_ptr<BenchSubject>> subjects;
    subjects.push_back(std::make_unique<FakeSubject>("a", 8, log));
    subjects.push_back(std::make_unique<FakeSubject>("b", 2, log));
    return runBenchmark(subjects, plan);
}

TEST(Benchmark, SubjectsTakeTurnsInAlternatingOrderAfterWarmingUp)
{
    std::vector<std::string> log;
    benchFakes(log, {.frames = 3, .warmUp = 1});
    const std::vector<std::string> expected{"a0", "b0", "a0", "b0", "b1", "a1", "a2", "b2"};
    EXPECT_EQ(log, expected);
}

TEST(Benchmark, TellsASubjectWhetherAnotherDrewSince)
{
    class Follower : public FakeSubject {
    public:
        using FakeSubject::FakeSubject;
        void prepare(int, bool followsItself) override { followed.push_back(followsItself); }
        std::vector<bool> followed;
    };
    std::vector<std::string> log;
    std::vector<std::unique_ptr<BenchSubject>> subjects;
    for (const char* name : {"a", "b"}) subjects.push_back(std::make_unique<Follower>(name, 0, log));
    runBenchmark(subjects, {.frames = 3, .warmUp = 1}); // a b | a b, b a, a b
    const auto followed = [&](std::size_t i) { return static_cast<const Follower&>(*subjects[i]).followed; };
    EXPECT_EQ(followed(0), (std::vector<bool>{false, false, true}));
    EXPECT_EQ(followed(1), (std::vector<bool>{false, true, false}));
    subjects.pop_back();
    runBenchmark(subjects, {.frames = 2, .warmUp = 0});
    EXPECT_EQ(followed(0), (std::vector<bool>{false, false, true, false, true})) << "who drew before is not known";
}

TEST(Benchmark, PreparationIsNotCounted)
{
    /// Slow to prepare, quick to draw.
    class SlowStarter : public FakeSubject {
    public:
        using FakeSubject::FakeSubject;
        void prepare(int, bool) override
        {
            ++prepared;
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
        int prepared = 0;
    };
    std::vector<std::string> log;
    std::vector<std::unique_ptr<BenchSubject>> subjects;
    subjects.push_back(std::make_unique<SlowStarter>("a", 0, log));
    const BenchReport report = runBenchmark(subjects, {.frames = 3, .warmUp = 1});
    EXPECT_EQ(static_cast<const SlowStarter&>(*subjects[0]).prepared, 3);
    EXPECT_LT(percentile(report.results[0].frame.wallMs, 0.5), 40.0);
}

TEST(Benchmark, MeasuresEachFrameAndSomeOfThePasses)
{
    std::vector<std::string> log;
    const BenchReport report = benchFakes(log, {.frames = 5, .warmUp = 0, .passesEvery = 2});
    ASSERT_EQ(report.results.size(), 2u);
    const BenchResult& a = report.results[0];
    EXPECT_EQ(a.frame.wallMs.size(), 5u);
    EXPECT_EQ(a.frame.cpuMs.size(), 5u);
    for (const double ms : a.frame.wallMs) EXPECT_GE(ms, 8.0); // a sleep never ends early
    ASSERT_EQ(a.passes.size(), 2u);
    EXPECT_EQ(a.passes[0].first, "scene");
    EXPECT_EQ(a.passes[0].second.wallMs, (std::vector<double>{1.5, 1.5, 1.5}));
    EXPECT_EQ(a.passes[1].second.cpuMs.size(), 0u) << "an unmeasured time is no sample";
    EXPECT_EQ(a.frame.triangles, 1024u);
}

TEST(Benchmark, ReportTellsRatiosAgainstTheLast)
{
    BenchReport report;
    report.context = {{"renderer", "an abacus"}};
    report.results.push_back({"water", {{4.0, 6.0, 8.0}, {4.0, 4.0, 4.0}, 10}, {}});
    report.results.push_back({"dry", {{2.0, 2.0, 2.0}, {1.0, 1.0, 1.0}, 5}, {}});
    const nlohmann::json json = toJson(report);
    EXPECT_EQ(json["context"]["renderer"], "an abacus");
    EXPECT_DOUBLE_EQ(json["configurations"][0]["frame"]["wall_ms"]["median"], 6.0);
    ASSERT_EQ(json["ratios"].size(), 1u);
    EXPECT_DOUBLE_EQ(json["ratios"][0]["wall"], 3.0);
    EXPECT_DOUBLE_EQ(json["ratios"][0]["cpu"], 4.0);
    EXPECT_NE(toTable(report).find("water costs 3.00 x dry (wall time) and 4.00 x (processor time)"), std::string::npos)
        << toTable(report);
}

TEST(Benchmark, TheYardstickTakesTurnsAndIsNoResult)
{
    std::vector<std::string> log;
    std::vector<std::unique_ptr<BenchSubject>> subjects;
    subjects.push_back(std::make_unique<FakeSubject>("a", 0, log));
    FakeSubject yardstick("y", 0, log);
    const BenchReport report = runBenchmark(subjects, {.frames = 2, .warmUp = 1}, nullptr, &yardstick);
    EXPECT_EQ(log, (std::vector<std::string>{"y0", "a0", "y0", "a0", "a1", "y1"}));
    ASSERT_EQ(report.results.size(), 1u);
    EXPECT_EQ(report.results[0].name, "a");
    ASSERT_TRUE(report.yardstick);
    EXPECT_EQ(report.yardstick->name, "y");
    EXPECT_EQ(report.yardstick->frame.wallMs.size(), 2u);
}

TEST(Benchmark, EveryResultIsToldInYardsticks)
{
    BenchReport report;
    report.results.push_back({"water", {{7.0, 6.8, 200.0}, {40.0, 40.0, 50.0}, 10}, {}});
    report.results.push_back({"dry", {{2.0, 2.0, 2.0}, {10.0, 10.0, 10.0}, 5}, {}});
    EXPECT_EQ(yardstickLines(report), "");
    EXPECT_FALSE(toJson(report).contains("yardstick"));
    report.yardstick = BenchResult{"yardstick", {{2.0, 2.0, 50.0}, {4.0, 4.0, 5.0}, 100352}, {}};
    EXPECT_NE(toTable(report).find("water: 3.50 x yardstick (wall time), 10.00 x (processor time)"), std::string::npos)
        << toTable(report);
    EXPECT_NE(toTable(report).find("dry: 1.00 x yardstick (wall time), 2.50 x"), std::string::npos) << toTable(report);
    const nlohmann::json json = toJson(report);
    EXPECT_DOUBLE_EQ(json["configurations"][0]["yardsticks"]["cpu"], 10.0);
    EXPECT_DOUBLE_EQ(json["yardstick"]["frame"]["wall_ms"]["median"], 2.0);
    ASSERT_EQ(json["ratios"].size(), 1u) << "ratios stay against the last configuration";
    EXPECT_EQ(json["ratios"][0]["to"], "dry");
}

TEST(Benchmark, CountsTheCallsOfTheMeasuredFrames)
{
    /// Calls OpenGL more often with each frame; prepares with many calls more.
    class Caller : public FakeSubject {
    public:
        using FakeSubject::FakeSubject;
        void prepare(int, bool) override { call(100); }
        void draw(int index) override { call(index + 2); }
        static void call(int times)
        {
            for (int i = 0; i < times; ++i) gl::count(gl::Call::programBind);
        }
    };
    std::vector<std::string> log;
    std::vector<std::unique_ptr<BenchSubject>> subjects;
    subjects.push_back(std::make_unique<Caller>("a", 0, log));
    const BenchReport report = runBenchmark(subjects, {.frames = 3, .warmUp = 1});
    EXPECT_EQ(report.results[0].calls[gl::Call::programBind], 3u) << "the median of 2, 3 and 4";
    EXPECT_EQ(report.results[0].calls[gl::Call::draw], 0u);
    EXPECT_NE(toTable(report).find("3 program binds\n"), std::string::npos) << toTable(report);
    EXPECT_EQ(toJson(report)["configurations"][0]["calls"]["program_binds"], 3);
}

TEST(Benchmark, RefusesToMeasureNothing)
{
    EXPECT_THROW(runBenchmark({}, {}), Error);
    std::vector<std::string> log;
    EXPECT_THROW(benchFakes(log, {.frames = 0}), Error);
}

TEST(Benchmark, ProcessorTimeGrowsWithWork)
{
    const double start = processCpuSeconds();
    volatile double sink = 0.0;
    while (processCpuSeconds() - start < 0.005) sink = sink + 1.0;
    EXPECT_GT(sink, 0.0);
    const double beforeSleep = processCpuSeconds();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_LT(processCpuSeconds() - beforeSleep, 0.04) << "sleeping is no work";
}

} // namespace
} // namespace tarn
