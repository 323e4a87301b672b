#include "app/recorded_flight.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>

namespace tarn {

namespace {

constexpr double mouseReports = 60.0;               // a second
constexpr double turnPeriod = 2.0;                  // s, from one side to the other and back
constexpr float sideways = 0.6f, upAndDown = 0.15f; // heights of the window per s, at most

/// What a hand does between two jumps.
void addLeg(std::vector<RecordedInput>& inputs, std::size_t camera, double start, double seconds)
{
    const Key forward = keyOf('W'), side = camera % 2 == 0 ? keyOf('D') : keyOf('A');
    inputs.push_back({start, RecordedInput::Jump{camera}});
    inputs.push_back({start, RecordedInput::Press{forward}});
    inputs.push_back({start + 0.6 * seconds, RecordedInput::Release{forward}});
    inputs.push_back({start + 0.6 * seconds, RecordedInput::Press{side}});
    inputs.push_back({start + 0.9 * seconds, RecordedInput::Release{side}});
    const int reports = static_cast<int>(seconds * mouseReports);
    for (int report = 1; report <= reports; ++report) {
        const double since = report / mouseReports;
        if (since >= seconds) break;
        const auto phase = static_cast<float>(2.0 * static_cast<double>(pi) * since / turnPeriod);
        const vec2 speed(sideways * std::cos(phase), upAndDown * std::sin(phase));
        inputs.push_back({start + since, RecordedInput::Look{speed / static_cast<float>(mouseReports)}});
    }
}

template <typename... Functions> struct Overloaded : Functions... {
    using Functions::operator()...;
};

} // namespace

std::vector<RecordedInput> recordFlight(std::size_t cameras, double seconds)
{
    if (cameras < 1 || !(seconds > 0.0)) throw Error("a flight needs a camera and a time");
    std::vector<RecordedInput> inputs;
    const double leg = seconds / static_cast<double>(cameras);
    for (std::size_t camera = 0; camera < cameras; ++camera)
        addLeg(inputs, camera, leg * static_cast<double>(camera), leg);
    std::stable_sort(inputs.begin(), inputs.end(),
                     [](const RecordedInput& a, const RecordedInput& b) { return a.due < b.due; });
    return inputs;
}

void RecordedPilot::take(std::span<const RecordedInput> inputs, double time)
{
    for (const RecordedInput& input : inputs) apply(input);
    camera_.move(keys_.direction(), keys_.fast(), time - last_);
    last_ = time;
}

void RecordedPilot::apply(const RecordedInput& input)
{
    std::visit(Overloaded{[&](const RecordedInput::Press& press) { keys_.press(press.key); },
                          [&](const RecordedInput::Release& release) { keys_.release(release.key); },
                          [&](const RecordedInput::Look& look) { camera_.look(look.turn, 1.0f); },
                          [&](const RecordedInput::Jump& jump) { camera_.jumpTo(cameras_[jump.camera]); }},
               input.what);
}

} // namespace tarn
