// Colours of a map of heights between its picture and its texture.
#pragma once

#include "gl/texture.h"
#include "scene/map_picture.h"

namespace tarn {

/// As a pass would draw it: rgba16f, with mipmaps.
gl::Texture mapColour(const HeightMapPicture& picture, std::size_t colour, const char* label);

/// Three floats a texel. Waits for the GPU.
std::vector<float> readMapColour(const gl::Texture& texture);

} // namespace tarn
