// With which settings the viewer's picture is drawn (app/viewer/governed_settings.h).
#include "app/ladder_file.h"
#include "app/viewer/viewer.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace tarn
{

namespace
{

/// On a card several frames are under way, whose times come later.
GovernorTuning tuningFor(const gl::Window& window)
{
    GovernorTuning tuning;
    if (!window.isSoftware()) tuning.framesUnderWay = 5;
    return tuning;
}

/// What a frame took: on a card what the card did, or the processor where that was longer. 0: not known yet.
double drawingMs(const FrameReport& report, bool isSoftware)
{
    if (isSoftware) return report.milliseconds;
    for (const gl::PassTime& time : report.passes)
        if (time.name == "frame") return std::max(time.gpuMs, time.wallMs);
    return 0.0;
}

bool movesWithTime(const WaterBody& water)
{
    return water.present && (totalAmplitude(water) > 0.0f || water.normalMap.isSeen());
}

} // namespace

void Viewer::beginToGovern()
{
    float& target = stage_.settings.options.frame.targetMs;
    if (command_.fps) target = *command_.fps > 0.0 ? static_cast<float>(1e3 / *command_.fps) : 0.0f;
    lastTargetMs_ = target > 0.0f ? target : FrameOptions{}.targetMs;
    const std::string& name = stage_.scene.name;
    governed_.emplace(readLadder(command_.ladder.empty() ? shippedLadder() : command_.ladder), stage_.settings,
                      name.empty() ? stage_.scene.file.stem().string() : name, tuningFor(window_));
}

/// Since it was last asked, by the person.
bool Viewer::isDisturbed(ivec2 size)
{
    const Touched touched{camera_.camera(), size, view_, clock_.paused()};
    const bool changed = !(touched == std::exchange(touched_, touched));
    return changed || input_.held().direction() != vec3(0.0f);
}

bool Viewer::isStill() const
{
    return !stage_.settings.options.stereo.isOn() && view_ == DebugView::final &&
           (clock_.paused() || !movesWithTime(stage_.settings.water));
}

/// What was asked for is drawn: a sample only once it was seen, so that none is left out.
bool Viewer::isAnswered() const
{
    if (part_.isFinal) return false;
    if (part_.sample == 0) return nothingToAsk() || picture_.answered() != answeredAtPart_;
    const FrameReport& report = picture_.report();
    return report.sample == part_.sample && report.options == governed_->drawn().options;
}

/// Decides on the next frame once the last one is drawn, or at once when the person has touched anything.
void Viewer::govern(ivec2 size)
{
    disturbed_ = isDisturbed(size) || disturbed_;
    const bool isTouched = governed_->setOwn(stage_.settings) || disturbed_;
    const bool suspended = compares() && comparison_->state().shown() != ComparisonMode::off;
    if (isTouched || isAnswered() || suspended) {
        answeredAtPart_ = picture_.answered();
        const bool wasRefining = part_.isRefining;
        part_ = governed_->next(
            {.now = lastFrame_, .disturbed = disturbed_, .isStill = isStill(), .suspended = suspended});
        // A frame that was begun in leisure is not waited for.
        if (wasRefining && !part_.isRefining) {
            *abandoned_ = true;
            abandoned_ = std::make_shared<std::atomic<bool>>(false);
        }
        disturbed_ = false;
    }
    buildAtRest();
}

/// A new picture is there.
void Viewer::noteDrawn()
{
    if (!picture_.isFull()) return;
    const FrameReport& report = picture_.report();
    if (report.stats.plan.rule(RuleId::keepFrame).applies) return;
    if (part_.isFinal) disturbed_ = true; // a shader was edited: what was averaged is out of date
    const double ms = drawingMs(report, window_.isSoftware());
    const bool isBuilding = built_.valid(); // tiny frames between make the next one longer
    if (ms > 0.0 && !isBuilding) governed_->took({report.options, report.sample, ms, lastFrame_});
}

/// One tiny frame at a time, so that whatever is touched meanwhile waits for no more than one.
void Viewer::buildAtRest()
{
    if (built_.valid()) {
        if (built_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
        built_.get();
        if (toBuild_.empty()) governed_->noteBuilt(building_);
    }
    const std::optional<Options> wanted = picture_.isFull() ? governed_->toBuild() : std::nullopt;
    if (!wanted) return toBuild_.clear();
    const WaterBody& water = stage_.settings.water;
    if (toBuild_.empty() || !(building_ == *wanted)) {
        toBuild_ = warmUpFrames(*wanted, water);
        std::reverse(toBuild_.begin(), toBuild_.end());
        building_ = *wanted;
    }
    const auto promise = std::make_shared<std::promise<void>>();
    built_ = promise->get_future();
    picture_.post([promise, frame = toBuild_.back(), water](FrameSource& source) {
        Renderer& renderer = *source.renderer();
        const Options before = renderer.options();
        drawWarmUp(renderer, frame, water);
        renderer.setOptions(before, water);
        promise->set_value();
    });
    toBuild_.pop_back();
}

void Viewer::toggleGovernor()
{
    float& target = stage_.settings.options.frame.targetMs;
    if (target > 0.0f) lastTargetMs_ = std::exchange(target, 0.0f);
    else target = lastTargetMs_;
    say(target > 0.0f ? fmt::format("governor on: {:.3g} ms a frame", target) : "governor off: your own settings");
}

} // namespace tarn
