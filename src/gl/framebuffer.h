// Where drawing goes. A framebuffer checks itself when it is built and throws with its label, attachments,
// sizes and formats: no black screens without a message.
#pragma once

#include "gl/buffer.h"
#include "gl/texture.h"

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tarn::gl {

/// Pixels that are drawn into and never read by a shader: the multisampled half of a Target.
class Renderbuffer {
public:
    Renderbuffer() = default;
    Renderbuffer(Format format, ivec2 size, int samples, std::string label);

    Format format() const { return format_; }
    ivec2 size() const { return size_; }
    int samples() const { return samples_; }
    const std::string& label() const { return object_.label(); }
    Name name() const { return object_.name(); }

private:
    Object object_;
    Format format_ = Format::rgba8;
    ivec2 size_{0};
    int samples_ = 1;
};

/// One image of a framebuffer; converts from a texture or a renderbuffer. Its format says colour or depth.
struct Attachment {
    /// @param imageFace of a cube, or the layer of an array
    Attachment(const Texture& t, int mipLevel = 0, int imageFace = 0) : texture(&t), level(mipLevel), face(imageFace) {}
    Attachment(const Renderbuffer& r) : renderbuffer(&r) {}

    Format format() const { return texture ? texture->format() : renderbuffer->format(); }
    ivec2 size() const { return texture ? texture->levelSize(level) : renderbuffer->size(); }
    int samples() const { return texture ? texture->desc().samples : renderbuffer->samples(); }

    const Texture* texture = nullptr;
    const Renderbuffer* renderbuffer = nullptr;
    int level = 0;
    int face = 0;
};

class Framebuffer {
public:
    Framebuffer() = default;
    ~Framebuffer();
    Framebuffer(Framebuffer&&) noexcept = default;
    Framebuffer& operator=(Framebuffer&& other) noexcept;
    /// Colours become outputs 0, 1, 2 … in their order; at most one depth. The attachments must outlive it.
    /// Throws Error when OpenGL cannot draw into the combination.
    Framebuffer(std::string label, std::span<const Attachment> attachments);
    Framebuffer(std::string label, std::initializer_list<Attachment> attachments)
        : Framebuffer(std::move(label), std::span(attachments.begin(), attachments.size()))
    {}
    /// The context's own: a window's, or OSMesa's. EGL without a surface has none.
    static Framebuffer window(ivec2 size);

    /// Draw here from now on, the whole of it.
    void bind() const;

    /// Clears whatever the masks of the current State are. The framebuffer need not be bound.
    void clearColour(const vec4& value, int output = 0) const;
    void clearDepth(float value = 1.0f) const;

    struct Copy {
        bool colour = true; ///< output 0, or the one chosen
        bool depth = false; ///< needs equal formats
        Filter filter = Filter::nearest;
        int output = 0;                ///< of both
        std::optional<ivec2> corner{}; ///< lower left one in the destination, for a copy that is not stretched
    };
    /// Copies the whole picture, resolving samples (sizes must then be equal), stretching it, or to a place. Throws
    /// Error when it does not fit there.
    void blitTo(const Framebuffer& destination, const Copy& copy) const;

    /// Four values per pixel, rows from bottom to top. Waits for the GPU. Throws Error on a multisampled one.
    std::vector<float> readFloats(int output = 0) const;
    std::vector<std::uint8_t> readBytes(int output = 0) const;
    /// The floats into a buffer on the GPU, which is made as large as they need; nothing waits.
    void copyFloatsTo(Buffer& buffer, int output = 0) const;
    /// One value per pixel, 0 near to 1 far.
    std::vector<float> readDepth() const;

    ivec2 size() const { return size_; }
    int samples() const { return samples_; }
    int colourCount() const { return colourCount_; }
    bool hasDepth() const { return hasDepth_; }
    const std::string& label() const { return object_ ? object_.label() : windowLabel_; }

private:
    void beginRead(int output) const;
    void forget() const;

    Object object_;
    std::string windowLabel_ = "window";
    ivec2 size_{0};
    int samples_ = 1;
    int colourCount_ = 0;
    bool hasDepth_ = false;
};

} // namespace tarn::gl
