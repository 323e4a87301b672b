#include "gl/vertex_array.h"

#include "gl/api.h"
#include "gl/counters.h"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace tarn::gl {

namespace {

GLenum mode(Primitive primitive)
{
    constexpr std::array<GLenum, 5> modes = {GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_TRIANGLES, GL_TRIANGLE_STRIP};
    return modes[static_cast<std::size_t>(primitive)];
}

GLenum componentType(Attribute::Type type)
{
    constexpr std::array<GLenum, 5> types = {GL_FLOAT, GL_INT, GL_UNSIGNED_INT, GL_UNSIGNED_BYTE, GL_SHORT};
    return types[static_cast<std::size_t>(type)];
}

/// OpenGL takes offsets into a buffer as pointers.
const void* asPointer(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

const void* indexOffset(int first) { return asPointer(static_cast<std::size_t>(first) * sizeof(std::uint32_t)); }

} // namespace

VertexArray::VertexArray(std::string label) : object_(Object::Kind::vertexArray, std::move(label))
{
    bind();
    object_.announceLabel();
}

void VertexArray::attributes(const Buffer& buffer, std::size_t stride, std::initializer_list<Attribute> list,
                             int divisor)
{
    bind();
    glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
    for (const Attribute& a : list) {
        const auto location = static_cast<GLuint>(a.location);
        const auto bytes = static_cast<GLsizei>(stride);
        const bool isInteger = a.type == Attribute::Type::int32 || a.type == Attribute::Type::uint32;
        glEnableVertexAttribArray(location);
        if (isInteger) {
            glVertexAttribIPointer(location, a.components, componentType(a.type), bytes, asPointer(a.offset));
        } else {
            const GLboolean normalised = a.type == Attribute::Type::float32 ? GL_FALSE : GL_TRUE;
            glVertexAttribPointer(location, a.components, componentType(a.type), normalised, bytes,
                                  asPointer(a.offset));
        }
        glVertexAttribDivisor(location, static_cast<GLuint>(divisor));
    }
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void VertexArray::indices(const Buffer& buffer)
{
    bind();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer.name());
}

thread_local int NoDrawing::count_ = 0;

void VertexArray::draw(Primitive primitive, int first, int count, int instances) const
{
    if (NoDrawing::inForce()) return;
    bind();
    gl::count(Call::draw);
    if (instances == 1)
        glDrawArrays(mode(primitive), first, count);
    else
        glDrawArraysInstanced(mode(primitive), first, count, instances);
}

void VertexArray::drawIndexed(Primitive primitive, int first, int count, int instances) const
{
    if (NoDrawing::inForce()) return;
    bind();
    gl::count(Call::draw);
    if (instances == 1)
        glDrawElements(mode(primitive), count, GL_UNSIGNED_INT, indexOffset(first));
    else
        glDrawElementsInstanced(mode(primitive), count, GL_UNSIGNED_INT, indexOffset(first), instances);
}

void VertexArray::drawIndexed(Primitive primitive, std::span<const IndexRange> ranges) const
{
    if (ranges.empty() || NoDrawing::inForce()) return;
    bind();
    thread_local std::vector<GLsizei> counts; // kept: this runs every frame
    thread_local std::vector<const void*> offsets;
    counts.clear();
    offsets.clear();
    for (const IndexRange& range : ranges) {
        counts.push_back(range.count);
        offsets.push_back(indexOffset(range.first));
    }
    count(Call::draw);
    glMultiDrawElements(mode(primitive), counts.data(), GL_UNSIGNED_INT, offsets.data(),
                        static_cast<GLsizei>(counts.size()));
}

void VertexArray::bind() const
{
    count(Call::vertexArrayBind);
    glBindVertexArray(object_.name());
}

FullscreenTriangle::FullscreenTriangle() : empty_("fullscreen triangle") {}

} // namespace tarn::gl
