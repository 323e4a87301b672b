// A name that OpenGL gave out, owned: the base of every wrapper in this folder.
//
// Wrappers are move-only and empty when default-constructed. They must die before their context does: let
// them live in a scope that ends before the context's.
#pragma once

#include <string>

namespace tarn::gl {

/// OpenGL's GLuint.
using Name = unsigned int;

class Object {
public:
    enum class Kind { buffer, vertexArray, texture, renderbuffer, framebuffer, program, query };

    Object() = default;
    /// Asks OpenGL for a name. The object exists, and can be labelled, from its first binding on.
    Object(Kind kind, std::string label);
    ~Object();
    Object(Object&& other) noexcept;
    Object& operator=(Object&& other) noexcept;
    Object(const Object&) = delete;
    Object& operator=(const Object&) = delete;

    Name name() const { return name_; }
    const std::string& label() const { return label_; }
    explicit operator bool() const { return name_ != 0; }

    /// Tells debuggers the label, where KHR_debug is there. Call after the first binding.
    void announceLabel() const;

private:
    void release() noexcept;

    Kind kind_ = Kind::buffer;
    Name name_ = 0;
    std::string label_;
};

} // namespace tarn::gl
