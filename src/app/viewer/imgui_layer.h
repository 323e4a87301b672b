// Dear ImGui in Tarn's window: set up, scaled to the screen, drawn on top of the frame.
#pragma once

struct GLFWwindow;

namespace tarn {

class ImGuiLayer {
public:
    /// Chains to the input callbacks that the window already has: set those first.
    explicit ImGuiLayer(GLFWwindow* window);
    ~ImGuiLayer();
    ImGuiLayer(const ImGuiLayer&) = delete;
    ImGuiLayer& operator=(const ImGuiLayer&) = delete;

    /// Follows the screen's content scale. Widgets may be declared until draw().
    void beginFrame();
    /// Into the window's framebuffer, which must be bound.
    void draw();

    /// A widget is being typed into, or lies under the pointer.
    bool wantsKeys() const;
    bool wantsMouse() const;

    float scale() const { return scale_; }

private:
    void applyScale(float scale);

    GLFWwindow* window_;
    float scale_ = 0.0f;
};

} // namespace tarn
