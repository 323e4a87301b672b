// The maps of heights of a frame whose rays are marched: of the bed, and of what stands over the water. Each is drawn
// again only when scene, sun or water change, or given as a picture and never drawn.
#pragma once

#include "gl/buffer.h"
#include "render/eye_frame.h"
#include "render/passes/heights.h"
#include "render/passes/heights_above_water.h"
#include "scene/scene.h"

#include <set>

namespace tarn {

class HeightMaps {
public:
    struct Inputs {
        const EyeFrame& eye; ///< its plan says which maps are marched through
        const SunVolume& volume;
        const SceneVariant& lit; ///< the sun's maps must be there for it
        const SceneMaps& given;
    };

    void draw(const Inputs& inputs, SceneRenderer& sceneRenderer, gl::UniformBuffer<blocks::ViewBlock>& viewBlock,
              FrameReport::Pass& stats);

    const HeightsPass& bed() const { return bed_; }
    const AboveWaterHeightsPass& aboveWater() const { return aboveWater_; }
    /// A map that is there, with the light that it was drawn in. Waits for the GPU.
    HeightMapPicture picture(MapKind kind) const;

private:
    void drawBed(const Inputs& inputs, SceneRenderer& sceneRenderer, gl::UniformBuffer<blocks::ViewBlock>& viewBlock,
                 FrameReport::Pass& stats);
    void drawAboveWater(const Inputs& inputs, SceneRenderer& sceneRenderer,
                        gl::UniformBuffer<blocks::ViewBlock>& viewBlock, FrameReport::Pass& stats);

    HeightsPass bed_;
    AboveWaterHeightsPass aboveWater_;
    MapLight light_;              ///< of the last frame
    std::set<MapKind> saidOther_; ///< of which given maps it was said that they were made in another light
};

} // namespace tarn
