#include "gl/framebuffer.h"

#include "base/error.h"
#include "gl/context.h"
#include "gl/counters.h"
#include "gl/format_gl.h"
#include "gl/state.h"

#include <utility>

namespace tarn::gl {

namespace {

std::string describe(const Attachment& a)
{
    const ivec2 size = a.size();
    const std::string samples = a.samples() > 1 ? fmt::format(" {} samples", a.samples()) : "";
    const std::string& label = a.texture ? a.texture->label() : a.renderbuffer->label();
    return fmt::format("\"{}\" {} {}x{}{}", label, formatName(a.format()), size.x, size.y, samples);
}

[[noreturn]] void fail(const std::string& label, std::span<const Attachment> attachments, const std::string& reason)
{
    std::string list;
    for (const Attachment& a : attachments) list += fmt::format("{}{}", list.empty() ? "" : ", ", describe(a));
    throw Error("framebuffer \"{}\" cannot be drawn into: {} (attachments: {})", label, reason,
                list.empty() ? "none" : list);
}

const char* statusText(GLenum status)
{
    switch (status) {
    case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT: return "an attachment is incomplete";
    case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT: return "it has no attachment";
    case GL_FRAMEBUFFER_INCOMPLETE_DRAW_BUFFER: return "a draw buffer has no attachment";
    case GL_FRAMEBUFFER_INCOMPLETE_READ_BUFFER: return "the read buffer has no attachment";
    case GL_FRAMEBUFFER_UNSUPPORTED: return "the driver does not support these formats together";
    case GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE: return "the attachments differ in samples";
    default: return "unknown reason";
    }
}

void attach(const Attachment& a, GLenum point)
{
    if (a.renderbuffer) {
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, a.renderbuffer->name());
        return;
    }
    GLenum target = GL_TEXTURE_2D;
    if (a.texture->desc().kind == TextureKind::array) {
        glFramebufferTextureLayer(GL_FRAMEBUFFER, point, a.texture->name(), a.level, a.face);
        return;
    }
    if (a.samples() > 1)
        target = GL_TEXTURE_2D_MULTISAMPLE;
    else if (a.texture->desc().kind == TextureKind::cube) {
        target = GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(a.face);
    }
    glFramebufferTexture2D(GL_FRAMEBUFFER, point, target, a.texture->name(), a.level);
}

GLenum colourPoint(int output) { return GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(output); }

void drawIntoAll(int colourCount)
{
    std::vector<GLenum> points;
    for (int i = 0; i < colourCount; ++i) points.push_back(colourPoint(i));
    if (points.empty()) points.push_back(GL_NONE);
    glDrawBuffers(static_cast<GLsizei>(points.size()), points.data());
}

/// What is bound in the context of this thread. Remembered, since asking OpenGL makes a threaded driver wait; all
/// bindings of framebuffers are made in this file.
struct Bound {
    Name draw = 0;
    Name read = 0;
};
thread_local Bound bound;

void bindBoth(Name name)
{
    count(Call::framebufferBind);
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    bound = {name, name};
}

/// Binds for a moment and puts back what was bound before.
class ScopedBinding {
public:
    ScopedBinding(GLenum target, Name name)
        : target_(target), name_(target == GL_READ_FRAMEBUFFER ? bound.read : bound.draw), previous_(name_)
    {
        bind(name);
    }
    ~ScopedBinding() { bind(previous_); }
    ScopedBinding(const ScopedBinding&) = delete;
    ScopedBinding& operator=(const ScopedBinding&) = delete;

private:
    void bind(Name name)
    {
        if (name != name_) {
            count(Call::framebufferBind);
            glBindFramebuffer(target_, name);
        }
        name_ = name;
        (target_ == GL_READ_FRAMEBUFFER ? bound.read : bound.draw) = name;
    }

    GLenum target_;
    Name name_; ///< that is bound now
    Name previous_;
};

std::size_t pixelCount(ivec2 size) { return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y); }

} // namespace

