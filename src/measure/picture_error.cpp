#include "measure/picture_error.h"

#include "base/error.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <array>
#include <cmath>
#include <limits>

namespace tarn {

namespace {

constexpr int colours = 3; // channels compared: alpha is not light

/// A view of the picture's own memory, only read through.
OIIO::ImageBuf viewOf(const Image& image)
{
    const auto type = image.isFloat() ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
    const void* values = image.isFloat() ? static_cast<const void*>(image.floats.data()) : image.bytes.data();
    return {OIIO::ImageSpec(image.width, image.height, image.channels, type), const_cast<void*>(values)};
}

} // namespace

void requireComparable(const Image& reference, const Image& test)
{
    for (const Image* image : {&reference, &test})
        if (image->channels < colours)
            throw Error("{}: has {} channel{}; pictures of red, green and blue are compared", image->name,
                        image->channels, image->channels == 1 ? "" : "s");
    if (reference.width != test.width || reference.height != test.height)
        throw Error("{}: has {}x{} pixels, and {} has {}x{}; only pictures of the same size are compared", test.name,
                    test.width, test.height, reference.name, reference.width, reference.height);
}

void requireFinite(const Image& image)
{
    const auto channels = static_cast<std::size_t>(image.channels), width = static_cast<std::size_t>(image.width);
    for (std::size_t i = 0; i < image.floats.size(); ++i) {
        const std::size_t channel = i % channels, pixel = i / channels;
        if (channel >= colours || std::isfinite(image.floats[i])) continue;
        throw Error("{}: the {} of pixel {},{} is {}; such a picture cannot be compared", image.name,
                    std::array{"red", "green", "blue"}[channel], pixel % width, pixel / width,
                    std::isnan(image.floats[i]) ? "NaN" : "infinite");
    }
}

PictureError pictureError(const Image& reference, const Image& test)
{
    requireComparable(reference, test);
    if (reference.isFloat() != test.isFloat())
        throw Error("{} holds {} and {} {}; both must hold the same", reference.name,
                    reference.isFloat() ? "floats" : "bytes", test.name, test.isFloat() ? "floats" : "bytes");
    requireFinite(reference);
    requireFinite(test);
    const OIIO::ROI all(0, reference.width, 0, reference.height, 0, 1, 0, colours);
    constexpr float never = std::numeric_limits<float>::infinity(); // no difference counts as a failure there
    const auto result = OIIO::ImageBufAlgo::compare(viewOf(reference), viewOf(test), never, never, all);
    if (result.error) throw Error("{}: cannot be compared with {}", test.name, reference.name);
    return {result.meanerror, result.rms_error,           -20.0 * std::log10(result.rms_error),
            result.maxerror,  {result.maxx, result.maxy}, result.maxc};
}

} // namespace tarn
