// What OpenGL calls the formats. For the .cpp files of this folder.
#pragma once

#include "gl/api.h"
#include "gl/format.h"

namespace tarn::gl {

/// GL_RGBA16F
GLenum internalFormat(Format format);
/// GL_RED, GL_RG, GL_RGB or GL_RGBA for 1 to 4 values per texel, GL_DEPTH_COMPONENT for depth.
GLenum pixelFormat(Format format, int channels);

} // namespace tarn::gl
