// What a person did in the window since the last frame.
#pragma once

#include "app/viewer/input_map.h"
#include "base/math.h"

#include <vector>

struct GLFWwindow;

namespace tarn {

class ImGuiLayer;

/// Installs itself as the window's input callbacks; must outlive the window's event handling. Keys typed into
/// a widget and clicks on one do not count once the widgets are known.
class GlfwInput {
public:
    explicit GlfwInput(GLFWwindow* window);
    ~GlfwInput();
    GlfwInput(const GlfwInput&) = delete;
    GlfwInput& operator=(const GlfwInput&) = delete;

    void setWidgets(const ImGuiLayer* widgets) { widgets_ = widgets; }

    /// Each is told once.
    std::vector<KeyCommand> takeCommands();
    vec2 takeLook();    ///< screen coordinates, right and down, while the button is held
    double takeWheel(); ///< notches
    const HeldKeys& held() const { return held_; }

private:
    void onKey(int key, int action);
    void onButton(int button, int action);
    void onPointer(double x, double y);
    void onWheel(double notches);
    void onFocus(bool focused);
    void stopLooking();

    GLFWwindow* window_;
    const ImGuiLayer* widgets_ = nullptr;
    HeldKeys held_;
    std::vector<KeyCommand> commands_;
    bool looking_ = false;
    vec2 pointer_{0.0f};
    vec2 look_{0.0f};
    double wheel_ = 0.0;
};

} // namespace tarn
