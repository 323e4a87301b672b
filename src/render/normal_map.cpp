#include "render/normal_map.h"

#include "optics/optics.h"

#include <span>
#include <vector>

namespace tarn {

gl::Texture normalMapTexture(const Image& image, float anisotropy)
{
    const auto channels = static_cast<std::size_t>(image.channels);
    const auto width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
    const auto value = [&](std::size_t i) {
        return image.isFloat() ? image.floats[i] : static_cast<float>(image.bytes[i]) / 255.0f;
    };
    std::vector<float> texels;
    texels.reserve(width * height * 4);
    for (std::size_t row = height; row-- > 0;) // OpenGL's first row is the lowest
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t i = (row * width + x) * channels;
            const vec3 n = optics::normalMapNormal(vec3(value(i), value(i + 1), value(i + 2)));
            const vec2 slope = optics::normalMapSlope(n, 1.0f);
            texels.insert(texels.end(), {n.x, n.y, n.z, 0.5f * glm::dot(slope, slope)});
        }
    gl::Texture texture({.format = gl::Format::rgba16f,
                         .size = {image.width, image.height},
                         .mipmaps = true,
                         .wrap = gl::Wrap::repeat,
                         .anisotropy = anisotropy},
                        image.name);
    texture.upload(std::span<const float>(texels), 4);
    texture.generateMipmaps();
    return texture;
}

void NormalMapInputs::set(gl::Program& program) const
{
    program.texture("normalMap", *map);
    program.set("normalMapTile", tile);
    program.set("normalMapBump", bump);
    program.setArray("normalMapOffsets", std::span<const vec2>(offsets));
}

NormalMapInputs normalMapInputs(const WaterBody& water, const gl::Texture* map, double time)
{
    if (!map || !water.normalMap.isSeen()) return {};
    NormalMapInputs inputs{map, water.normalMap.tile, water.normalMap.bump, {}};
    const auto offsets = layerOffsets(water.normalMap, time);
    for (std::size_t i = 0; i < offsets.size(); ++i) inputs.offsets[i] = vec2(offsets[i]);
    return inputs;
}

} // namespace tarn
