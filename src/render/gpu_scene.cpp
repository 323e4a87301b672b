#include "render/gpu_scene.h"

#include "base/progress.h"
#include "render/alpha_mips.h"
#include "render/normal_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace tarn {

GpuScene::GpuScene(const Scene& scene, float anisotropy, Progress* progress)
    : scene_(scene), instances_(flatten(scene)), chunks_(listChunks(scene, instances_)), sky_(scene),
      anisotropy_(anisotropy)
{
    uploadMeshes();
    uploadTextures(progress);
    if (const int map = scene.water.normalMap.image; map != noImage)
        waterNormals_ = normalMapTexture(scene.images[static_cast<std::size_t>(map)], anisotropy);
    bakeSky();
}

void GpuScene::uploadMeshes()
{
    meshes_.resize(scene_.meshes.size());
    for (std::size_t i = 0; i < meshes_.size(); ++i) {
        const Mesh& mesh = scene_.meshes[i];
        MeshBuffers& buffers = meshes_[i];
        buffers.vertices = std::make_shared<gl::Buffer>(mesh.name + " vertices");
        buffers.vertices->upload(std::span(mesh.vertices));
        uploadIndices(i, {});
        geometryBytes_ += buffers.vertices->size() + buffers.indices->size();
    }
}

gl::VertexArray meshVertexArray(const std::string& label, const MeshBuffers& buffers)
{
    gl::VertexArray array(label);
    array.attributes(*buffers.vertices, sizeof(Vertex),
                     {{0, 3, offsetof(Vertex, position)},
                      {1, 3, offsetof(Vertex, normal)},
                      {2, 4, offsetof(Vertex, tangent)},
                      {3, 2, offsetof(Vertex, uv)},
                      {4, 4, offsetof(Vertex, colour), gl::Attribute::Type::unorm8}});
    array.indices(*buffers.indices);
    return array;
}

/// A mesh's own triangles, and further ones of the same vertices after them. In a new buffer: another context may be
/// drawing from the old one.
void GpuScene::uploadIndices(std::size_t mesh, const std::vector<std::uint32_t>& further)
{
    const std::vector<std::uint32_t>& own = scene_.meshes[mesh].indices;
    MeshBuffers& buffers = meshes_[mesh];
    buffers.indices = std::make_shared<gl::Buffer>(scene_.meshes[mesh].name + " indices");
    if (further.empty()) {
        buffers.indices->upload(std::span(own));
    } else {
        std::vector<std::uint32_t> all;
        all.reserve(own.size() + further.size());
        all.insert(all.end(), own.begin(), own.end());
        all.insert(all.end(), further.begin(), further.end());
        buffers.indices->upload(std::span(std::as_const(all)));
    }
}

bool GpuScene::ensureDetail(Progress* progress)
{
    if (std::exchange(hasDetail_, true)) return false;
    std::vector<MeshDetail> details(scene_.meshes.size());
    for (std::size_t i = 0; i < details.size(); ++i) {
        const Mesh& mesh = scene_.meshes[i];
        if (progress)
            progress->report(static_cast<double>(i) / static_cast<double>(details.size()),
                             "making levels of detail of " + mesh.name);
        details[i] = buildDetail(mesh, scene_.materials);
        if (!details[i].indices.empty()) uploadIndices(i, details[i].indices);
        geometryBytes_ += sizeof(std::uint32_t) * details[i].indices.size();
    }
    chunks_ = listChunks(scene_, instances_, details);
    return true;
}

namespace {

/// OpenGL's first row is the lowest; a picture file's is the highest.
template <typename T> std::vector<T> upsideDown(const std::vector<T>& values, int width, int height, int channels)
{
    const std::size_t row = static_cast<std::size_t>(width) * static_cast<std::size_t>(channels);
    std::vector<T> flipped(values.size());
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y)
        std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(y * row), row,
                    flipped.end() - static_cast<std::ptrdiff_t>((y + 1) * row));
    return flipped;
}

/// Grey pictures say the same in every colour channel.
template <typename T> std::vector<T> spreadGrey(const std::vector<T>& grey)
{
    std::vector<T> rgb;
    rgb.reserve(grey.size() * 3);
    for (const T value : grey) rgb.insert(rgb.end(), 3, value);
    return rgb;
}

/// The channels that are not in the picture but in the texture, which has one only where nothing else is read.
template <typename T>
void uploadLevel(gl::Texture& texture, const Image& image, const std::vector<T>& values, int level)
{
    const auto rows = upsideDown(values, image.width, image.height, image.channels);
    const bool spreads = image.channels == 1 && gl::channelCount(texture.format()) > 1;
    texture.upload(std::span<const T>(spreads ? spreadGrey(rows) : rows), spreads ? 3 : image.channels, 0, level);
}

/// How a picture cuts surfaces out, where a material tests alpha by it.
std::optional<CutOut> cutOutOf(const Scene& scene, int index, bool isColour)
{
    const Image& image = scene.images[static_cast<std::size_t>(index)];
    if (image.isFloat()) return std::nullopt;
    for (const Material& material : scene.materials) {
        if (!material.alphaTested || material.alpha <= 0.0f) continue;
        const float cutoff = std::min(material.alphaCutoff / material.alpha, 1.0f); // of the map alone
        if (isColour && material.diffuseMap == index && image.channels == 4) return CutOut{3, cutoff, true};
        if (!isColour && material.alphaMap == index) return CutOut{0, cutoff, false};
    }
    return std::nullopt;
}

