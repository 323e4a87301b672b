// A scene in the graphics card's memory: meshes, textures, and the baked sky. Made once per scene, for all contexts
// that share what they hold.
//
// It refers to the Scene for as long as it lives, but reads the texels of Scene::images in its constructor only:
// whoever owns the scene may release them afterwards (releaseTexels() in scene/scene.h). Meshes stay in both memories,
// for levels of detail and for what the plan asks of the triangles.
#pragma once

#include "gl/buffer.h"
#include "gl/texture.h"
#include "gl/vertex_array.h"
#include "render/alpha_mips.h"
#include "render/visibility.h"
#include "scene/scene.h"
#include "scene/sky.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tarn {

class Progress;

/// A mesh's vertices, laid out as Vertex, and indices. Shared, since another context may draw from them, too.
struct MeshBuffers {
    std::shared_ptr<gl::Buffer> vertices, indices;
};
/// For the current context, whose vertex arrays are its own.
gl::VertexArray meshVertexArray(const std::string& label, const MeshBuffers& buffers);

class GpuScene {
public:
    GpuScene(const Scene& scene, float anisotropy, Progress* progress);

    const Scene& scene() const { return scene_; }
    const std::vector<Instance>& instances() const { return instances_; }
    /// Levels of detail are among them after ensureDetail().
    const Chunks& chunks() const { return chunks_; }
    const SkyModel& sky() const { return sky_; }
    const gl::Texture& skyMap() const { return skyMap_; }
    const MeshBuffers& buffers(int mesh) const { return meshes_[static_cast<std::size_t>(mesh)]; }

    /// How a map's values are meant: colours are sRGB-encoded, the rest is linear.
    enum class MapUse { colour, data };
    const gl::Texture& texture(int image, MapUse use) const { return textures_.at({image, use}).texture; }
    /// The same; a cut-out's smaller levels hold coverage (render/alpha_mips.h). Only after ensureCoverage().
    const gl::Texture& coverage(int image, MapUse use) const;
    /// Uploads what coverage() gives, once.
    void ensureCoverage();

    /// Makes and uploads levels of detail of every mesh, once. True when there were none before.
    bool ensureDetail(Progress* progress);

    /// Of vertices and indices, as uploaded.
    std::size_t geometryBytes() const { return geometryBytes_; }

    /// The water's normal map (render/normal_map.h), or null.
    const gl::Texture* waterNormals() const { return waterNormals_ ? &waterNormals_ : nullptr; }

    void setAnisotropy(float anisotropy);

private:
    void uploadMeshes();
    void uploadIndices(std::size_t mesh, const std::vector<std::uint32_t>& further);
    void uploadTextures(Progress* progress);
    gl::Texture uploaded(const Image& image, MapUse use) const;
    void bakeSky();

    const Scene& scene_;
    std::vector<Instance> instances_;
    Chunks chunks_;
    bool hasDetail_ = false;
    std::size_t geometryBytes_ = 0;
    SkyModel sky_;
    std::vector<MeshBuffers> meshes_;
    struct MapTexture {
        gl::Texture texture;
        std::optional<CutOut> cutOut; ///< how materials that test alpha by it cut surfaces out, or nothing
        gl::Texture coverage;         ///< of a cut-out; empty until they are wanted
    };
    using TextureKey = std::pair<int, MapUse>;
    std::map<TextureKey, MapTexture> textures_;
    float anisotropy_;
    gl::Texture skyMap_;
    gl::Texture waterNormals_;
};

} // namespace tarn
