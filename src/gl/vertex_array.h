// How vertices lie in their buffers, and the draw calls.
//
//     VertexArray mesh("terrain");
//     mesh.attributes(vertices, sizeof(Vertex), {{0, 3, offsetof(Vertex, position)}, {1, 3, offsetof(Vertex,
//     normal)}}); mesh.indices(indexBuffer); mesh.drawIndexed(Primitive::triangles, 0, count);
//
// The buffers must outlive the draws; the vertex array does not own them.
#pragma once

#include "gl/buffer.h"

#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>

namespace tarn::gl {

enum class Primitive { points, lines, lineStrip, triangles, triangleStrip };

struct Attribute {
    enum class Type { float32, int32, uint32, unorm8, snorm16 };
    int location;              ///< layout(location = …) in the vertex shader
    int components;            ///< 1 to 4
    std::size_t offset;        ///< bytes from the start of a vertex
    Type type = Type::float32; ///< int32 and uint32 arrive as integers, unorm8 and snorm16 as floats
};

/// A run of indices, for drawing many parts of one mesh with one call.
struct IndexRange {
    int first = 0; ///< in indices
    int count = 0;
};

class VertexArray {
public:
    VertexArray() = default;
    explicit VertexArray(std::string label);

    /// @param stride bytes from one vertex to the next   @param divisor 0: per vertex, n: every n instances
    void attributes(const Buffer& buffer, std::size_t stride, std::initializer_list<Attribute> list, int divisor = 0);
    /// 32-bit indices.
    void indices(const Buffer& buffer);

    void draw(Primitive primitive, int first, int count, int instances = 1) const;
    /// @param first in indices
    void drawIndexed(Primitive primitive, int first, int count, int instances = 1) const;
    void drawIndexed(Primitive primitive, std::span<const IndexRange> ranges) const;

    void bind() const;
    const std::string& label() const { return object_.label(); }

private:
    Object object_;
};

/// Draws a triangle that covers the viewport, from gl_VertexID alone (shaders/passes/fullscreen.vert).
/// Owns an empty vertex array: core profiles draw nothing without one.
/// While one lives, this thread draws nothing: programs, states and targets change as ever.
class NoDrawing {
public:
    NoDrawing() { ++count_; }
    ~NoDrawing() { --count_; }
    NoDrawing(const NoDrawing&) = delete;
    NoDrawing& operator=(const NoDrawing&) = delete;
    static bool inForce() { return count_ > 0; }

private:
    static thread_local int count_;
};

class FullscreenTriangle {
public:
    FullscreenTriangle();
    void draw() const { empty_.draw(Primitive::triangles, 0, 3); }

private:
    VertexArray empty_;
};

} // namespace tarn::gl
