// A window with an OpenGL 3.3 core context, made by GLFW (library tarn_gl_glfw).
#pragma once

#include "gl/context.h"

#include <string>

struct GLFWwindow;

namespace tarn::gl {

/// True when a window can be opened: an X or Wayland display answers.
bool displayAvailable();

struct WindowDesc {
    std::string title = "Tarn";
    ivec2 size{1280, 720}; ///< in screen coordinates, which are not pixels on a HiDPI screen
    bool visible = true;
    bool debug = false;
    bool vsync = true;
};

class Window : public Context {
public:
    /// Opens it and makes its context current. Throws Error when there is no display or no OpenGL 3.3.
    explicit Window(const WindowDesc& desc);
    ~Window() override;

    void makeCurrent() override;
    void release() override;
    /// A window that is never shown.
    std::unique_ptr<Context> makeShared() override;
    /// In pixels; {0, 0} while minimised.
    ivec2 framebufferSize() const override;

    /// Shows what was drawn into Framebuffer::window().
    void swap();
    void setVsync(bool on);
    void setTitle(const std::string& title);
    bool shouldClose() const;

    /// For input callbacks and the panel.
    GLFWwindow* handle() const { return window_; }

private:
    explicit Window(GLFWwindow* other);

    GLFWwindow* window_ = nullptr;
    bool isShared_ = false;
};

} // namespace tarn::gl
