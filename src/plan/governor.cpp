#include "plan/governor.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tarn {

namespace {

constexpr std::size_t framesRemembered = 9;
constexpr std::size_t framesToJudge = 5; // a median of fewer says little
constexpr std::size_t framesToLearn = 3;
constexpr double mostFactor = 8.0;  // between a true and a stated cost
constexpr double sameLoad = 1.25;   // what was learnt under another load counts half
constexpr double worthMoving = 0.9; // of the present time, for a rung that does not keep the target either
constexpr double slowAlone = 200.0; // ms: such a frame counts alone when it is far off, for a second one costs too much
constexpr double farOff = 4.0;      // times the target
constexpr int mostQuadruplings = 6;

double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace

Governor::Governor(std::vector<double> costs, double targetMs, const GovernorTuning& tuning)
    : costs_(std::move(costs)), tuning_(tuning), target_(targetMs)
{
    startAt(costs_.empty() ? 0 : costs_.size() - 1);
}

void Governor::startAt(std::size_t rung)
{
    rung_ = wanted_ = rung;
    known_.assign(costs_.size(), {});
    if (!known_.empty()) known_[rung_].isKnown = true; // what the others are relative to
    settled_ = 0.0;
    interrupted();
}

void Governor::setTarget(double targetMs)
{
    if (targetMs == target_) return;
    target_ = targetMs;
    for (Known& known : known_) known.failures = 0;
}

void Governor::interrupted()
{
    recent_.clear();
    step_.reset();
    skipped_ = tuning_.framesUnderWay;
}

/// Of rungs that were never drawn it lies between those of the nearest that were.
double Governor::logFactor(std::size_t rung) const
{
    std::size_t above = rung, under = rung;
    while (above > 0 && !known_[above].isKnown) --above;
    while (under + 1 < known_.size() && !known_[under].isKnown) ++under;
    if (!known_[above].isKnown) return known_[under].logFactor; // one always is
    if (!known_[under].isKnown || above == under) return known_[above].logFactor;
    const double part = std::log(costs_[above] / costs_[rung]) / std::log(costs_[above] / costs_[under]);
    return known_[above].logFactor + part * (known_[under].logFactor - known_[above].logFactor);
}

/// ms of a frame of cost 1.
double Governor::load() const { return settled_ / (costs_[rung_] * std::exp(logFactor(rung_))); }

std::optional<double> Governor::predicted(std::size_t rung) const
{
    if (settled_ <= 0.0 || rung >= costs_.size()) return std::nullopt;
    double factor = logFactor(rung) - logFactor(rung_);
    const Known& known = known_[rung];
    if (known.isKnown && known.loadLearnt > 0.0) {
        const double change = load() / known.loadLearnt;
        if (std::max(change, 1.0 / change) > sameLoad) factor *= 0.5;
    }
    return settled_ * costs_[rung] / costs_[rung_] * std::exp(factor);
}

/// One long frame alone is a hitch of the machine, unless it is so long that a second one would be felt.
bool Governor::isTooSlow()
{
    if (recent_.empty()) return false;
    const double last = recent_.back();
    const bool isAlone = recent_.size() == 1;
    if (isAlone && last <= std::max(slowAlone, farOff * target_)) return false;
    const double both = isAlone ? last : std::min(last, recent_[recent_.size() - 2]);
    if (isAlone || both > tuning_.farTooSlow * target_) {
        settled_ = both; // the frames before were of another load, or these are hitches
        isJudged_ = false;
        return true;
    }
    return recent_.size() >= framesToJudge && settled_ > tuning_.tooSlow * target_;
}

/// Than when the rung failed, clearly. Where that was not clear enough and it failed again, all the more.
bool Governor::isLighter(std::size_t rung) const
{
    constexpr int most = 3;
    const Known& known = known_[rung];
    return load() < std::pow(tuning_.lighter, std::min(known.failures, most)) * known.loadAtFailure;
}

bool Governor::isBarred(std::size_t rung) const { return now_ < known_[rung].barredUntil && !isLighter(rung); }

/// The most accurate rung above this one that is predicted to keep the target with its reserve, else this one.
std::size_t Governor::bestAbove(const IsReady& isReady) const
{
    for (std::size_t i = 0; i < rung_; ++i)
        if (!isBarred(i) && *predicted(i) <= tuning_.aim * target_ && (!isReady || isReady(i))) return i;
    return rung_;
}

/// The first rung under this one that is predicted to keep it, else the one that comes nearest.
std::size_t Governor::bestBelow(const IsReady& isReady) const
{
    std::size_t nearest = rung_;
    double least = worthMoving * settled_;
    for (std::size_t i = rung_ + 1; i < costs_.size(); ++i) {
        if (isReady && !isReady(i)) continue;
        const double ms = *predicted(i);
        if (ms <= tuning_.aim * target_) return i;
        if (ms < least) {
            least = ms;
            nearest = i;
        }
    }
    return nearest;
}

/// @param ratio of the time of a frame on a rung to that on another, measured
void Governor::learn(std::size_t rung, std::size_t from, double ratio)
{
    const double found = logFactor(from) + std::log(ratio) - std::log(costs_[rung] / costs_[from]);
    const double most = std::log(mostFactor);
    Known& known = known_[rung];
    // Two visits may have seen two views: the truth lies between.
    known.logFactor = std::clamp(known.isKnown ? 0.5 * (known.logFactor + found) : found, -most, most);
    known.isKnown = true;
    known.loadLearnt = load();
}

void Governor::learnFromStep()
{
    if (!step_) return;
    const Step step = *std::exchange(step_, std::nullopt);
    learn(rung_, step.from, settled_ / step.milliseconds);
}

void Governor::observed(std::size_t rung, double milliseconds)
{
    if (rung == rung_ || rung >= costs_.size() || settled_ <= 0.0 || !(milliseconds > 0.0)) return;
    learn(rung, rung_, milliseconds / settled_);
}

void Governor::noteFailure()
{
    Known& known = known_[rung_];
    known.barredUntil = now_ + tuning_.secondsBarred * std::pow(4.0, std::min(known.failures, mostQuadruplings));
    known.loadAtFailure = load();
    known.isForgiven = false;
    ++known.failures;
}

/// What was learnt at a failure may be a hitch's fault. Once the bar's time has passed half of it is forgotten, so that
/// the rung may be tried again.
void Governor::forgive()
{
    for (std::size_t i = 0; i < rung_; ++i) {
        Known& known = known_[i];
        if (known.isForgiven || now_ < known.barredUntil) continue;
        known.isForgiven = true;
        known.logFactor = 0.5 * (known.logFactor + logFactor(rung_));
    }
}

void Governor::moveTo(std::size_t rung)
{
    if (rung == rung_) return;
    Known& known = known_[rung];
    if (known.failures > 0 && isLighter(rung)) known.failures = 0;
    // Two long frames may have been hitches: they are no measure for a rung that was measured before.
    if (isJudged_ || !known.isKnown)
        step_ = Step{rung_, settled_};
    else
        step_.reset();
    // Until it is timed, the best that is known of the new rung.
    settled_ = *predicted(rung);
    rung_ = rung;
    recent_.clear();
    skipped_ = tuning_.framesUnderWay; // and the first makes its targets
    since_ = now_;
}

std::size_t Governor::drawn(const Frame& frame, const IsReady& isReady)
{
    if (costs_.empty() || !(frame.milliseconds > 0.0) || !std::isfinite(frame.milliseconds)) return rung_;
    now_ = frame.now;
    if (skipped_ > 0) {
        --skipped_;
        if (settled_ <= 0.0) settled_ = frame.milliseconds; // better than nothing to predict from
        return rung_;
    }
    recent_.push_back(frame.milliseconds);
    if (recent_.size() > framesRemembered) recent_.erase(recent_.begin());
    settled_ = median(recent_);
    isJudged_ = recent_.size() >= framesToLearn;
    const bool tooSlow = isTooSlow();
    if (recent_.size() >= (tooSlow ? 2 : framesToLearn)) learnFromStep();
    if (tooSlow) {
        const std::size_t next = bestBelow(isReady);
        wanted_ = bestBelow({});
        noteFailure();
        moveTo(next);
    } else if (recent_.size() >= framesToJudge && now_ - since_ >= tuning_.secondsUp) {
        forgive();
        const std::size_t next = bestAbove(isReady);
        wanted_ = bestAbove({});
        moveTo(next);
    }
    return rung_;
}

} // namespace tarn
