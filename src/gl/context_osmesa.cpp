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

namespace tarn::gl
{

namespace
{

class OsmesaContext : public Context
{
public:
    OsmesaContext(ivec2 size, bool debug) : Context("OSMesa"), size_(size)
    {
        if (size.x < 1 || size.y < 1)
            throw Error("an OSMesa context needs a size, not {}x{}", size.x, size.y);
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
        context_ = OSMesaCreateContextAttribs(attributes, nullptr);
        if (!context_) throw Error("OSMesa gives no OpenGL 3.3 core context; is libosmesa6 up to date?");
        pixels_.resize(4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
        try {
            makeCurrent();
            initialise(debug);
        } catch (...) {
            OSMesaDestroyContext(context_);
            throw;
        }
    }

    ~OsmesaContext() override { OSMesaDestroyContext(context_); }

    void makeCurrent() final
    {
        if (!OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, size_.x, size_.y)) {
            throw Error("OSMesa cannot draw into {}x{} pixels", size_.x, size_.y);
        }
    }

    ivec2 framebufferSize() const override { return size_; }

private:
    OSMesaContext context_ = nullptr;
    ivec2 size_;
    std::vector<unsigned char> pixels_;
};

} // namespace

std::unique_ptr<Context> makeHeadlessContext(ivec2 size, bool debug)
{
    return std::make_unique<OsmesaContext>(size, debug);
}

} // namespace tarn::gl
