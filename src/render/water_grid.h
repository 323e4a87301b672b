// The water's grid of vertices, numbered by its lines (shared/water_grid.glsl tells where they stand); the passes that
// draw the surface share it.
#pragma once

#include "gl/buffer.h"
#include "gl/vertex_array.h"
#include "render/renderer.h"

namespace tarn {

class WaterGrid {
public:
    /// Draws size x size vertices with the program in use (passes/water.vert, attribute 0).
    void draw(int size, FrameStats::Pass& stats);

private:
    void ensure(int size);

    int size_ = 0;
    int indexCount_ = 0;
    gl::Buffer vertices_, indices_;
    gl::VertexArray grid_;
};

} // namespace tarn
