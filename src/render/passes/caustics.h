// Light that the waves gather on what lies under water (Mihálik 2008, chapter 8): the sun's photons, found on the bed
// and added up in a texture of irradiance relative to the sun's above the water, both through a level area.
//
// Four ways to add them up, one interface; CausticsOptions::Method says what each does.
#pragma once

#include "gl/buffer.h"
#include "gl/shader_library.h"
#include "gl/target.h"
#include "gl/vertex_array.h"
#include "optics/blocks.h"
#include "plan/options.h"
#include "render/frame.h"
#include "render/pass_interface.h"

#include <map>
#include <memory>
#include <vector>

namespace tarn {

class CausticsPass {
public:
    static PassInterface interface(const FramePlan&) { return {{Resource::sunDepth}, {Resource::caustics}}; }

    explicit CausticsPass(gl::ShaderLibrary& shaders) : shaders_(shaders) {}

    struct Inputs {
        const gl::Texture& sunDepth;      ///< of SunlightPass
        bool shadows;                     ///< of what stands over the water
        vec3 absorption;                  ///< 1/m, for the method that works on the processor
        bool surfaceMovesSideways = true; ///< waves shift the photons' start by more than a part of a cell
        std::vector<float> waveWeights{}; ///< of each wave: what of it a lattice of photons can carry
    };

    /// FrameBlock, WavesBlock and SunBlock must be bound. The texture has mipmaps.
    const gl::Target& draw(const CausticsOptions& options, const Inputs& inputs, FrameReport::Pass& stats);
    const gl::Target& target() const { return filtered_; }

    /// Of the last draw: four floats a photon (caustics_photons.frag), and the texture before its filter.
    const gl::Target& photons() const { return photons_; }
    const gl::Target& gathered() const { return gathered_; }

private:
    gl::Program& photonProgram(const CausticsOptions& options, const Inputs& inputs);
    void castPhotons(const CausticsOptions& options, const Inputs& inputs);
    void gatherOnProcessor(const CausticsOptions& options, const vec3& absorption);
    void gatherPoints(const CausticsOptions& options, FrameReport::Pass& stats);
    void gatherMesh(const CausticsOptions& options, FrameReport::Pass& stats);
    void filter(const CausticsOptions& options);
    /// @param axis of the texture, as the shader writes it
    gl::Program& filterProgram(const char* axis, int radius);
    gl::Program& gatherProgram(CausticsOptions::Method method);

    gl::ShaderLibrary& shaders_;
    gl::Target photons_{"caustics photons"};
    gl::Target gathered_{"caustics gathered"};
    gl::Target filteredAcross_{"caustics filtered across"};
    gl::Target filtered_{"caustics"};
    gl::FullscreenTriangle triangle_;
    gl::Buffer photonBuffer_;
    gl::VertexArray photonPoints_; ///< over photonBuffer_
    gl::VertexArray bare_;         ///< no attributes: photons are fetched
    std::map<gl::Defines, std::shared_ptr<gl::Program>> photonPrograms_, filterPrograms_;
    std::map<CausticsOptions::Method, std::shared_ptr<gl::Program>> gatherPrograms_;
};

/// What the method `cpu` does: adds photons (four floats each, caustics_photons.frag) to a square of `resolution`
/// texels. Returns RGBA.
std::vector<float> gatherPhotons(const std::vector<float>& photons, int resolution, const vec3& absorption);

} // namespace tarn
