#include "render/read_back.h"

namespace tarn {

namespace {

/// OpenGL's first row is the lowest; a picture's is the highest. Keeps the first `channels` of four.
template <typename T> std::vector<T> topDown(const std::vector<T>& rgba, ivec2 size, int channels)
{
    std::vector<T> result;
    result.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                   static_cast<std::size_t>(channels));
    for (int y = size.y - 1; y >= 0; --y) {
        for (int x = 0; x < size.x; ++x) {
            const std::size_t pixel =
                (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x)) * 4;
            for (int c = 0; c < channels; ++c) result.push_back(rgba[pixel + static_cast<std::size_t>(c)]);
        }
    }
    return result;
}

Image emptyImage(ivec2 size, int channels)
{
    Image image;
    image.name = "frame";
    image.width = size.x;
    image.height = size.y;
    image.channels = channels;
    return image;
}

} // namespace

Image readBytes(const gl::Framebuffer& framebuffer)
{
    Image image = emptyImage(framebuffer.size(), 3);
    image.bytes = topDown(framebuffer.readBytes(), framebuffer.size(), 3);
    return image;
}

Image readFloats(const gl::Framebuffer& framebuffer)
{
    Image image = emptyImage(framebuffer.size(), 4);
    image.floats = topDown(framebuffer.readFloats(), framebuffer.size(), 4);
    return image;
}

} // namespace tarn
