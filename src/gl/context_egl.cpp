// EGL without a surface: headless on a GPU, or on Mesa's software rasteriser where there is none.
#include "gl/context.h"

#include "base/error.h"
#include "base/log.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace tarn::gl {

namespace {

bool hasExtension(const char* list, std::string_view name)
{
    // Names are whole words: EGL_EXT_device_base must not be found in EGL_EXT_device_base2.
    return fmt::format(" {} ", list ? list : "").find(fmt::format(" {} ", name)) != std::string::npos;
}

template <typename Function> Function load(const char* name)
{
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

/// A display that may work, and what to call it when it does not.
struct Candidate {
    std::string name;
    EGLenum platform;
    void* native;
    bool isGpu = false;
};

bool isSoftwareDevice(EGLDeviceEXT device)
{
    const auto queryString = load<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    return queryString && hasExtension(queryString(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
}

/// "GPU 0 (/dev/dri/renderD128)", as far as EGL tells; CUDA's devices have no file.
std::string gpuName(EGLDeviceEXT device, std::ptrdiff_t number)
{
    const auto queryString = load<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    const char* extensions = queryString ? queryString(device, EGL_EXTENSIONS) : nullptr;
    const char* file = nullptr;
    if (hasExtension(extensions, "EGL_EXT_device_drm_render_node"))
        file = queryString(device, EGL_DRM_RENDER_NODE_FILE_EXT);
    if (!file && hasExtension(extensions, "EGL_EXT_device_drm")) file = queryString(device, EGL_DRM_DEVICE_FILE_EXT);
    return file ? fmt::format("GPU {} ({})", number, file) : fmt::format("GPU {}", number);
}

std::vector<EGLDeviceEXT> devices(const char* clientExtensions)
{
    const bool canList = hasExtension(clientExtensions, "EGL_EXT_platform_device") &&
                         (hasExtension(clientExtensions, "EGL_EXT_device_enumeration") ||
                          hasExtension(clientExtensions, "EGL_EXT_device_base"));
    const auto queryDevices = load<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    EGLint count = 0;
    if (!canList || !queryDevices || !queryDevices(0, nullptr, &count) || count == 0) return {};
    std::vector<EGLDeviceEXT> list(static_cast<std::size_t>(count));
    if (!queryDevices(count, list.data(), &count)) return {};
    list.resize(static_cast<std::size_t>(count));
    return list;
}

/// GPUs first, then whatever Mesa thinks best, then its software rasteriser.
std::vector<Candidate> candidates()
{
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    std::vector<EGLDeviceEXT> all = devices(extensions);
    const auto firstSoftware =
        std::stable_partition(all.begin(), all.end(), [](EGLDeviceEXT d) { return !isSoftwareDevice(d); });
    std::vector<Candidate> list;
    for (auto gpu = all.begin(); gpu != firstSoftware; ++gpu) {
        list.push_back({gpuName(*gpu, gpu - all.begin()), EGL_PLATFORM_DEVICE_EXT, *gpu, true});
    }
    if (hasExtension(extensions, "EGL_MESA_platform_surfaceless")) {
        list.push_back({"Mesa surfaceless", EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY});
    }
    for (auto device = firstSoftware; device != all.end(); ++device) {
        list.push_back({"software", EGL_PLATFORM_DEVICE_EXT, *device});
    }
    return list;
}

class EglContext : public Context {
public:
    EglContext(const Candidate& candidate, ivec2 size, bool debug)
        : Context("EGL"), device_(candidate.name), size_(size)
    {
        open(candidate);
        try {
            createContext(debug);
            makeCurrent();
            initialise(debug);
        } catch (...) {
            close();
            throw;
        }
    }

    /// A context that shares the other's objects, on its display.
    explicit EglContext(const EglContext& other)
        : Context("EGL"), device_(other.device_), display_(other.display_), isShared_(true), size_(1)
    {
        createContext(false, other.context_);
    }

    ~EglContext() override { close(); }

    void makeCurrent() final
    {
        if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
            throw Error("EGL cannot use a context without a surface (error {:#x})", eglGetError());
        }
        if (isShared_) listenOnce();
    }

    void release() override
    {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglReleaseThread();
    }

    std::unique_ptr<Context> makeShared() override { return std::make_unique<EglContext>(*this); }

    ivec2 framebufferSize() const override { return size_; }
    std::string device() const override { return device_; }

private:
    void open(const Candidate& candidate)
    {
        const auto getDisplay = load<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
        if (!getDisplay) throw Error("EGL cannot choose a platform");
        display_ = getDisplay(candidate.platform, candidate.native, nullptr);
        if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr)) {
            throw Error("no display (error {:#x})", eglGetError());
        }
    }

    void createContext(bool debug, EGLContext shared = EGL_NO_CONTEXT)
    {
        if (!eglBindAPI(EGL_OPENGL_API)) throw Error("EGL offers no desktop OpenGL");
        const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (!eglChooseConfig(display_, wanted, &config, 1, &count) || count == 0) {
            config = EGL_NO_CONFIG_KHR; // nothing is drawn to a surface, so none is needed
        }
        const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION_KHR,
                                     3,
                                     EGL_CONTEXT_MINOR_VERSION_KHR,
                                     3,
                                     EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                                     EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR,
                                     EGL_CONTEXT_FLAGS_KHR,
                                     debug ? EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR : 0,
                                     EGL_NONE};
        context_ = eglCreateContext(display_, config, shared, attributes);
        if (context_ == EGL_NO_CONTEXT) throw Error("no OpenGL 3.3 core context (error {:#x})", eglGetError());
    }

    void close()
    {
        if (isShared_) { // the display and what is current here belong to the other
            eglDestroyContext(display_, context_);
            return;
        }
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
        eglTerminate(display_);
        eglReleaseThread();
    }

    std::string device_;
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
    bool isShared_ = false;
    ivec2 size_;
};

} // namespace

std::vector<std::string> headlessDevices()
{
    std::vector<std::string> names;
    for (const Candidate& candidate : candidates()) names.push_back(candidate.name);
    return names;
}

std::unique_ptr<Context> makeHeadlessContext(ivec2 size, bool debug)
{
    std::string tried, brokenGpus;
    const auto note = [](std::string& list, const Candidate& candidate, const Error& error) {
        list += fmt::format("{}{}: {}", list.empty() ? "" : "; ", candidate.name, error.what());
    };
    for (const Candidate& candidate : candidates()) {
        if (!isChosenDevice(candidate.name)) continue;
        try {
            auto context = std::make_unique<EglContext>(candidate, size, debug);
            log::debug("EGL: {} gives OpenGL {} on {}", candidate.name, context->version(), context->renderer());
            if (!brokenGpus.empty())
                log::warning("a graphics card could not be used ({}): drawing on {}", brokenGpus, context->renderer());
            return context;
        } catch (const Error& error) {
            note(tried, candidate, error);
            if (candidate.isGpu) note(brokenGpus, candidate, error);
        }
    }
    throw Error("EGL gives no OpenGL 3.3 context without a window ({}); install Mesa's EGL (libegl1) or a graphics "
                "driver, or use tarn-osmesa",
                tried.empty() ? "it knows no headless platform" : tried);
}

} // namespace tarn::gl
