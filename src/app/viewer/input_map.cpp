#include "app/viewer/input_map.h"

namespace tarn {

namespace {

struct Binding {
    Action action;
    std::vector<Key> keys;
    const char* names;
    const char* what;
};

const std::vector<Binding>& bindings()
{
    static const std::vector<Binding> table = {
        {Action::forward, {keyOf('W'), Key::up}, "W, Up", "forward"},
        {Action::back, {keyOf('S'), Key::down}, "S, Down", "back"},
        {Action::left, {keyOf('A'), Key::left}, "A, Left", "to the left"},
        {Action::right, {keyOf('D'), Key::right}, "D, Right", "to the right"},
        {Action::rise, {keyOf('E')}, "E", "up"},
        {Action::sink, {keyOf('Q')}, "Q", "down"},
        {Action::fast, {Key::shift}, "Shift", "move fast"},
        {Action::camera,
         {keyOf('1'), keyOf('2'), keyOf('3'), keyOf('4'), keyOf('5'), keyOf('6'), keyOf('7'), keyOf('8'), keyOf('9'),
          keyOf('0')},
         "1 ... 9, 0",
         "jump to a camera of the scene"},
        {Action::caustics, {keyOf('C')}, "C", "caustics on or off"},
        {Action::underwater, {keyOf('U')}, "U", "underwater effects on or off"},
        {Action::glow, {keyOf('G')}, "G", "glow on or off"},
        {Action::reflection, {keyOf('R')}, "R", "reflection on or off"},
        {Action::refraction, {keyOf('F')}, "F", "refraction on or off"},
        {Action::pause, {keyOf('P')}, "P", "stop the waves, or let them go on"},
        {Action::nextView, {keyOf('V')}, "V", "next intermediate picture"},
        {Action::stereo, {keyOf('O')}, "O", "for two eyes: side by side, red-cyan glasses, off"},
        {Action::compare, {keyOf('B')}, "B", "with --reference: beside it, its errors, off; or back to its view"},
        {Action::sliderLeft, {keyOf('[')}, "[", "move the line before the reference to the left"},
        {Action::sliderRight, {keyOf(']')}, "]", "move it to the right"},
        {Action::governor, {keyOf('T')}, "T", "hold the frame's time by cheaper settings, or show your own"},
        {Action::help, {keyOf('H')}, "H", "this help"},
        {Action::panel, {Key::tab}, "Tab", "panel with every option"},
        {Action::screenshot, {Key::f12}, "F12", "save a picture in the current folder"},
        {Action::leave, {Key::escape}, "Esc", "leave"},
    };
    return table;
}

} // namespace

std::optional<KeyCommand> commandOf(Key key)
{
    for (const Binding& binding : bindings())
        for (std::size_t i = 0; i < binding.keys.size(); ++i)
            if (binding.keys[i] == key)
                return KeyCommand{binding.action, binding.action == Action::camera ? static_cast<int>(i) : 0};
    return std::nullopt;
}

bool isHeld(Action action) { return action <= Action::fast; }

bool repeats(Action action) { return action == Action::sliderLeft || action == Action::sliderRight; }

std::vector<HelpLine> helpLines()
{
    std::vector<HelpLine> lines;
    for (const Binding& binding : bindings()) lines.push_back({binding.names, binding.what});
    lines.push_back({"left button", "hold it to look around"});
    lines.push_back({"wheel", "move faster or slower"});
    return lines;
}

vec3 HeldKeys::direction() const
{
    const auto axis = [this](Action plus, Action minus) {
        return static_cast<float>(held(plus)) - static_cast<float>(held(minus));
    };
    return {axis(Action::right, Action::left), axis(Action::rise, Action::sink), axis(Action::forward, Action::back)};
}

bool HeldKeys::held(Action action) const
{
    for (const Key key : keys_) {
        const auto command = commandOf(key);
        if (command && command->action == action) return true;
    }
    return false;
}

} // namespace tarn