Renderbuffer::Renderbuffer(Format format, ivec2 size, int samples, std::string label)
    : object_(Object::Kind::renderbuffer, std::move(label)), format_(format), size_(size), samples_(samples)
{
    const int limit = capabilities().maxTextureSize;
    if (size.x < 1 || size.y < 1 || size.x > limit || size.y > limit) {
        throw Error("renderbuffer \"{}\": size {}x{} is not within 1x1 and {}x{}", this->label(), size.x, size.y, limit,
                    limit);
    }
    if (samples < 1 || samples > capabilities().maxSamples) {
        throw Error("renderbuffer \"{}\": {} samples, but this driver takes 1 to {}", this->label(), samples,
                    capabilities().maxSamples);
    }
    glBindRenderbuffer(GL_RENDERBUFFER, object_.name());
    object_.announceLabel();
    // 0 samples is OpenGL's word for "not multisampled"; 1 may be rounded up to 2.
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples > 1 ? samples : 0, internalFormat(format), size.x,
                                     size.y);
}

Framebuffer::Framebuffer(std::string label, std::span<const Attachment> attachments)
{
    if (attachments.empty()) fail(label, attachments, "it has no attachment");
    size_ = attachments.front().size();
    samples_ = attachments.front().samples();
    object_ = Object(Object::Kind::framebuffer, std::move(label));
    bindBoth(object_.name());
    object_.announceLabel();
    for (const Attachment& a : attachments) {
        if (a.size() != size_) fail(this->label(), attachments, "the attachments differ in size");
        if (a.samples() != samples_) fail(this->label(), attachments, "the attachments differ in samples");
        if (isDepth(a.format()) && hasDepth_) fail(this->label(), attachments, "it has two depth attachments");
        if (isDepth(a.format())) {
            hasDepth_ = true;
            attach(a, GL_DEPTH_ATTACHMENT);
        } else {
            attach(a, colourPoint(colourCount_++));
        }
    }
    drawIntoAll(colourCount_);
    glReadBuffer(colourCount_ > 0 ? GL_COLOR_ATTACHMENT0 : GL_NONE);
    count(Call::stateQuery);
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) fail(this->label(), attachments, statusText(status));
}

Framebuffer Framebuffer::window(ivec2 size)
{
    Framebuffer result;
    result.size_ = size;
    result.colourCount_ = 1;
    result.hasDepth_ = true;
    return result;
}

Framebuffer::~Framebuffer() { forget(); }

Framebuffer& Framebuffer::operator=(Framebuffer&& other) noexcept
{
    forget();
    object_ = std::move(other.object_);
    windowLabel_ = std::move(other.windowLabel_);
    size_ = other.size_;
    samples_ = other.samples_;
    colourCount_ = other.colourCount_;
    hasDepth_ = other.hasDepth_;
    return *this;
}

/// OpenGL binds the window's where the one that is deleted was bound.
void Framebuffer::forget() const
{
    if (!object_) return;
    if (bound.draw == object_.name()) bound.draw = 0;
    if (bound.read == object_.name()) bound.read = 0;
}

void Framebuffer::bind() const
{
    bindBoth(object_.name());
    glViewport(0, 0, size_.x, size_.y);
}

void Framebuffer::clearColour(const vec4& value, int output) const
{
    const ScopedBinding binding(GL_DRAW_FRAMEBUFFER, object_.name());
    const bool isMasked = !writeMasks().colour;
    if (isMasked) glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    count(Call::clear);
    glClearBufferfv(GL_COLOR, output, &value.x);
    if (isMasked) glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
}

void Framebuffer::clearDepth(float value) const
{
    const ScopedBinding binding(GL_DRAW_FRAMEBUFFER, object_.name());
    const bool isMasked = !writeMasks().depth;
    if (isMasked) glDepthMask(GL_TRUE);
    count(Call::clear);
    glClearBufferfv(GL_DEPTH, 0, &value);
    if (isMasked) glDepthMask(GL_FALSE);
}

