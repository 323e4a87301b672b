// The water's surface over the scene: intersection, absorption, Fresnel (Mihálik 2008, chapter 7).
#pragma once

#include "gl/shader_library.h"
#include "gl/target.h"
#include "plan/options.h"
#include "render/frame.h"
#include "render/fresnel_texture.h"
#include "render/normal_map.h"
#include "render/pass_interface.h"
#include "render/passes/heights.h"
#include "render/passes/heights_above_water.h"
#include "render/view.h"
#include "render/water_grid.h"

#include <map>
#include <memory>
#include <optional>

namespace tarn {

class WaterPass {
public:
    static PassInterface interface(const FramePlan& plan)
    {
        Resources reads{Resource::sceneColour, Resource::sceneDepth, Resource::refraction, Resource::reflection};
        if (plan.side == WaterSide::crossing) reads = reads | Resources{Resource::waterline};
        if (plan.raycastsBed) reads = reads | Resources{Resource::bedHeights, Resource::sunDepth, Resource::caustics};
        if (plan.raycastsMirror) reads = reads | Resources{Resource::aboveWaterHeights};
        return {reads, {Resource::sceneColour, Resource::sceneDepth}};
    }

    explicit WaterPass(gl::ShaderLibrary& shaders) : shaders_(shaders) {}

    /// The bed's map of heights, and what lights the bed where a ray meets it.
    struct Bed {
        const HeightsPass& map;
        const SunMaps& sun;
        const SceneVariant& lit;
    };

    struct Inputs {
        std::optional<Bed> bed;                            ///< refraction.method = raycast, seen from above
        const AboveWaterHeightsPass* aboveWater = nullptr; ///< reflection.method = raycast, seen from above
        const gl::Target* refraction = nullptr;            ///< null: the water's own colour
        const View* refractionView = nullptr;
        const gl::Target* reflection = nullptr; ///< null: the sky
        const View* reflectionView = nullptr;
        const gl::Texture& skyMap;
        float ior = 1.33f; ///< of the water
        int waveCount = 0;
        float footprint = 1.0f; ///< of a pixel's edge that one of its samples stands for
        NormalMapInputs normalMap{};
        bool underwater = false;                     ///< the surface is seen from below
        std::optional<WaterGrid::Culling> culling{}; ///< what of the grid is seen; empty: all of it is drawn
        const gl::Texture* waterline = nullptr;      ///< in a frame that shows both sides: which pixels are whose
        DebugView view = DebugView::final;
    };

    /// Compiles the variant that these inputs need.
    gl::Program& program(const Options& options, const Inputs& inputs);

    /// Draws over what the frame's target holds, with its depth.
    void draw(const gl::Target& frame, WaterGrid& grid, const Options& options, const Inputs& inputs,
              FrameReport::Pass& stats);

private:
    gl::ShaderLibrary& shaders_;
    std::map<gl::Defines, std::shared_ptr<gl::Program>> programs_;
    FresnelTexture fresnelTable_;
};

} // namespace tarn
