// Bilinear lookups in the scene's pictures, as OpenGL's GL_LINEAR with GL_REPEAT at the finest level.
#pragma once

#include "scene/image.h"

namespace tarn::reference {

enum class Encoding { linear, srgb };

/// The channels that a picture lacks: grey is spread to red, green and blue, and alpha is 1.
/// @param uv v upward, as in OBJ; sRGB is decoded before it is mixed, as the GPU does
vec4 sampleTexture(const Image& image, vec2 uv, Encoding encoding);

} // namespace tarn::reference
