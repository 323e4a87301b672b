#include "gl/profiler.h"

#include "gl/api.h"
#include "gl/context.h"
#include "gl/counters.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>

namespace tarn::gl {

namespace {

constexpr std::size_t noRecord = std::numeric_limits<std::size_t>::max();

double wallMilliseconds()
{
    using namespace std::chrono;
    return duration<double, std::milli>(steady_clock::now().time_since_epoch()).count();
}

/// Of all threads: a software rasteriser works in its own.
double processMilliseconds() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void stamp(Object& query, const std::string& label)
{
    const bool isNew = !query;
    if (isNew) query = Object(Object::Kind::query, label);
    glQueryCounter(query.name(), GL_TIMESTAMP);
    if (isNew) query.announceLabel();
}

double nanoseconds(const Object& query)
{
    GLuint64 value = 0;
    count(Call::queryResult);
    glGetQueryObjectui64v(query.name(), GL_QUERY_RESULT, &value);
    return static_cast<double>(value);
}

bool isAvailable(const Object& query)
{
    GLint available = GL_FALSE;
    count(Call::queryResult);
    glGetQueryObjectiv(query.name(), GL_QUERY_RESULT_AVAILABLE, &available);
    return available == GL_TRUE;
}

void add(std::vector<PassTime>& passes, const PassTime& time)
{
    const auto same =
        std::find_if(passes.begin(), passes.end(), [&](const PassTime& p) { return p.name == time.name; });
    if (same == passes.end()) {
        passes.push_back(time);
        return;
    }
    same->gpuMs += time.gpuMs;
    same->wallMs += time.wallMs;
    same->cpuMs += time.cpuMs;
}

} // namespace

void Profiler::beginFrame()
{
    // A frame that an exception cut short is dropped, and so is one whose results have not come in a whole
    // round.
    if (inFrame_ && capabilities().debug) glPopDebugGroup();
    open_.clear();
    current_ = (current_ + 1) % framesInFlight;
    frames_[current_].used = 0;
    frames_[current_].pending = false;
    inFrame_ = true;
    begin("frame");
}

void Profiler::endFrame()
{
    if (!inFrame_) return;
    end(0);
    inFrame_ = false;
    frames_[current_].pending = true;
    for (std::size_t age = 0; age < framesInFlight; ++age) {
        Frame& frame = frames_[(current_ + framesInFlight - age) % framesInFlight];
        if (!frame.pending || !collect(frame)) continue;
        // Older ones are of no interest any more.
        for (std::size_t older = age; older < framesInFlight; ++older) {
            frames_[(current_ + framesInFlight - older) % framesInFlight].pending = false;
        }
        break;
    }
}

std::size_t Profiler::begin(std::string_view name)
{
    open_.emplace_back(name);
    if (synchronous_) glFinish();
    if (capabilities().debug) {
        glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, static_cast<GLsizei>(name.size()), name.data());
    }
    if (!inFrame_) return noRecord; // work outside of frames is named, not timed
    Frame& frame = frames_[current_];
    if (frame.used == frame.records.size()) frame.records.emplace_back();
    const std::size_t index = frame.used++;
    Record& record = frame.records[index];
    record.name = name;
    stamp(record.begin, "profiler begin");
    record.wallStart = wallMilliseconds();
    record.cpuStart = processMilliseconds();
    return index;
}

void Profiler::end(std::size_t index)
{
    if (!open_.empty()) open_.pop_back();
    const bool isTimed = index != noRecord && inFrame_ && index < frames_[current_].used;
    if (isTimed) stamp(frames_[current_].records[index].end, "profiler end");
    if (synchronous_) glFinish();
    if (isTimed) {
        Record& record = frames_[current_].records[index];
        record.wallMs = wallMilliseconds() - record.wallStart;
        record.cpuMs = processMilliseconds() - record.cpuStart;
    }
    if (capabilities().debug) glPopDebugGroup();
}

bool Profiler::collect(Frame& frame)
{
    // The whole frame's record ends last, and results come in order.
    if (!isAvailable(frame.records.front().end)) return false;
    latest_.clear();
    for (std::size_t i = 0; i < frame.used; ++i) {
        const Record& r = frame.records[i];
        const double gpuMs = 1e-6 * (nanoseconds(r.end) - nanoseconds(r.begin));
        add(latest_, {r.name, std::max(gpuMs, 0.0), r.wallMs, r.cpuMs});
    }
    return true;
}

} // namespace tarn::gl
