// A scene in the graphics card's memory: meshes, textures, and the baked sky. Made once per scene.
#pragma once

#include "gl/buffer.h"
#include "gl/texture.h"
#include "gl/vertex_array.h"
#include "render/alpha_mips.h"
#include "render/visibility.h"
#include "scene/scene.h"
#include "scene/sky.h"

#include <map>
#include <utility>
#include <vector>

namespace tarn {

class Progress;

class GpuScene {
public:
    GpuScene(const Scene& scene, float anisotropy, Progress* progress);

    const Scene& scene() const { return scene_; }
    const std::vector<Instance>& instances() const { return instances_; }
    const std::vector<Chunk>& chunks() const { return chunks_; }
    const SkyModel& sky() const { return sky_; }
    const gl::Texture& skyMap() const { return skyMap_; }
    const gl::VertexArray& mesh(int index) const { return meshes_[static_cast<std::size_t>(index)].array; }

    /// How a map's values are meant: colours are sRGB-encoded, the rest is linear.
    enum class MapUse { colour, data };
    const gl::Texture& texture(int image, MapUse use) const { return textures_.at({image, use}); }
    /// The same; a cut-out's smaller levels hold shares (render/alpha_mips.h). Only after wantShares().
    const gl::Texture& shares(int image, MapUse use) const;
    /// Uploads what shares() gives, once.
    void wantShares();

    /// The water's normal map (render/normal_map.h), or null.
    const gl::Texture* waterNormals() const { return waterNormals_ ? &waterNormals_ : nullptr; }

    void setAnisotropy(float anisotropy);

private:
    void uploadMeshes();
    void uploadTextures(Progress* progress);
    gl::Texture uploaded(int image, MapUse use, CutOutLevels levels) const;
    void bakeSky();

    struct GpuMesh {
        gl::Buffer vertices, indices;
        gl::VertexArray array;
    };

    const Scene& scene_;
    std::vector<Instance> instances_;
    std::vector<Chunk> chunks_;
    SkyModel sky_;
    std::vector<GpuMesh> meshes_;
    using TextureKey = std::pair<int, MapUse>;
    std::map<TextureKey, gl::Texture> textures_;
    std::map<TextureKey, gl::Texture> shares_; ///< of cut-outs; empty until they are wanted
    float anisotropy_;
    gl::Texture skyMap_;
    gl::Texture waterNormals_;
};

} // namespace tarn
