#include "reference/identity.h"

#include "base/hash.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

namespace tarn::reference {

namespace {

/// The bytes of a part's values, one after the other.
class Content {
public:
    /// Numbers and vectors of them, which have no padding.
    template <typename T> Content& add(const T& value)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        return bytes(&value, sizeof value);
    }
    template <typename T> Content& addAll(const std::vector<T>& values)
    {
        static_assert(std::is_arithmetic_v<T>);
        add(values.size());
        // Megabytes are hashed where they lie.
        return add(hashOf({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)}));
    }
    Content& add(const Image& image)
    {
        add(image.width).add(image.height).add(image.channels);
        return addAll(image.bytes).addAll(image.floats);
    }
    Content& addText(const std::string& text) { return add(text.size()).bytes(text.data(), text.size()); }
    std::string hash() const { return fmt::format("{:016x}", fnv1a(bytes_)); }

private:
    Content& bytes(const void* data, std::size_t size)
    {
        bytes_.append(static_cast<const char*>(data), size);
        return *this;
    }
    std::string bytes_;
};

// Vertices and parts are hashed as they lie in memory.
static_assert(sizeof(Vertex) == 12 * sizeof(float) + sizeof(std::uint32_t));

Content geometryOf(const Scene& scene)
{
    Content content;
    for (const Instance& instance : flatten(scene)) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        content.add(instance.worldFromModel).addAll(mesh.indices).add(mesh.vertices.size());
        const std::string_view vertices(reinterpret_cast<const char*>(mesh.vertices.data()),
                                        mesh.vertices.size() * sizeof(Vertex));
        content.add(hashOf(vertices));
        for (const MeshPart& part : mesh.parts) content.add(part.material).add(part.firstIndex).add(part.indexCount);
    }
    return content;
}

Content materialsOf(const Scene& scene)
{
    Content content;
    for (const Material& m : scene.materials) {
        content.add(m.diffuse).add(m.specular).add(m.transmission).add(m.shininess).add(m.emissive).add(m.alpha);
        content.add(m.alphaTested).add(m.twoSided).add(m.alphaCutoff).add(m.bumpScale);
    }
    return content;
}

/// A picture where it is used, whatever its number.
Content& addPicture(Content& content, const Scene& scene, int image)
{
    content.add(image != noImage);
    return image == noImage ? content : content.add(scene.images[static_cast<std::size_t>(image)]);
}

Content texturesOf(const Scene& scene)
{
    std::vector<std::string> hashes; // each is read once, however many materials it has
    for (std::size_t i = 0; i < scene.images.size(); ++i) {
        Content one;
        hashes.push_back(addPicture(one, scene, static_cast<int>(i)).hash());
    }
    Content content;
    for (const Material& m : scene.materials)
        for (const int image : {m.diffuseMap, m.emissiveMap, m.alphaMap, m.normalMap})
            content.addText(image == noImage ? "none" : hashes[static_cast<std::size_t>(image)]);
    return content;
}

Content skyOf(const Scene& scene)
{
    const Sky& sky = scene.sky;
    Content content;
    content.add(sky.kind).add(sky.radiance).add(sky.turbidity).add(sky.groundAlbedo);
    return addPicture(content, scene, sky.image).add(sky.rotation).add(sky.lighting);
}

Content sunOf(const Scene& scene)
{
    Content content;
    content.add(scene.sun.has_value());
    if (scene.sun) content.add(scene.sun->direction).add(scene.sun->irradiance).add(scene.sun->automatic);
    return content;
}

Content lightsOf(const Scene& scene)
{
    Content content;
    for (const PointLight& light : scene.pointLights) content.add(light.position).add(light.intensity);
    content.add(scene.pointLights.size());
    for (const SpotLight& light : scene.spotLights)
        content.add(light.position)
            .add(light.direction)
            .add(light.intensity)
            .add(light.innerAngle)
            .add(light.outerAngle);
    return content;
}

Content waterOf(const WaterBody& body)
{
    Content content;
    content.add(body.present);
    if (!body.present) return content;
    content.add(body.level).add(body.centre).add(body.extent).add(body.ior).add(body.absorption).add(body.colour);
    return content;
}

Content wavesOf(const Scene& scene, const WaterBody& body)
{
    Content content;
    if (!body.present) return content;
    for (const Wave& wave : body.waves)
        content.add(wave.amplitude).add(wave.wavelength).add(wave.direction).add(wave.phase).add(wave.period);
    const WaterNormalMap& map = body.normalMap;
    content.add(map.isSeen());
    if (!map.isSeen()) return content;
    addPicture(content, scene, map.image).add(map.tile).add(map.bump);
    for (const WaterNormalMap::Layer& layer : map.layers) content.add(layer.velocity);
    return content;
}

