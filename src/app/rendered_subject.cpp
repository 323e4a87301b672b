#include "app/rendered_subject.h"

namespace tarn {

namespace {

constexpr double secondsPerFrame = 1.0 / 30.0;

} // namespace

RenderedSubject::RenderedSubject(std::string name, Session& session, Settings settings,
                                 const SubjectView& view)
    : name_(std::move(name)), session_(session), settings_(std::move(settings)), view_(view)
{}

void RenderedSubject::draw(int index)
{
    session_.renderer().setOptions(settings_.options, settings_.water);
    stats_ = &session_.renderer().render({view_.camera, view_.time + index * secondsPerFrame, view_.size});
    finishGpu();
}

std::vector<BenchPass> RenderedSubject::drawPasses(int index)
{
    session_.profiler().setSynchronous(true);
    draw(index); // synchronous: its results are in when it ends
    session_.profiler().setSynchronous(false);
    std::vector<BenchPass> passes;
    for (const gl::PassTime& time : session_.profiler().latest())
        if (time.name != "frame")
            passes.push_back({time.name, time.wallMs, time.cpuMs, triangles(time.name)});
    return passes;
}

std::uint64_t RenderedSubject::triangles(const std::string& pass) const
{
    for (const FrameStats::Pass& stats : stats_->passes)
        if (stats.name == pass) return stats.triangles;
    return 0;
}

} // namespace tarn
