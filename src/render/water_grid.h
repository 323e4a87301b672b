// The water's grid of vertices, numbered by its lines (shared/water_grid.glsl tells where they stand); the passes that
// draw the surface share it. Its triangles lie in square blocks, so that a view draws those that it sees, nearest
// first.
#pragma once

#include "gl/buffer.h"
#include "gl/vertex_array.h"
#include "optics/water_grid.h"
#include "render/frame.h"
#include "render/passes/occlusion.h"
#include "render/view.h"

#include <vector>

namespace tarn {

class WaterGrid {
public:
    /// Draws size x size vertices with the program in use (passes/water.vert, attribute 0).
    void draw(int size, FrameReport::Pass& stats);

    struct Culling {
        const View& view;
        const optics64::WaterGrid& lines; ///< where the vertices stand
        const Bounds& slab;               ///< that the surface moves in, world
        bool cull = true;                 ///< leave out blocks beside the view
        Occlusion* occlusion = nullptr;   ///< by blocks; null: whatever is in view is drawn
    };
    /// Draws the blocks that a view may see, nearest first. What asks for hidden ones changes program and state:
    /// `use` sets up those that draw the surface.
    template <typename Use> void draw(int size, const Culling& culling, FrameReport::Pass& stats, const Use& use)
    {
        const std::vector<SeenBlock> seen = seenBlocks(size, culling);
        if (culling.occlusion && askForHidden(seen, culling)) use();
        for (const SeenBlock& block : seen) drawBlock(block, culling.occlusion, stats);
    }

private:
    struct Block {
        int firstIndex = 0, indexCount = 0;
        ivec2 lower{0}, upper{0}; ///< its outermost lines
    };
    struct SeenBlock {
        std::size_t index = 0;
        Bounds box; ///< world
        float distance = 0.0f;
        bool wasHidden = false;
    };

    void ensure(int size);
    std::vector<SeenBlock> seenBlocks(int size, const Culling& culling);
    bool askForHidden(const std::vector<SeenBlock>& seen, const Culling& culling) const;
    void drawBlock(const SeenBlock& block, Occlusion* occlusion, FrameReport::Pass& stats);

    int size_ = 0;
    int indexCount_ = 0;
    std::vector<Block> blocks_;
    gl::Buffer vertices_, indices_;
    gl::VertexArray grid_;
};

} // namespace tarn