std::vector<std::string_view> partsOf(std::string_view identity)
{
    constexpr std::string_view separator = "; ";
    std::vector<std::string_view> parts;
    while (!identity.empty()) {
        const std::size_t end = std::min(identity.find(separator), identity.size());
        parts.push_back(identity.substr(0, end));
        identity.remove_prefix(std::min(end + separator.size(), identity.size()));
    }
    return parts;
}

std::string_view nameOf(std::string_view part) { return part.substr(0, part.find(' ')); }

std::string identityOf(const TargetCamera& camera)
{
    std::string text = fmt::format(" {},{} far {} clip {} {} {}", camera.tangents.x, camera.tangents.y, camera.farPlane,
                                   camera.clipLevel, camera.keepsAbove, camera.throughFlatWater);
    for (int i = 0; i < 16; ++i) text += fmt::format(" {}", camera.viewFromWorld[i / 4][i % 4]);
    return text;
}

std::string identityOf(const Approximations& rough)
{
    std::string text;
    if (rough.schlickExponent > 0.0f) text += fmt::format("; Schlick {}", rough.schlickExponent);
    if (rough.attenuationLength > 0.0f) text += fmt::format("; fades over {} m", rough.attenuationLength);
    if (const auto& table = rough.fresnelTable)
        text += fmt::format("; Fresnel of {} texels{}", table->texels.size(),
                            table->filter == optics::TableFilter::linear ? " blended" : "");
    if (rough.refraction)
        text += fmt::format("; refraction {} {}", rough.refractionSteps, rough.planarRefraction) +
                identityOf(*rough.refraction);
    if (rough.reflection)
        text += fmt::format("; reflection {} {}", rough.reflectionSteps, rough.reflectionDistance) +
                identityOf(*rough.reflection);
    for (const auto& texels : {rough.refractionTexels, rough.reflectionTexels})
        if (texels) text += fmt::format("; texels {}", texels->resolution) + identityOf(texels->camera);
    if (const auto& map = rough.shadows) {
        text += fmt::format("; shadows {} {}", map->resolution, map->taps);
        for (const ShadowTexels::Cascade& c : map->cascades)
            text += fmt::format(" {},{} {},{} {}", c.rect.x, c.rect.y, c.rect.z, c.rect.w, c.bias);
    }
    return text;
}

} // namespace

std::string sceneIdentity(const Scene& scene, const WaterBody& body)
{
    return fmt::format("geometry {}; materials {}; textures {}; sky {}; sun {}; lights {}; water {}; waves {}",
                       geometryOf(scene).hash(), materialsOf(scene).hash(), texturesOf(scene).hash(),
                       skyOf(scene).hash(), sunOf(scene).hash(), lightsOf(scene).hash(), waterOf(body).hash(),
                       wavesOf(scene, body).hash());
}

std::string viewIdentity(const ViewRequest& view, const ReferenceOptions& options, float sunSlopeDeviation)
{
    const Camera& c = view.camera;
    const auto triple = [](const vec3& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); };
    std::string text =
        fmt::format("; eye {}; target {}; up {}; fov {}; time {}; {}x{}; depth {}; bounces {}; photons {}; "
                    "seed {}; grid {}{}; flat {}; slope deviation {}",
                    triple(c.eye), triple(c.target), triple(c.up), c.verticalFov, view.time, view.size.x, view.size.y,
                    options.depth, options.bounces, options.photons, options.seed, view.gridSize,
                    view.gridSize > 0 && view.gridFocused ? " focused" : "", view.flatLight, sunSlopeDeviation);
    if (c.lensShift != 0.0f) text += fmt::format("; lens shift {}", c.lensShift);
    if (view.normalGridSize > 0) text += fmt::format("; normals of grid {}", view.normalGridSize);
    if (const auto& map = view.causticsTexture)
        text += fmt::format("; caustics {},{} {},{} by {} filter {}", map->rect.x, map->rect.y, map->rect.z,
                            map->rect.w, map->texel, map->filter);
    return text + identityOf(view.approximations);
}

std::string sceneDifference(const std::string& a, const std::string& b)
{
    const std::vector<std::string_view> first = partsOf(a), second = partsOf(b);
    std::vector<std::string> names;
    for (const std::string_view part : first) {
        const bool isThere = std::find(second.begin(), second.end(), part) != second.end();
        if (!isThere) names.push_back("the " + std::string(nameOf(part)));
    }
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    return text;
}

} // namespace tarn::reference
