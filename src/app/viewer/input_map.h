// Which key does what. One table feeds the window, the help overlay and the tests; it knows no window system.
#pragma once

#include "base/math.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace tarn {

/// Letters, digits and brackets are their own ASCII code, letters in capitals.
enum class Key : int { up = 256, down, left, right, shift, tab, escape, f12 };
constexpr Key keyOf(char letter) { return static_cast<Key>(letter); }

enum class Action {
    // While the key is held
    forward,
    back,
    left,
    right,
    rise,
    sink,
    fast,
    // Once when the key goes down
    camera,
    caustics,
    underwater,
    glow,
    reflection,
    refraction,
    pause,
    nextView,
    stereo,
    compare,
    sliderLeft,
    sliderRight,
    governor,
    help,
    panel,
    screenshot,
    leave,
};

struct KeyCommand {
    Action action;
    int index = 0; ///< camera: which one, from 0
};

/// What the key does, or nothing.
std::optional<KeyCommand> commandOf(Key key);

/// True for actions that last while their key is held.
bool isHeld(Action action);

/// True for actions that happen again and again while their key stays down.
bool repeats(Action action);

struct HelpLine {
    std::string keys, what;
};
/// Every action, in the order to be read, and the mouse.
std::vector<HelpLine> helpLines();

/// The held keys, as a motion.
class HeldKeys {
public:
    void press(Key key) { keys_.insert(key); }
    void release(Key key) { keys_.erase(key); }
    /// The window lost the focus and will not hear of releases.
    void releaseAll() { keys_.clear(); }

    /// x to the right, y up, z forward; each -1, 0 or 1.
    vec3 direction() const;
    bool fast() const { return held(Action::fast); }

private:
    bool held(Action action) const;
    std::set<Key> keys_;
};

} // namespace tarn
