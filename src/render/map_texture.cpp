#include "render/map_texture.h"

namespace tarn {

gl::Texture mapColour(const HeightMapPicture& picture, std::size_t colour, const char* label)
{
    gl::Texture texture({.format = gl::Format::rgba16f, .size = ivec2(picture.resolution), .mipmaps = true}, label);
    texture.upload(picture.colours.at(colour), 3);
    texture.generateMipmaps();
    return texture;
}

std::vector<float> readMapColour(const gl::Texture& texture)
{
    const std::vector<float> texels = texture.readBack();
    const auto channels = static_cast<std::size_t>(gl::channelCount(texture.format()));
    std::vector<float> colours;
    for (std::size_t i = 0; i < texels.size(); i += channels) colours.insert(colours.end(), &texels[i], &texels[i] + 3);
    return colours;
}

} // namespace tarn
