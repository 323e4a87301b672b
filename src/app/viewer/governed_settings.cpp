#include "app/viewer/governed_settings.h"

#include <fmt/format.h>

#include <algorithm>

namespace tarn {

namespace {

constexpr std::size_t mostSets = 64; // of programs that are remembered

std::vector<double> costsOf(const std::vector<OwnRung>& rungs)
{
    std::vector<double> costs;
    for (const OwnRung& rung : rungs) costs.push_back(rung.cost);
    return costs;
}

std::vector<FieldRow> rowsOf(Options options)
{
    return listFields([&options](FieldVisitor& visitor) { visit(visitor, options); });
}

} // namespace

GovernedSettings::GovernedSettings(Ladder ladder, const Settings& own, std::string scene, const GovernorTuning& tuning)
    : ladder_(std::move(ladder)), own_(own), drawn_(own), scene_(std::move(scene)), tuning_(tuning),
      governor_({1.0}, 1.0, tuning)
{
    build();
    if (isOn()) drawn_.options = rungs_[governor_.rung()].options;
}

void GovernedSettings::build()
{
    std::vector<OwnRung> rungs = rungsBelow(own_.options, ladder_);
    const double target = static_cast<double>(own_.options.frame.targetMs);
    startsAtBase_ = startsAtBase(own_.options, ladder_);
    const bool sameCosts = costsOf(rungs) == costsOf(rungs_);
    if (!sameCosts) {
        // As far down the ladder as before.
        const std::size_t before = rungs_.empty() ? ladder_.rungs.size() : rungs_[governor_.rung()].rung;
        governor_ = Governor(costsOf(rungs), target, tuning_);
        const auto as =
            std::find_if(rungs.begin(), rungs.end(), [&](const OwnRung& rung) { return rung.rung >= before; });
        if (as != rungs.end()) governor_.startAt(static_cast<std::size_t>(as - rungs.begin()));
    }
    governor_.setTarget(target);
    rungs_ = std::move(rungs);
    noteReady();
}

bool GovernedSettings::setOwn(const Settings& own)
{
    if (own.options == own_.options && own.water == own_.water) return false;
    own_ = own;
    build();
    touched_ = true;
    return true;
}

void GovernedSettings::noteReady()
{
    ready_.clear();
    for (const OwnRung& rung : rungs_)
        ready_.push_back(std::any_of(built_.begin(), built_.end(),
                                     [&](const Options& built) { return programsServe(built, rung.options); }));
}

GovernedSettings::Part GovernedSettings::next(const Now& now)
{
    suspended_ = now.suspended;
    drawn_ = own_;
    if (!isOn() || suspended_) {
        step_ = {};
        touched_ = true; // by what is done meanwhile
        return {};
    }
    const Refinement::Input input{now.now, now.disturbed || touched_, now.isStill};
    touched_ = false;
    const Refinement::Step last = step_;
    step_ = refinement_.next(input, governor_, [this](std::size_t rung) { return ready_[rung]; });
    const bool wasRefined = last.sample > 0 || last.rung != governor_.rung();
    if (wasRefined && step_.sample == 0 && step_.rung == governor_.rung()) governor_.interrupted();
    drawn_.options = rungs_[step_.rung].options;
    return {step_.sample, step_.isFinal, step_.sample > 0 || step_.rung != governor_.rung()};
}

void GovernedSettings::took(const Drawn& frame)
{
    const auto rung =
        std::find_if(rungs_.begin(), rungs_.end(), [&](const OwnRung& own) { return own.options == frame.options; });
    if (rung == rungs_.end()) return; // the person has changed the settings meanwhile
    const auto index = static_cast<std::size_t>(rung - rungs_.begin());
    if (!ready_[index]) noteBuilt(frame.options);
    if (!isOn() || suspended_) return;
    constexpr int timed = Refinement::samples / 2; // what the first ones make is there, and a card's times are theirs
    if (frame.sample == 0 && step_.sample == 0 && index == governor_.rung())
        governor_.drawn({frame.milliseconds, frame.now}, [this](std::size_t i) { return ready_[i]; });
    else if (frame.sample == timed)
        governor_.observed(index, frame.milliseconds);
}

std::optional<Options> GovernedSettings::toBuild() const
{
    if (!isOn() || suspended_ || !refinement_.isResting()) return std::nullopt;
    const std::size_t rung = refinement_.wanted();
    if (rung >= rungs_.size() || ready_[rung]) return std::nullopt;
    return rungs_[rung].options;
}

void GovernedSettings::noteBuilt(const Options& options)
{
    const auto same = [&](const Options& built) { return programsServe(built, options); };
    if (std::any_of(built_.begin(), built_.end(), same)) return;
    if (built_.size() >= mostSets) built_.erase(built_.begin());
    built_.push_back(options);
    noteReady();
}

/// "scale 0.67, sunlight.taps 1": what is drawn differently from the person's own settings.
std::string GovernedSettings::changesText() const
{
    const std::vector<FieldRow> own = rowsOf(own_.options), drawn = rowsOf(drawn_.options);
    constexpr int mostNamed = 4; // a ladder's lowest rung may change a dozen
    std::string text;
    int changes = 0;
    for (std::size_t i = 0; i < own.size(); ++i) {
        if (own[i].value == drawn[i].value || ++changes > mostNamed) continue;
        const std::string& key = own[i].key;
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", key.starts_with("frame.") ? key.substr(6) : key,
                            drawn[i].value);
    }
    if (changes > mostNamed) text += fmt::format(" and {} more", changes - mostNamed);
    return text.empty() ? "your settings" : text;
}

std::string GovernedSettings::text(double fps) const
{
    if (!isOn()) return "";
    if (suspended_) return "governor waits: these are your settings";
    const Rung& rung = ladder_.rungs[rungs_[step_.rung].rung];
    // Another scene, or other settings than the ladder's base, and what was measured is a guide only.
    const char* about = startsAtBase_ && scene_ == ladder_.scene ? "" : "about ";
    const std::string errors =
        fmt::format("error {}{:.2f}, {:.0f} % wrong hits", about, rung.flip, 100.0 * rung.wrongHits);
    if (step_.sample > 0)
        return fmt::format("at rest: {} of {} samples, {} or less", step_.sample, Refinement::samples, errors);
    return fmt::format("{:.0f} fps, {} ({})", fps, errors, changesText());
}

} // namespace tarn
