// OSMesa: pictures made by Mesa's software rasteriser into memory, without window, display or GPU. Newer Mesa
// releases have dropped it, so this is the only file that knows it.
#include "gl/context.h"

#include "base/error.h"

#include <GL/osmesa.h>

#include <utility>
#include <vector>

// GLEW asks GLX for the addresses of functions, and under OSMesa GLX answers with stubs that do nothing. The
// program's own definition takes the place of libGL's.
extern "C" void (*glXGetProcAddressARB(const GLubyte* name))();
extern "C" void (*glXGetProcAddressARB(const GLubyte* name))()
{
    return OSMesaGetProcAddress(reinterpret_cast<const char*>(name));
}

namespace tarn::gl {

namespace {

class OsmesaContext : public Context {
public:
    OsmesaContext(ivec2 size, bool debug) : Context("OSMesa"), size_(size)
    {
        create(nullptr);
        try {
            makeCurrent();
            initialise(debug);
        } catch (...) {
            OSMesaDestroyContext(context_);
            throw;
        }
    }

    /// A context that shares the other's objects.
    explicit OsmesaContext(OSMesaContext other) : Context("OSMesa"), size_(1) { create(other); }

    ~OsmesaContext() override { OSMesaDestroyContext(context_); }

    void makeCurrent() final
    {
        if (!OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, size_.x, size_.y)) {
            throw Error("OSMesa cannot draw into {}x{} pixels", size_.x, size_.y);
        }
        if (isShared_) listenOnce();
    }

    void release() override { OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0); }

    std::unique_ptr<Context> makeShared() override { return std::make_unique<OsmesaContext>(context_); }

    ivec2 framebufferSize() const override { return size_; }
    std::string device() const override { return headlessDevices().front(); }

private:
    void create(OSMesaContext other)
    {
        isShared_ = other != nullptr;
        if (size_.x < 1 || size_.y < 1) throw Error("an OSMesa context needs a size, not {}x{}", size_.x, size_.y);
        const int attributes[] = {OSMESA_FORMAT,
                                  OSMESA_RGBA,
                                  OSMESA_DEPTH_BITS,
                                  24,
                                  OSMESA_PROFILE,
                                  OSMESA_CORE_PROFILE,
                                  OSMESA_CONTEXT_MAJOR_VERSION,
                                  3,
                                  OSMESA_CONTEXT_MINOR_VERSION,
                                  3,
                                  0};
        context_ = OSMesaCreateContextAttribs(attributes, other);
        if (!context_) throw Error("OSMesa gives no OpenGL 3.3 core context; is libosmesa6 up to date?");
        pixels_.resize(4 * static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y));
    }

    OSMesaContext context_ = nullptr;
    ivec2 size_;
    bool isShared_ = false;
    std::vector<unsigned char> pixels_;
};

} // namespace

std::vector<std::string> headlessDevices() { return {"software"}; }

std::unique_ptr<Context> makeHeadlessContext(ivec2 size, bool debug)
{
    return std::make_unique<OsmesaContext>(size, debug);
}

} // namespace tarn::gl
