#include "gl/buffer.h"

#include "base/error.h"
#include "gl/api.h"
#include "gl/counters.h"

#include <utility>

namespace tarn::gl {

namespace {

// Uploads go through a target that no draw call looks at, so that the bindings of a vertex array stay.
constexpr GLenum uploadTarget = GL_COPY_WRITE_BUFFER;

} // namespace

Buffer::Buffer(std::string label, Usage usage) : object_(Object::Kind::buffer, std::move(label)), usage_(usage)
{
    glBindBuffer(uploadTarget, object_.name());
    object_.announceLabel();
}

void Buffer::upload(const void* data, std::size_t bytes)
{
    glBindBuffer(uploadTarget, object_.name());
    count(Call::bufferUpload);
    glBufferData(uploadTarget, static_cast<GLsizeiptr>(bytes), data,
                 usage_ == Usage::constant ? GL_STATIC_DRAW : GL_DYNAMIC_DRAW);
    size_ = bytes;
}

void Buffer::subData(std::size_t offset, const void* data, std::size_t bytes)
{
    if (offset > size_ || bytes > size_ - offset) {
        throw Error("buffer \"{}\" holds {} bytes; {} bytes at {} reach past its end", label(), size_, bytes, offset);
    }
    glBindBuffer(uploadTarget, object_.name());
    count(Call::bufferUpload);
    glBufferSubData(uploadTarget, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), data);
}

void Buffer::bindUniform(int binding) const
{
    glBindBufferBase(GL_UNIFORM_BUFFER, static_cast<GLuint>(binding), object_.name());
}

} // namespace tarn::gl