/// The picture that an 8-bit texture was made of; the scene may have released it.
Image pictureOf(const gl::Texture& texture)
{
    const std::vector<float> values = texture.readBack();
    Image image{texture.label(), texture.size().x, texture.size().y, gl::channelCount(texture.format()), {}, {}};
    std::vector<std::uint8_t> bytes(values.size());
    std::transform(values.begin(), values.end(), bytes.begin(),
                   [](float value) { return static_cast<std::uint8_t>(std::lround(255.0f * value)); });
    image.bytes = upsideDown(bytes, image.width, image.height, image.channels);
    return image;
}

constexpr std::uintmax_t mostCachedBytes = 64 << 20; // the lake's take 8 MB

void uploadCutOutLevels(gl::Texture& texture, const Image& image, const CutOut& cutOut, CutOutLevels kind)
{
    const DiskCache cache(cacheFolder() / "mip-levels", mostCachedBytes);
    int level = 0;
    for (const Image& smaller : cutOutMips(image, cutOut, kind, cache))
        uploadLevel(texture, smaller, smaller.bytes, ++level);
}

} // namespace

void GpuScene::uploadTextures(Progress* progress)
{
    std::vector<TextureKey> wanted;
    const auto want = [&wanted](int image, MapUse use) {
        if (image != noImage) wanted.emplace_back(image, use);
    };
    for (const Material& material : scene_.materials) {
        want(material.diffuseMap, MapUse::colour);
        want(material.emissiveMap, MapUse::colour);
        want(material.alphaMap, MapUse::data);
        want(material.normalMap, MapUse::data);
    }
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const auto [index, use] = wanted[i];
        const Image& image = scene_.images[static_cast<std::size_t>(index)];
        if (progress)
            progress->report(static_cast<double>(i) / static_cast<double>(wanted.size()), "uploading " + image.name);
        if (textures_.contains(wanted[i])) continue;
        MapTexture map{uploaded(image, use), cutOutOf(scene_, index, use == MapUse::colour), {}};
        if (map.cutOut)
            uploadCutOutLevels(map.texture, image, *map.cutOut, CutOutLevels::covering);
        else
            map.texture.generateMipmaps();
        textures_.emplace(wanted[i], std::move(map));
    }
}

/// The largest level; the others are there, and undefined.
gl::Texture GpuScene::uploaded(const Image& image, MapUse use) const
{
    gl::TextureDesc desc;
    desc.size = {image.width, image.height};
    desc.mipmaps = true;
    desc.wrap = gl::Wrap::repeat;
    desc.anisotropy = anisotropy_;
    if (image.isFloat())
        desc.format = gl::Format::rgba16f;
    else if (use == MapUse::colour)
        desc.format = gl::Format::srgb8a8;
    else
        desc.format = image.channels == 1 ? gl::Format::r8 : gl::Format::rgba8;

    gl::Texture texture(desc, image.name);
    if (image.isFloat())
        uploadLevel(texture, image, image.floats, 0);
    else
        uploadLevel(texture, image, image.bytes, 0);
    return texture;
}

void GpuScene::setAnisotropy(float anisotropy)
{
    anisotropy_ = anisotropy;
    for (auto& [key, map] : textures_) {
        map.texture.setAnisotropy(anisotropy);
        if (map.coverage) map.coverage.setAnisotropy(anisotropy);
    }
    if (waterNormals_) waterNormals_.setAnisotropy(anisotropy);
}

void GpuScene::ensureCoverage()
{
    for (auto& [key, map] : textures_) {
        if (!map.cutOut || map.coverage) continue;
        const Image image = pictureOf(map.texture);
        map.coverage = uploaded(image, key.second);
        uploadCutOutLevels(map.coverage, image, *map.cutOut, CutOutLevels::coverage);
    }
}

const gl::Texture& GpuScene::coverage(int image, MapUse use) const
{
    const MapTexture& map = textures_.at({image, use});
    return map.coverage ? map.coverage : map.texture;
}

namespace {

/// The direction of a texel's centre on a face of a cube map (OpenGL 3.3 core, section 3.8.10, table 3.19).
vec3 cubeDirection(int face, int x, int y, int size)
{
    const float s = 2.0f * (static_cast<float>(x) + 0.5f) / static_cast<float>(size) - 1.0f;
    const float t = 2.0f * (static_cast<float>(y) + 0.5f) / static_cast<float>(size) - 1.0f;
    switch (face) {
    case 0: return normalize(vec3(1.0f, -t, -s));
    case 1: return normalize(vec3(-1.0f, -t, s));
    case 2: return normalize(vec3(s, 1.0f, t));
    case 3: return normalize(vec3(s, -1.0f, -t));
    case 4: return normalize(vec3(s, -t, 1.0f));
    default: return normalize(vec3(-s, -t, -1.0f));
    }
}

/// Fine enough for the sky that there is: one colour needs one texel.
int skyMapSize(const Sky& sky)
{
    switch (sky.kind) {
    case Sky::Kind::constant: return 1;
    case Sky::Kind::daylight: return 128;
    case Sky::Kind::picture: return 512;
    }
    return 128;
}

} // namespace

void GpuScene::bakeSky()
{
    const int size = skyMapSize(scene_.sky);
    gl::TextureDesc desc;
    desc.kind = gl::TextureKind::cube;
    desc.format = gl::Format::rgba16f;
    desc.size = {size, size};
    skyMap_ = gl::Texture(desc, "sky");
    // Half floats end at 65504; a picture of the sun can be brighter.
    constexpr float largest = 60000.0f;
    std::vector<float> texels(static_cast<std::size_t>(size) * static_cast<std::size_t>(size) * 3);
    for (int face = 0; face < 6; ++face) {
        std::size_t i = 0;
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const vec3 radiance = glm::clamp(sky_.radiance(cubeDirection(face, x, y, size)), 0.0f, largest);
                for (int c = 0; c < 3; ++c) texels[i++] = radiance[c];
            }
        }
        skyMap_.upload(std::span<const float>(texels), 3, face);
    }
}

} // namespace tarn
