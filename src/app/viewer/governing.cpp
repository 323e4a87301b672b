// With which settings the viewer's picture is drawn (app/viewer/governed_settings.h).
#include "app/ladder_file.h"
#include "app/viewer/viewer.h"
#include "base/progress.h"
#include "render/warm_up.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace tarn {

namespace {

/// On a card several frames are under way, whose times come later.
GovernorTuning tuningFor(const gl::Window& window)
{
    GovernorTuning tuning;
    if (!window.isSoftware()) tuning.framesUnderWay = 5;
    return tuning;
}

/// What a frame took: on a card what the card did, or the processor where that was longer. 0: not known yet.
double drawingMs(const FrameDelivery& delivery, bool isSoftware)
{
    if (isSoftware) return delivery.milliseconds;
    for (const gl::PassTime& time : delivery.passes)
        if (time.name == "frame") return std::max(time.gpuMs, time.wallMs);
    return 0.0;
}

/// Ends the building of programs after one that took long, unless that was there already, or when it is to stop.
class Slice : public Progress {
public:
    struct Ended {};

    Slice(const std::atomic<bool>& stops, int before) : stops_(stops), before_(before) {}

    void report(double /*fraction*/, const std::string& /*what*/) override
    {
        constexpr std::chrono::milliseconds longTime{20};
        const auto now = std::chrono::steady_clock::now();
        const bool tookLong = now - last_ > longTime;
        last_ = now;
        ++reached_;
        if (stops_ || (tookLong && reached_ > before_ + 1)) throw Ended{};
    }
    int reached() const { return reached_; }

private:
    const std::atomic<bool>& stops_;
    int before_, reached_ = 0;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Leaves the renderer as it was. Returns how far it came, to be told the next time, or a negative number at the end.
int buildSlice(Renderer& renderer, const Options& options, const WaterBody& water, const std::atomic<bool>& stops,
               int before)
{
    const Options drawn = renderer.options();
    Slice slice(stops, before);
    int reached = -1;
    renderer.setOptions(options, water);
    try {
        warmUp(renderer, water, &slice);
    } catch (const Slice::Ended&) {
        reached = std::max(slice.reached(), before);
    }
    renderer.setOptions(drawn, water);
    return reached;
}

bool movesWithTime(const WaterBody& water)
{
    return water.present && (totalAmplitude(water) > 0.0f || water.normalMap.isSeen());
}

} // namespace

void Viewer::beginToGovern()
{
    float& target = sceneSetup_.settings.options.frame.targetMs;
    if (command_.fps) target = *command_.fps > 0.0 ? static_cast<float>(1e3 / *command_.fps) : 0.0f;
    lastTargetMs_ = target > 0.0f ? target : FrameOptions{}.targetMs;
    const std::string& name = sceneSetup_.scene.name;
    governed_.emplace(readLadder(command_.ladder.empty() ? shippedLadder() : command_.ladder), sceneSetup_.settings,
                      name.empty() ? sceneSetup_.scene.file.stem().string() : name, tuningFor(window_));
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
    return !sceneSetup_.settings.options.stereo.isOn() && view_ == DebugView::final &&
           (clock_.paused() || !movesWithTime(sceneSetup_.settings.water));
}

/// What was asked for is drawn: a sample only once it was seen, so that none is left out.
bool Viewer::isAnswered() const
{
    if (part_.isFinal) return false;
    if (part_.sample == 0) return nothingToAsk() || picture_.answered() != answeredAtPart_;
    const FrameDelivery& delivery = picture_.delivery();
    return delivery.sample == part_.sample && delivery.options == governed_->drawn().options;
}

/// Decides on the next frame once the last one is drawn, or at once when the person has touched anything.
void Viewer::govern(ivec2 size)
{
    disturbed_ = isDisturbed(size) || disturbed_;
    const bool isTouched = governed_->setOwn(sceneSetup_.settings) || disturbed_;
    const bool suspended = compares() && comparison_->state().shown() != ComparisonMode::off;
    if (isTouched || isAnswered() || suspended) {
        answeredAtPart_ = picture_.answered();
        const bool wasRefining = part_.isRefining;
        part_ =
            governed_->next({.now = lastFrame_, .disturbed = disturbed_, .isStill = isStill(), .suspended = suspended});
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
    const FrameDelivery& delivery = picture_.delivery();
    if (delivery.report.rule(RuleId::keepFrame).applies) return;
    if (part_.isFinal) disturbed_ = true; // a shader was edited: what was averaged is out of date
    const double ms = drawingMs(delivery, window_.isSoftware());
    const bool isBuilding = built_.valid(); // tiny frames between make the next one longer
    if (ms > 0.0 && !isBuilding) governed_->took({delivery.options, delivery.sample, ms, lastFrame_});
}

/// A slice at a time, with frames between, so that neither the waves nor whatever is touched waits for more than a
/// program.
void Viewer::buildAtRest()
{
    const std::optional<Options> wanted = picture_.isFull() ? governed_->toBuild() : std::nullopt;
    const bool isSame = wanted && building_ == *wanted;
    if (built_.valid()) {
        if (!isSame) *buildingStops_ = true;
        if (built_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
        builtBefore_ = built_.get();
        if (builtBefore_ < 0) governed_->noteBuilt(building_);
        return;
    }
    if (!wanted) return;
    if (!isSame || builtBefore_ < 0) builtBefore_ = 0;
    building_ = *wanted;
    buildingStops_ = std::make_shared<std::atomic<bool>>(false);
    const auto promise = std::make_shared<std::promise<int>>();
    built_ = promise->get_future();
    picture_.post([promise, options = building_, water = sceneSetup_.settings.water, stops = buildingStops_,
                   before = builtBefore_](FrameSource& source) {
        promise->set_value(buildSlice(*source.renderer(), options, water, *stops, before));
    });
}

void Viewer::toggleGovernor()
{
    float& target = sceneSetup_.settings.options.frame.targetMs;
    if (target > 0.0f)
        lastTargetMs_ = std::exchange(target, 0.0f);
    else
        target = lastTargetMs_;
    say(target > 0.0f ? fmt::format("governor on: {:.3g} ms a frame", target) : "governor off: your own settings");
}

} // namespace tarn
