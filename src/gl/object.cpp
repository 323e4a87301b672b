#include "gl/object.h"

#include "gl/api.h"
#include "gl/context.h"

#include <algorithm>
#include <utility>

namespace tarn::gl {

static_assert(sizeof(Name) == sizeof(GLuint));

namespace {

Name create(Object::Kind kind)
{
    Name name = 0;
    switch (kind) {
    case Object::Kind::buffer: glGenBuffers(1, &name); break;
    case Object::Kind::vertexArray: glGenVertexArrays(1, &name); break;
    case Object::Kind::texture: glGenTextures(1, &name); break;
    case Object::Kind::renderbuffer: glGenRenderbuffers(1, &name); break;
    case Object::Kind::framebuffer: glGenFramebuffers(1, &name); break;
    case Object::Kind::program: name = glCreateProgram(); break;
    case Object::Kind::query: glGenQueries(1, &name); break;
    }
    return name;
}

GLenum identifier(Object::Kind kind)
{
    switch (kind) {
    case Object::Kind::buffer: return GL_BUFFER;
    case Object::Kind::vertexArray: return GL_VERTEX_ARRAY;
    case Object::Kind::texture: return GL_TEXTURE;
    case Object::Kind::renderbuffer: return GL_RENDERBUFFER;
    case Object::Kind::framebuffer: return GL_FRAMEBUFFER;
    case Object::Kind::program: return GL_PROGRAM;
    case Object::Kind::query: return GL_QUERY;
    }
    return GL_NONE;
}

} // namespace

Object::Object(Kind kind, std::string label) : kind_(kind), name_(create(kind)), label_(std::move(label)) {}

Object::~Object() { release(); }

Object::Object(Object&& other) noexcept
    : kind_(other.kind_), name_(std::exchange(other.name_, 0)), label_(std::move(other.label_))
{}

Object& Object::operator=(Object&& other) noexcept
{
    if (this == &other) return *this;
    release();
    kind_ = other.kind_;
    name_ = std::exchange(other.name_, 0);
    label_ = std::move(other.label_);
    return *this;
}

void Object::announceLabel() const
{
    if (!capabilities().debug || label_.empty()) return;
    // Drivers must take 256 characters including the terminating zero.
    const auto length = static_cast<GLsizei>(std::min<std::size_t>(label_.size(), 255));
    glObjectLabel(identifier(kind_), name_, length, label_.data());
}

void Object::release() noexcept
{
    if (name_ == 0) return;
    switch (kind_) {
    case Kind::buffer: glDeleteBuffers(1, &name_); break;
    case Kind::vertexArray: glDeleteVertexArrays(1, &name_); break;
    case Kind::texture: glDeleteTextures(1, &name_); break;
    case Kind::renderbuffer: glDeleteRenderbuffers(1, &name_); break;
    case Kind::framebuffer: glDeleteFramebuffers(1, &name_); break;
    case Kind::program: glDeleteProgram(name_); break;
    case Kind::query: glDeleteQueries(1, &name_); break;
    }
    name_ = 0;
}

} // namespace tarn::gl
