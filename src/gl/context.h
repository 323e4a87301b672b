// A current OpenGL 3.3 core context, wherever it came from, and what the driver behind it says and can do.
//
// Three ways lead to one: a window (gl/window.h, library tarn_gl_glfw), EGL without a surface (tarn_gl_egl)
// and OSMesa (tarn_gl_osmesa). The last two both define makeHeadlessContext, so a program links exactly one
// of them.
#pragma once

#include "base/math.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace tarn::gl {

class Context {
public:
    virtual ~Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    virtual void makeCurrent() = 0;
    /// Leaves this thread without a context.
    virtual void release() = 0;
    /// Another context for one other thread, with the same textures, buffers and programs; vertex arrays, framebuffers
    /// and queries are each context's own. Call it in the thread that this one was made in; in the other, begin with
    /// makeCurrent and end with release. Must go before this one does.
    virtual std::unique_ptr<Context> makeShared() = 0;
    /// In pixels; {0, 0} while a window is minimised. A headless context answers the size it was made with.
    virtual ivec2 framebufferSize() const = 0;

    /// GL_RENDERER: "llvmpipe (LLVM 15.0.6, 256 bits)".
    std::string renderer() const;
    /// GL_VERSION.
    std::string version() const;
    /// Of those that headlessDevices() names; "" for a window's.
    virtual std::string device() const { return ""; }
    /// True when the pictures are made by the CPU (llvmpipe, softpipe, SwiftShader).
    bool isSoftware() const;

protected:
    /// @param origin "EGL", "OSMesa" or "window", for messages.
    explicit Context(std::string origin) : origin_(std::move(origin)) {}
    /// Loads the functions and starts listening to the driver; call once, with the context current. Throws
    /// Error when it is not OpenGL 3.3 core or newer.
    /// @param debug every message at the call that caused it (slower), performance hints in the debug log
    void initialise(bool debug);
    /// The same for a shared context, each time it becomes current: the functions are loaded.
    void listenOnce();

private:
    std::string origin_;
    bool listening_ = false;
};

/// A context without a window. Throws Error that says what was tried when there is none.
/// @param size of the framebuffer, which exists with OSMesa only: draw into targets and read those.
/// On the device that was chosen, or the first that works; a graphics card that does not is a warning.
std::unique_ptr<Context> makeHeadlessContext(ivec2 size, bool debug = false);

/// What headless contexts can be made on, in the order in which they are tried: "GPU 0 (/dev/dri/renderD128)",
/// "Mesa surfaceless", "software". OSMesa knows nothing but "software".
std::vector<std::string> headlessDevices();
/// For every headless context from now on: a name, or a part of one in any case; "" takes the first that works. Throws
/// Error when there is none of that name.
void chooseHeadlessDevice(std::string name);
/// Whether it chooses this one.
bool isChosenDevice(const std::string& name);

/// What the current context offers beyond OpenGL 3.3. The 3.3 way must stand beside every use.
struct Capabilities {
    bool debug = false;         ///< KHR_debug: labels, groups, messages
    float maxAnisotropy = 1.0f; ///< 1 where EXT_texture_filter_anisotropic is missing
    int maxSamples = 1;
    int maxTextureSize = 1024;
    int maxArrayLayers = 256;
    bool llvmpipe = false; ///< Mesa's software rasteriser: see gl/workarounds.h
};
const Capabilities& capabilities();

/// Messages of type error that the driver has sent since the program started. Any of them fails a test.
int debugErrorCount();
/// The latest of them, or "".
std::string lastDebugError();

/// Throws Error with the name of every error that glGetError holds.
void checkErrors(const char* where);

} // namespace tarn::gl
