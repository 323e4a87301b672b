// The maps of heights of a frame whose rays are marched: of the bed, and of what stands over the water. Each is drawn
// again only when scene, sun or water change.
#pragma once

#include "gl/buffer.h"
#include "plan/frame_plan.h"
#include "render/passes/heights.h"
#include "render/passes/heights_afloat.h"

namespace tarn {

class HeightMaps {
public:
    struct Inputs {
        const FramePlan& plan; ///< says which maps are marched through
        const Options& options;
        const WaterBody& water;
        const Bounds& bounds;  ///< of the scene, world
        const SunVolume& volume;
        const blocks::FrameBlock& light;
        const PaintStyle& lit; ///< the sun's maps must be there for it
    };

    void draw(const Inputs& inputs, ScenePainter& painter, gl::UniformBuffer<blocks::ViewBlock>& viewBlock,
              FrameStats::Pass& stats);

    const HeightsPass& bed() const { return bed_; }
    const AfloatHeightsPass& afloat() const { return afloat_; }

private:
    HeightsPass bed_;
    AfloatHeightsPass afloat_;
};

} // namespace tarn
