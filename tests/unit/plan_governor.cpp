// The governor and the refinement against machines of formulas: what a frame takes is known, noise and hitches
// included.

#include "plan/governor.h"
#include "plan/refinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <set>

namespace tarn {
namespace {

const std::vector<double> lakeCosts{1.0, 0.78, 0.6, 0.47, 0.38, 0.3, 0.24, 0.18, 0.13, 0.09};

/// A machine, and a person who watches what the governor does on it.
struct Machine {
    std::vector<double> costs = lakeCosts;                                 ///< what rungs truly cost
    std::function<double(double now)> load = [](double) { return 100.0; }; ///< ms of a frame of cost 1
    double noise = 0.0;                                                    ///< standard deviation, relative
    double hitches = 0.0; ///< fraction of frames that take ten times as long
    std::function<bool(std::size_t)> isReady;
    std::mt19937 random{7};

    double now = 0.0;
    int changes = 0;
    std::vector<std::size_t> rungs; ///< of each frame
    std::vector<double> times;

    void run(Governor& governor, double seconds)
    {
        std::normal_distribution<double> normal(0.0, 1.0);
        std::uniform_real_distribution<double> uniform(0.0, 1.0);
        for (const double end = now + seconds; now < end;) {
            const std::size_t rung = governor.rung();
            double ms = load(now) * costs[rung] * std::max(0.2, 1.0 + noise * normal(random));
            if (uniform(random) < hitches) ms *= 10.0;
            now += 1e-3 * ms;
            if (governor.drawn({ms, now}, isReady) != rung) ++changes;
            rungs.push_back(rung);
            times.push_back(ms);
        }
    }
    /// The fraction of the last frames that took longer than a time.
    double slower(double ms, std::size_t frames) const
    {
        const std::size_t n = std::min(frames, times.size());
        return static_cast<double>(std::count_if(times.end() - static_cast<std::ptrdiff_t>(n), times.end(),
                                                 [&](double time) { return time > ms; })) /
               static_cast<double>(n);
    }
};

/// The most accurate rung that truly keeps the governor's aim.
std::size_t rightRung(const std::vector<double>& costs, double load, double target)
{
    for (std::size_t i = 0; i < costs.size(); ++i)
        if (load * costs[i] <= GovernorTuning{}.aim * target) return i;
    return costs.size() - 1;
}

TEST(Governor, GoesStraightToTheRightRungAndStays)
{
    for (const double load : {5.0, 30.0, 60.0, 100.0, 200.0, 2000.0}) {
        Machine machine;
        machine.load = [=](double) { return load; };
        Governor governor(lakeCosts, 33.3);
        EXPECT_EQ(governor.rung(), lakeCosts.size() - 1) << "the first frame is the cheapest";
        machine.run(governor, 600.0);
        EXPECT_EQ(governor.rung(), rightRung(lakeCosts, load, 33.3)) << load;
        EXPECT_LE(machine.changes, 1) << load;
    }
}

TEST(Governor, ReachesAnotherTargetInOneStep)
{
    Machine machine;
    Governor governor(lakeCosts, 33.3);
    machine.run(governor, 10.0);
    for (const double target : {10.0, 80.0, 200.0, 16.0}) {
        machine.changes = 0;
        governor.setTarget(target);
        machine.run(governor, 10.0);
        EXPECT_EQ(governor.rung(), rightRung(lakeCosts, 100.0, target)) << target;
        EXPECT_EQ(machine.changes, 1) << target;
    }
}

TEST(Governor, ATooHeavyViewIsLeftWithinFewFrames)
{
    Machine machine;
    Governor governor(lakeCosts, 33.3);
    machine.load = [](double now) { return now < 10.0 ? 33.0 : 1000.0; };
    machine.run(governor, 10.0);
    const std::size_t before = machine.rungs.size();
    machine.run(governor, 10.0);
    const auto frames = std::count_if(machine.rungs.begin() + static_cast<std::ptrdiff_t>(before), machine.rungs.end(),
                                      [](std::size_t rung) { return rung < 9; });
    EXPECT_LE(frames, 2) << "a second's frame is not waited for twice";
    EXPECT_EQ(governor.rung(), 9u);
}

TEST(Governor, DoesNotOscillateUnderNoise)
{
    for (const double noise : {0.02, 0.05, 0.1, 0.15})
        for (const double load : {35.0, 41.0, 57.0, 75.0, 111.0, 163.0, 211.0}) {
            Machine machine;
            machine.noise = noise;
            machine.load = [=](double) { return load; };
            Governor governor(lakeCosts, 33.3);
            machine.run(governor, 600.0);
            EXPECT_LE(machine.changes, noise <= 0.05  ? 3
                                       : noise <= 0.1 ? 12
                                                      : 20)
                << "in ten minutes, noise " << noise << ", load " << load;
            EXPECT_LT(machine.slower(33.3 * 1.08 * (1.0 + 2.0 * noise), 3000), 0.05) << noise << " " << load;
        }
}

TEST(Governor, HitchesAreNoReason)
{
    Machine machine;
    machine.noise = 0.03;
    machine.hitches = 0.01;
    Governor governor(lakeCosts, 33.3);
    machine.run(governor, 600.0);
    EXPECT_LE(machine.changes, 8) << "in ten minutes with some 200 hitches";
    const std::size_t right = rightRung(lakeCosts, 100.0, 33.3);
    EXPECT_NEAR(static_cast<double>(governor.rung()), static_cast<double>(right), 1.0);
}

TEST(Governor, FollowsDriftWithoutSwinging)
{
    Machine machine;
    machine.noise = 0.03;
    machine.load = [](double now) { return 60.0 + 40.0 * std::sin(now / 60.0 * 2.0 * std::numbers::pi); };
    Governor governor(lakeCosts, 33.3);
    machine.run(governor, 600.0); // ten rounds, each about five rungs down and five up again
    EXPECT_LE(machine.changes, 140);
    EXPECT_LT(machine.slower(33.3 * 1.3, machine.times.size()), 0.02);
    EXPECT_GE(*std::max_element(machine.rungs.begin() + 100, machine.rungs.end()), 5u);
    EXPECT_LE(*std::min_element(machine.rungs.begin(), machine.rungs.end()), 1u);
}

TEST(Governor, LearnsWhatARungTrulyCosts)
{
    for (const std::size_t wrong : {2u, 3u, 4u, 5u, 6u})
        for (const double factor : {0.5, 1.4, 2.5, 5.0}) {
            Machine machine;
            machine.noise = 0.02;
            machine.costs[wrong] *= factor;
            Governor governor(lakeCosts, 33.3);
            machine.run(governor, 60.0);
            machine.changes = 0;
            machine.run(governor, 600.0);
            EXPECT_LE(machine.changes, 4) << "rung " << wrong << " costs " << factor << " of what the ladder says";
            EXPECT_LE(machine.load(0.0) * machine.costs[governor.rung()], 33.3 * 1.08) << wrong << " " << factor;
        }
}

TEST(Governor, HoldsTheTargetOnALadderThatIsOfAnotherScene)
{
    // Costs fall far less, or more, than the ladder says.
    for (const double power : {0.4, 0.7, 1.5}) {
        Machine machine;
        machine.noise = 0.03;
        for (double& cost : machine.costs) cost = std::pow(cost, power);
        Governor governor(lakeCosts, 50.0);
        machine.run(governor, 10.0);
        EXPECT_LE(machine.changes, 5) << power;
        machine.changes = 0;
        machine.run(governor, 300.0);
        EXPECT_LE(machine.changes, 3) << power;
        EXPECT_LE(machine.load(0.0) * machine.costs[governor.rung()], 50.0 * 1.08) << power;
        ASSERT_GT(governor.rung(), 0u) << power;
        EXPECT_GT(machine.load(0.0) * machine.costs[governor.rung() - 1], 50.0 * 0.8) << power;
    }
}

TEST(Governor, ATargetThatNoRungMeetsEndsOnTheCheapest)
{
    for (const double load : {400.0, 1000.0, 30000.0}) {
        Machine machine;
        machine.noise = 0.05;
        machine.load = [=](double) { return load; };
        Governor governor(lakeCosts, 33.3);
        machine.run(governor, 600.0);
        EXPECT_EQ(governor.rung(), 9u);
        EXPECT_EQ(machine.changes, 0) << load;
    }
}

TEST(Governor, TakesOnlyRungsThatAreReady)
{
    Machine machine;
    std::set<std::size_t> ready{9, 8, 5, 1};
    machine.isReady = [&](std::size_t rung) { return ready.contains(rung); };
    Governor governor(lakeCosts, 33.5);
    machine.run(governor, 10.0);
    EXPECT_EQ(governor.rung(), 5u);
    governor.setTarget(45.0);
    machine.run(governor, 10.0);
    EXPECT_EQ(governor.rung(), 5u);
    EXPECT_EQ(governor.wanted(), 4u) << "worth building";
    ready.insert(4);
    machine.run(governor, 10.0);
    EXPECT_EQ(governor.rung(), 4u);
    governor.setTarget(27.0);
    machine.run(governor, 10.0);
    EXPECT_EQ(governor.rung(), 8u) << "6 and 7 would have to be built first";
    for (const std::size_t rung : machine.rungs) EXPECT_TRUE(ready.contains(rung)) << rung;
}

TEST(Governor, NonsenseIsNoTime)
{
    Governor governor(lakeCosts, 33.3);
    const double nan = std::nan("");
    for (const double ms : {nan, -1.0, 0.0, HUGE_VAL})
        for (int i = 0; i < 20; ++i) EXPECT_EQ(governor.drawn({ms, 0.1 * i}), 9u);
    EXPECT_FALSE(governor.predicted(0));
    Governor lone({1.0}, 33.3);
    for (int i = 0; i < 20; ++i) EXPECT_EQ(lone.drawn({500.0, 0.5 * i}), 0u);
}

TEST(Governor, PredictsAndLearnsFromFramesDrawnElsewhere)
{
    Machine machine;
    Governor governor(lakeCosts, 33.3);
    machine.run(governor, 10.0);
    EXPECT_NEAR(*governor.predicted(0), 100.0, 1e-6);
    governor.observed(0, 250.0);
    EXPECT_NEAR(*governor.predicted(0), 250.0, 1e-6);
    governor.interrupted();
    EXPECT_NEAR(*governor.predicted(0), 250.0, 1e-6) << "what was learnt stays";
}

/// A governor that has settled under a load.
Governor settled(double load)
{
    Machine machine;
    machine.load = [=](double) { return load; };
    Governor governor(lakeCosts, 33.3);
    machine.run(governor, 20.0);
    return governor;
}

TEST(Refinement, MovingWavesAreLeftToTheGovernor)
{
    const Governor governor = settled(100.0);
    Refinement refinement;
    for (double now = 0.0; now < 20.0; now += 0.03) {
        const Refinement::Step step = refinement.next({now, false, false}, governor);
        EXPECT_EQ(step.rung, governor.rung());
        EXPECT_EQ(step.sample, 0);
        EXPECT_FALSE(step.isFinal);
    }
}

TEST(Refinement, AStillPictureRisesToItsOwnSettingsAndIsThenAveraged)
{
    for (const double load : {20.0, 100.0, 3000.0}) {
        const Governor governor = settled(load);
        Refinement refinement;
        double now = 50.0;
        Refinement::Step step = refinement.next({now, true, true}, governor);
        std::size_t rung = step.rung;
        EXPECT_EQ(rung, governor.rung());
        int sample = 0, frames = 0;
        const double begun = now;
        while (!step.isFinal && ++frames < 10000) {
            const double ms = *governor.predicted(step.rung);
            if (step.rung < rung || step.sample > sample) {
                EXPECT_LE(ms, 1e3 * std::max(now - begun, 1.0) + 33.3) << "longer than it has rested";
            }
            EXPECT_LE(step.rung, rung) << "never back";
            EXPECT_LE(step.sample, sample + 1) << "none is left out";
            rung = step.rung;
            sample = step.sample;
            now += step.sample > 0 || frames == 1 ? 1e-3 * ms : 0.02;
            step = refinement.next({now, false, true}, governor);
        }
        EXPECT_EQ(step.rung, 0u) << load;
        EXPECT_EQ(step.sample, Refinement::samples) << load;
        EXPECT_TRUE(refinement.next({now + 100.0, false, true}, governor).isFinal) << "and stays";
    }
}

TEST(Refinement, AnyTouchBringsTheFluidRungBackAtOnce)
{
    const Governor governor = settled(100.0);
    Refinement refinement;
    double now = 0.0;
    for (int i = 0; i < 200; ++i) refinement.next({now += 0.1, i == 0, true}, governor);
    EXPECT_TRUE(refinement.next({now += 0.1, false, true}, governor).isFinal);
    EXPECT_TRUE(refinement.isResting());
    const Refinement::Step touched = refinement.next({now += 0.1, true, true}, governor);
    EXPECT_EQ(touched.rung, governor.rung());
    EXPECT_EQ(touched.sample, 0);
    EXPECT_FALSE(touched.isFinal);
    EXPECT_FALSE(refinement.isResting());
    // The waves let go: the same.
    for (int i = 0; i < 200; ++i) refinement.next({now += 0.1, false, true}, governor);
    EXPECT_EQ(refinement.next({now += 0.1, false, false}, governor).rung, governor.rung());
}

TEST(Refinement, WaitsForPrograms)
{
    const Governor governor = settled(100.0);
    Refinement refinement;
    const Governor::IsReady isReady = [&](std::size_t rung) { return rung >= 3; };
    Refinement::Step step;
    for (double now = 0.0; now < 20.0; now += 0.1) {
        step = refinement.next({now, now == 0.0, true}, governor, isReady);
        EXPECT_TRUE(isReady(step.rung));
    }
    EXPECT_EQ(refinement.wanted(), 0u);
    EXPECT_FALSE(step.isFinal);
    for (double now = 20.0; now < 30.0; now += 0.1) step = refinement.next({now, false, true}, governor);
    EXPECT_TRUE(step.isFinal);
}

TEST(Refinement, SamplesFillThePixelAndBeginInItsMiddle)
{
    EXPECT_EQ(jitterOf(1), vec2(0.0f));
    EXPECT_EQ(jitterOf(0), vec2(0.0f));
    std::set<std::pair<int, int>> cells;
    vec2 mean(0.0f);
    for (int n = 1; n <= Refinement::samples; ++n) {
        const vec2 at = jitterOf(n);
        ASSERT_TRUE(glm::all(glm::lessThanEqual(glm::abs(at), vec2(0.5f)))) << n;
        cells.insert(
            {static_cast<int>(std::floor((at.x + 0.5f) * 4.0f)), static_cast<int>(std::floor((at.y + 0.5f) * 4.0f))});
        mean += at / static_cast<float>(Refinement::samples);
    }
    EXPECT_GE(cells.size(), 11u) << "of sixteen";
    EXPECT_LT(glm::length(mean), 0.06f) << "or the picture would move";
}

} // namespace
} // namespace tarn
