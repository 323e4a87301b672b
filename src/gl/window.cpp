#include "gl/window.h"

#include "base/error.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace tarn::gl {

namespace {

std::string lastGlfwError()
{
    const char* text = nullptr;
    return glfwGetError(&text) == GLFW_NO_ERROR || !text ? "GLFW gives no reason" : text;
}

/// GLFW starts with its first user and ends with its last.
int users = 0;

bool acquireGlfw()
{
    if (users == 0 && glfwInit() != GLFW_TRUE) return false;
    ++users;
    return true;
}

void releaseGlfw()
{
    if (--users == 0) glfwTerminate();
}

GLFWwindow* open(const WindowDesc& desc, GLFWwindow* shared = nullptr)
{
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE); // macOS gives a core profile to nobody else
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, desc.debug ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_VISIBLE, desc.visible ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    return glfwCreateWindow(desc.size.x, desc.size.y, desc.title.c_str(), nullptr, shared);
}

} // namespace

bool displayAvailable()
{
    if (!acquireGlfw()) return false;
    releaseGlfw();
    return true;
}

Window::Window(const WindowDesc& desc) : Context("The window")
{
    if (!acquireGlfw()) {
        throw Error("no window can be opened: {}; set DISPLAY, or use `tarn render`", lastGlfwError());
    }
    try {
        window_ = open(desc);
        if (!window_) throw Error("no window with OpenGL 3.3 can be opened: {}", lastGlfwError());
        makeCurrent();
        initialise(desc.debug);
        setVsync(desc.vsync);
    } catch (...) {
        if (window_) glfwDestroyWindow(window_);
        releaseGlfw();
        throw;
    }
}

Window::Window(GLFWwindow* other) : Context("The window"), isShared_(true)
{
    if (!acquireGlfw()) throw Error("no second context can be made: {}", lastGlfwError());
    window_ = open({.size = {16, 16}, .visible = false}, other);
    if (window_) return;
    const std::string reason = lastGlfwError();
    releaseGlfw();
    throw Error("no second context can be made: {}", reason);
}

Window::~Window()
{
    glfwDestroyWindow(window_);
    releaseGlfw();
}

void Window::makeCurrent()
{
    glfwMakeContextCurrent(window_);
    if (isShared_) listenOnce();
}

void Window::release() { glfwMakeContextCurrent(nullptr); }

std::unique_ptr<Context> Window::makeShared() { return std::unique_ptr<Context>(new Window(window_)); }

ivec2 Window::framebufferSize() const
{
    ivec2 size(0);
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
}

void Window::swap() { glfwSwapBuffers(window_); }

void Window::setVsync(bool on) { glfwSwapInterval(on ? 1 : 0); }

void Window::setTitle(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

bool Window::shouldClose() const { return glfwWindowShouldClose(window_) == GLFW_TRUE; }

} // namespace tarn::gl
