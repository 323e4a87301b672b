#include "app/viewer/display_guard.h"

#include <dlfcn.h>
#include <string_view>
#include <unistd.h>

namespace tarn {

namespace {

int displayLost(void*)
{
    constexpr std::string_view message = "tarn: error: the display was lost; open the viewer again when it is back\n";
    // The display's buffers and everything drawn on it are gone: destructors would only talk to it again.
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, message.data(), message.size());
    _exit(1);
}

} // namespace

void guardDisplay()
{
    // GLFW loads Xlib; asking the loader for it spares Tarn a dependence on X where there is only Wayland.
    using Handler = int (*)(void*);
    using SetHandler = Handler (*)(Handler);
    if (const auto set = reinterpret_cast<SetHandler>(dlsym(RTLD_DEFAULT, "XSetIOErrorHandler"))) set(displayLost);
}

} // namespace tarn
