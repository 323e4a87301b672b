#include "app/viewer/glfw_input.h"

#include "app/viewer/imgui_layer.h"

#include <GLFW/glfw3.h>

#include <utility>

namespace tarn {

namespace {

std::optional<Key> keyFromGlfw(int key)
{
    switch (key) {
    case GLFW_KEY_UP: return Key::up;
    case GLFW_KEY_DOWN: return Key::down;
    case GLFW_KEY_LEFT: return Key::left;
    case GLFW_KEY_RIGHT: return Key::right;
    case GLFW_KEY_LEFT_SHIFT:
    case GLFW_KEY_RIGHT_SHIFT: return Key::shift;
    case GLFW_KEY_TAB: return Key::tab;
    case GLFW_KEY_ESCAPE: return Key::escape;
    case GLFW_KEY_F12: return Key::f12;
    default: break;
    }
    if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) return keyOf(static_cast<char>('0' + key - GLFW_KEY_KP_0));
    const bool letterOrDigit = (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) || (key >= GLFW_KEY_A && key <= GLFW_KEY_Z);
    const bool bracket = key == GLFW_KEY_LEFT_BRACKET || key == GLFW_KEY_RIGHT_BRACKET;
    if (letterOrDigit || bracket) return static_cast<Key>(key); // GLFW's codes are ASCII's here
    return std::nullopt;
}

GlfwInput& inputOf(GLFWwindow* window) { return *static_cast<GlfwInput*>(glfwGetWindowUserPointer(window)); }

} // namespace

GlfwInput::GlfwInput(GLFWwindow* window) : window_(window)
{
    glfwSetWindowUserPointer(window, this);
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) { inputOf(w).onKey(key, action); });
    glfwSetMouseButtonCallback(window,
                               [](GLFWwindow* w, int button, int action, int) { inputOf(w).onButton(button, action); });
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) { inputOf(w).onPointer(x, y); });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double, double notches) { inputOf(w).onWheel(notches); });
    glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) { inputOf(w).onFocus(focused == GLFW_TRUE); });
}

GlfwInput::~GlfwInput()
{
    glfwSetKeyCallback(window_, nullptr);
    glfwSetMouseButtonCallback(window_, nullptr);
    glfwSetCursorPosCallback(window_, nullptr);
    glfwSetScrollCallback(window_, nullptr);
    glfwSetWindowFocusCallback(window_, nullptr);
    glfwSetWindowUserPointer(window_, nullptr);
}

void GlfwInput::onKey(int glfwKey, int action)
{
    const std::optional<Key> key = keyFromGlfw(glfwKey);
    const std::optional<KeyCommand> command = key ? commandOf(*key) : std::nullopt;
    if (!command) return;
    // A release counts wherever the typing goes, or a key would stick.
    if (action == GLFW_RELEASE) held_.release(*key);
    const bool pressed = action == GLFW_PRESS || (action == GLFW_REPEAT && repeats(command->action));
    if (!pressed || (widgets_ && widgets_->wantsKeys())) return;
    if (isHeld(command->action)) {
        held_.press(*key);
    } else {
        commands_.push_back(*command);
    }
}

void GlfwInput::onButton(int button, int action)
{
    if (button != GLFW_MOUSE_BUTTON_LEFT) return;
    if (action == GLFW_RELEASE) {
        stopLooking();
    } else if (!(widgets_ && widgets_->wantsMouse())) {
        // Hidden and held in place, the pointer never meets the edge of the screen.
        glfwSetInputMode(window_, GLFW_CURSOR, GLFW_CURSOR_DISABLED);
        double x = 0.0, y = 0.0;
        glfwGetCursorPos(window_, &x, &y);
        pointer_ = vec2(x, y);
        looking_ = true;
    }
}

void GlfwInput::stopLooking()
{
    if (!looking_) return;
    looking_ = false;
    glfwSetInputMode(window_, GLFW_CURSOR, GLFW_CURSOR_NORMAL);
}

void GlfwInput::onPointer(double x, double y)
{
    if (!looking_) return;
    const vec2 now(x, y);
    look_ += now - pointer_;
    pointer_ = now;
}

void GlfwInput::onWheel(double notches)
{
    if (!(widgets_ && widgets_->wantsMouse())) wheel_ += notches;
}

void GlfwInput::onFocus(bool focused)
{
    if (focused) return;
    held_.releaseAll();
    stopLooking();
}

std::vector<KeyCommand> GlfwInput::takeCommands() { return std::exchange(commands_, {}); }

vec2 GlfwInput::takeLook() { return std::exchange(look_, vec2(0.0f)); }

double GlfwInput::takeWheel() { return std::exchange(wheel_, 0.0); }

} // namespace tarn
