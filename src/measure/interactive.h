// How a program feels under the hand: the time from picture to picture, and the delay from an input to the
// picture that shows it, while a recording of inputs is played at its own speed.
//
// An input is due at a moment of the recording. The loop is a viewer's: take the inputs that are due, draw a
// frame, wait for it to be finished, begin again. An input that comes while a frame is drawn waits for the
// next one, so that its delay lies between one and two frames.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace tarn {

/// What the next frame shows.
struct InteractiveFrame {
    std::size_t firstInput = 0; ///< of those that the frame is the first to show
    std::size_t inputCount = 0;
    double time = 0.0; ///< of the recording when the frame begins, s
};

struct InteractiveTimes {
    std::vector<double> frameMs; ///< from the end of one picture to that of the next
    std::vector<double> delayMs; ///< of each input, from when it was due to the end of the first picture that shows it
};

/// Plays a recording and goes on until every input has been shown.
/// @param due moments of the inputs, s, ascending from 0 on; at least one
/// @param now seconds of a clock that never goes back
/// @param draw takes the inputs, draws, and returns when the picture is finished
/// Throws Error when there is no input or they are not in order.
InteractiveTimes playInputs(std::span<const double> due, const std::function<double()>& now,
                            const std::function<void(const InteractiveFrame&)>& draw);

nlohmann::json toJson(const InteractiveTimes& times);
/// For people.
std::string toTable(const InteractiveTimes& times);

} // namespace tarn
