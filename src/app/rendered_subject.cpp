#include "app/rendered_subject.h"

#include "scene/flight.h"

#include <algorithm>
#include <utility>

namespace tarn {

namespace {

constexpr double secondsPerFrame = 1.0 / 30.0;

} // namespace

int longestInterval(const Options& options)
{
    return std::max({options.refraction.interval, options.reflection.interval, options.caustics.interval});
}

RenderedSubject::RenderedSubject(std::string name, Session& session, Settings settings, const SubjectView& view,
                                 bool keepsPictures)
    : name_(std::move(name)), session_(session), settings_(std::move(settings)), view_(view)
{
    if (keepsPictures) return;
    for (const RuleId id : {RuleId::keepFrame, RuleId::keepTargets})
        settings_.options.plan.rules[static_cast<std::size_t>(id)] = false;
}

void RenderedSubject::prepare(int index, bool followsItself)
{
    if (!followsItself) {
        // Of so many frames only one draws all targets: each of them is measured as often as the others.
        const int before = 1 + index % longestInterval(settings_.options);
        for (int i = before; i > 0; --i) drawAt(index - 0.5 * i / before); // the same moment would be kept
    }
    isMeasured_ = true;
}

void RenderedSubject::draw(int index)
{
    drawAt(index);
    plan_ = report_->plan;
    if (!std::exchange(isMeasured_, false)) return;
    ++measuredFrames_;
    for (std::size_t i = 0; i < ruleCount; ++i) ruleFrames_[i] += report_->rules[i].applies ? 1 : 0;
}

void RenderedSubject::drawAt(double index)
{
    session_.renderer().setOptions(settings_.options, settings_.water);
    const Camera camera =
        view_.flight.empty() ? view_.camera : flightCamera(view_.flight, index / std::max(view_.frames - 1, 1));
    report_ = &session_.renderer().render({camera, view_.time + index * secondsPerFrame, view_.size});
    finishGpu();
}

std::vector<BenchPass> RenderedSubject::drawPasses(int index)
{
    session_.profiler().setSynchronous(true);
    drawAt(index + 0.5); // synchronous: its results are in when it ends; of another moment, or it would be kept
    session_.profiler().setSynchronous(false);
    std::vector<BenchPass> passes;
    for (const gl::PassTime& time : session_.profiler().latest())
        if (time.name != "frame") passes.push_back({time.name, time.wallMs, time.cpuMs, triangles(time.name)});
    return passes;
}

std::uint64_t RenderedSubject::triangles(const std::string& pass) const
{
    for (const FrameReport::Pass& drawn : report_->passes)
        if (drawn.name == pass) return drawn.triangles;
    return 0;
}

} // namespace tarn