void Framebuffer::blitTo(const Framebuffer& destination, const Copy& copy) const
{
    if (samples_ > 1 && size_ != destination.size_) {
        throw Error("samples of framebuffer \"{}\" ({}x{}) cannot be resolved into \"{}\" ({}x{}): the sizes differ",
                    label(), size_.x, size_.y, destination.label(), destination.size_.x, destination.size_.y);
    }
    const ivec2 from = copy.corner.value_or(ivec2(0));
    const ivec2 to = copy.corner ? from + size_ : destination.size_;
    if (from.x < 0 || from.y < 0 || to.x > destination.size_.x || to.y > destination.size_.y) {
        throw Error("framebuffer \"{}\" ({}x{}) does not fit into \"{}\" ({}x{}) at {},{}", label(), size_.x, size_.y,
                    destination.label(), destination.size_.x, destination.size_.y, from.x, from.y);
    }
    const ScopedBinding read(GL_READ_FRAMEBUFFER, object_.name());
    const ScopedBinding draw(GL_DRAW_FRAMEBUFFER, destination.object_.name());
    // A blit writes every draw buffer, so only the chosen one may be enabled. The window's are its own
    // affair.
    const bool chooseOutput = copy.colour && destination.object_ && destination.colourCount_ > 1;
    if (copy.colour && object_) glReadBuffer(colourPoint(copy.output));
    if (chooseOutput) {
        std::vector<GLenum> points(static_cast<std::size_t>(copy.output) + 1, GL_NONE);
        points.back() = colourPoint(copy.output);
        glDrawBuffers(static_cast<GLsizei>(points.size()), points.data());
    }
    const GLbitfield mask =
        (copy.colour ? GL_COLOR_BUFFER_BIT : GLbitfield{0}) | (copy.depth ? GL_DEPTH_BUFFER_BIT : GLbitfield{0});
    // OpenGL allows depth to be copied texel by texel only.
    const bool smooth = copy.filter == Filter::linear && !copy.depth && samples_ == 1;
    count(Call::blit);
    glBlitFramebuffer(0, 0, size_.x, size_.y, from.x, from.y, to.x, to.y, mask, smooth ? GL_LINEAR : GL_NEAREST);
    if (chooseOutput) drawIntoAll(destination.colourCount_);
    if (copy.colour && object_) glReadBuffer(GL_COLOR_ATTACHMENT0);
}

void Framebuffer::beginRead(int output) const
{
    if (samples_ > 1) throw Error("framebuffer \"{}\" is multisampled; resolve it before reading", label());
    if (output >= colourCount_) throw Error("framebuffer \"{}\" has no colour output {}", label(), output);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    if (object_) glReadBuffer(colourPoint(output));
}

std::vector<float> Framebuffer::readFloats(int output) const
{
    const ScopedBinding binding(GL_READ_FRAMEBUFFER, object_.name());
    beginRead(output);
    std::vector<float> values(4 * pixelCount(size_));
    count(Call::readBack);
    glReadPixels(0, 0, size_.x, size_.y, GL_RGBA, GL_FLOAT, values.data());
    return values;
}

void Framebuffer::copyFloatsTo(Buffer& buffer, int output) const
{
    const std::size_t bytes = 4 * pixelCount(size_) * sizeof(float);
    if (buffer.size() != bytes) buffer.upload(nullptr, bytes);
    const ScopedBinding binding(GL_READ_FRAMEBUFFER, object_.name());
    beginRead(output);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer.name());
    count(Call::readBack);
    glReadPixels(0, 0, size_.x, size_.y, GL_RGBA, GL_FLOAT, nullptr);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

std::vector<std::uint8_t> Framebuffer::readBytes(int output) const
{
    const ScopedBinding binding(GL_READ_FRAMEBUFFER, object_.name());
    beginRead(output);
    std::vector<std::uint8_t> values(4 * pixelCount(size_));
    count(Call::readBack);
    glReadPixels(0, 0, size_.x, size_.y, GL_RGBA, GL_UNSIGNED_BYTE, values.data());
    return values;
}

std::vector<float> Framebuffer::readDepth() const
{
    if (!hasDepth_ || samples_ > 1) throw Error("framebuffer \"{}\" has no depth that can be read", label());
    const ScopedBinding binding(GL_READ_FRAMEBUFFER, object_.name());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    std::vector<float> values(pixelCount(size_));
    count(Call::readBack);
    glReadPixels(0, 0, size_.x, size_.y, GL_DEPTH_COMPONENT, GL_FLOAT, values.data());
    return values;
}

} // namespace tarn::gl
