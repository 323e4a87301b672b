// Holds a frame's time at a target by moving along a ladder of settings (plan/ladder.h). Pure: times in, a rung out.
//
//     Governor governor(costs, 33.3);
//     std::size_t rung = governor.rung();
//     …draw a frame with it…
//     rung = governor.drawn({milliseconds, now}, isReady);
//
// Costs are ratios, so that what a frame takes on one rung predicts what it takes on all others, on any machine and in
// any scene: a change goes straight to the right rung. Where a rung turns out to cost something else than the ladder
// says, that is learnt from the step itself, so that the same mistake is not made twice.
//
// It does not oscillate: it goes down only when frames are too long by more than a tolerance, up only when the more
// accurate rung is predicted to leave a reserve, and a rung that was tried and was too slow is left alone until the
// load has fallen, or a time has passed that is four times as long after every failure.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace tarn {

struct GovernorTuning {
    double tooSlow = 1.08;      ///< of the target: the median that is not accepted
    double farTooSlow = 1.3;    ///< the same, for the shorter of two frames that follow each other
    double aim = 0.9;           ///< of the target: what a new rung is predicted to take at most
    double secondsUp = 0.4;     ///< on a rung before a more accurate one
    double secondsBarred = 3.0; ///< once a rung was too slow; each further time four times as long
    double lighter = 0.85;      ///< of the load at the failure: the bar is lifted
    int framesUnderWay = 1;     ///< of the settings before, whose times are still to come after a change
};

class Governor {
public:
    struct Frame {
        double milliseconds = 0.0; ///< that drawing it took
        double now = 0.0;          ///< s, of a clock that never goes back
    };
    /// Whether a rung can be drawn at once, without building programs.
    using IsReady = std::function<bool(std::size_t rung)>;

    /// Starts on the cheapest rung. @param costs of the rungs, from the most accurate to the cheapest; ratios
    /// @param targetMs of a frame
    Governor(std::vector<double> costs, double targetMs, const GovernorTuning& tuning = {});

    /// Goes on from a rung on which nothing is known yet.
    void startAt(std::size_t rung);

    /// What was learnt stays.
    void setTarget(double targetMs);
    double target() const { return target_; } ///< ms

    std::size_t rung() const { return rung_; }
    std::size_t rungs() const { return costs_.size(); }

    /// A frame was drawn on rung(). Returns the rung of the next one.
    std::size_t drawn(const Frame& frame, const IsReady& isReady = {});

    /// Frames were drawn with other settings meanwhile (a refined picture): what the next one takes may be out of line.
    void interrupted();

    /// What a frame took on a rung that it was not asked to draw: it is learnt from.
    void observed(std::size_t rung, double milliseconds);

    /// What a rung is predicted to take, ms; nothing before the first frame was timed.
    std::optional<double> predicted(std::size_t rung) const;

    /// The rung that it would be on if all were ready: whose programs are worth building while nothing moves.
    std::size_t wanted() const { return wanted_; }

private:
    struct Known {
        bool isKnown = false;
        double logFactor = 0.0;     ///< learnt: true over stated cost, relative to the other rungs
        double loadLearnt = 0.0;    ///< ms of a frame of cost 1, then
        double barredUntil = 0.0;   ///< s
        double loadAtFailure = 0.0; ///< ms of a frame of cost 1
        int failures = 0;
        bool isForgiven = true; ///< the bar's time has passed, and been taken notice of
    };
    /// The rung that this one was reached from.
    struct Step {
        std::size_t from = 0;
        double milliseconds = 0.0; ///< of its frames
    };

    double logFactor(std::size_t rung) const;
    double load() const;
    bool isTooSlow();
    bool isLighter(std::size_t rung) const;
    bool isBarred(std::size_t rung) const;
    std::size_t bestAbove(const IsReady& isReady) const;
    std::size_t bestBelow(const IsReady& isReady) const;
    void learn(std::size_t rung, std::size_t from, double ratio);
    void learnFromStep();
    void noteFailure();
    void forgive();
    void moveTo(std::size_t rung);

    std::vector<double> costs_;
    GovernorTuning tuning_;
    double target_;
    std::size_t rung_, wanted_;
    std::vector<Known> known_;
    std::vector<double> recent_;     ///< ms of the last frames on this rung
    double settled_ = 0.0;           ///< ms: their median, or the last that there was; 0: none yet
    bool isJudged_ = false;          ///< that comes of enough frames to learn from
    int skipped_;                    ///< frames still to be left out of account
    double now_ = 0.0, since_ = 0.0; ///< s: of the last frame, and of the first on this rung
    std::optional<Step> step_;       ///< until it is learnt from
};

} // namespace tarn
