// Memory of the graphics card: vertices, indices, uniform blocks.
#pragma once

#include "gl/object.h"

#include <cstddef>
#include <span>
#include <string>
#include <type_traits>

namespace tarn::gl {

class Buffer {
public:
    enum class Usage { constant, dynamic }; ///< written once, or every frame or so

    Buffer() = default;
    explicit Buffer(std::string label, Usage usage = Usage::constant);

    /// Replaces content and size.
    void upload(const void* data, std::size_t bytes);
    template <typename T> void upload(std::span<const T> values)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        upload(values.data(), values.size_bytes());
    }
    /// Replaces a part. Throws Error when it reaches past the end.
    void subData(std::size_t offset, const void* data, std::size_t bytes);

    /// Bytes.
    std::size_t size() const { return size_; }
    const std::string& label() const { return object_.label(); }
    Name name() const { return object_.name(); }

    /// Makes it the uniform buffer at a binding index.
    void bindUniform(int binding) const;

private:
    Object object_;
    Usage usage_ = Usage::constant;
    std::size_t size_ = 0;
};

/// One std140 block, as T lays it out (shaders/shared/blocks.glsl), at one binding index.
template <typename T> class UniformBuffer {
public:
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % 16 == 0, "T must be laid out as std140");

    UniformBuffer() = default;
    UniformBuffer(int binding, std::string label) : buffer_(std::move(label), Buffer::Usage::dynamic), binding_(binding)
    {}

    /// Uploads and binds.
    void update(const T& value)
    {
        buffer_.upload(&value, sizeof(T));
        bind();
    }
    /// Several buffers may share an index; the one bound last is the one that programs see.
    void bind() const { buffer_.bindUniform(binding_); }
    int binding() const { return binding_; }

private:
    Buffer buffer_;
    int binding_ = 0;
};

} // namespace tarn::gl
