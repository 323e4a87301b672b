// A target's picture, brought to the processor.
#pragma once

#include "gl/framebuffer.h"
#include "scene/image.h"

namespace tarn {

/// 8-bit, three channels. Both wait for the GPU.
Image readBytes(const gl::Framebuffer& framebuffer);

/// Four floats a pixel.
Image readFloats(const gl::Framebuffer& framebuffer);

} // namespace tarn
