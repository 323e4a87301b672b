// A person at the keys and the mouse, as a recording: for measurements that need the inputs of a real flight.
//
// The scene's cameras are jumped to one after the other, as by the keys 1 to 9, an equal part of the time
// each. From each the eye flies forward, then to a side, while the mouse looks around with a position a 60th
// of a second, as mice report.
#pragma once

#include "app/viewer/fly_camera.h"
#include "app/viewer/input_map.h"

#include <cstddef>
#include <span>
#include <variant>
#include <vector>

namespace tarn {

struct RecordedInput {
    struct Press {
        Key key;
    };
    struct Release {
        Key key;
    };
    struct Look {
        vec2 turn; ///< to the right and down, in heights of the window
    };
    struct Jump {
        std::size_t camera; ///< of the scene
    };
    double due = 0.0; ///< s from the beginning
    std::variant<Press, Release, Look, Jump> what;
};

/// The same for the same arguments. @param cameras of the scene, at least one   @param seconds more than 0
std::vector<RecordedInput> recordFlight(std::size_t cameras, double seconds);

/// The eye of somebody who makes these inputs: moved and turned frame by frame as the viewer does it.
class RecordedPilot {
public:
    /// @param cameras of the scene, at least one; they must outlive it
    explicit RecordedPilot(std::span<const Camera> cameras) : cameras_(cameras), camera_(cameras.front()) {}

    /// Takes the inputs of a frame that begins at a time.
    void take(std::span<const RecordedInput> inputs, double time);

    const Camera& camera() const { return camera_.camera(); }

private:
    void apply(const RecordedInput& input);

    std::span<const Camera> cameras_;
    FlyCamera camera_;
    HeldKeys keys_;
    double last_ = 0.0; ///< time of the last frame
};

} // namespace tarn
