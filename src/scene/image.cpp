#include "scene/image.h"

#include "base/error.h"
#include "base/files.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <system_error>

namespace tarn {

namespace {

constexpr int largestSide = 16384;

/// OpenImageIO's reasons may span lines; ours are one.
std::string oneLine(std::string text)
{
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text.empty() ? "unknown reason" : text;
}

void checkIsFile(const std::filesystem::path& file)
{
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) throw Error("{}: no such picture; check the path", file.string());
    if (std::filesystem::is_directory(status)) throw Error("{}: is a directory, not a picture", file.string());
}

/// Grey with alpha becomes RGBA, so that an alpha channel is always the fourth.
template <typename T> std::vector<T> greyAlphaToRgba(const std::vector<T>& values)
{
    std::vector<T> result;
    result.reserve(values.size() * 2);
    for (std::size_t i = 0; i + 1 < values.size(); i += 2)
        result.insert(result.end(), {values[i], values[i], values[i], values[i + 1]});
    return result;
}

/// Our pictures hold colour as it is, not multiplied by alpha; OpenImageIO would multiply on reading.
OIIO::ImageSpec readerHints()
{
    OIIO::ImageSpec hints;
    hints.attribute("oiio:UnassociatedAlpha", 1);
    return hints;
}

template <typename T>
void readPixels(OIIO::ImageInput& input, OIIO::TypeDesc type, Image& image, std::vector<T>& values)
{
    values.resize(image.size());
    if (!input.read_image(0, 0, 0, image.channels, type, values.data()))
        throw Error("{}: the picture is damaged ({})", image.name, oneLine(input.geterror()));
    if (image.channels != 2) return;
    values = greyAlphaToRgba(values);
    image.channels = 4;
}

// IEC 61966-2-1.
float srgbEncode(float linear)
{
    const float x = std::clamp(linear, 0.0f, 1.0f);
    return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
}

/// Floats as 8-bit sRGB; an alpha channel stays linear.
std::vector<std::uint8_t> toBytes(const Image& image)
{
    std::vector<std::uint8_t> bytes(image.floats.size());
    const auto channels = static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const bool isAlpha = (channels == 2 || channels == 4) && i % channels == channels - 1;
        const float value = image.floats[i];
        const float encoded = isAlpha ? std::clamp(value, 0.0f, 1.0f) : srgbEncode(std::isnan(value) ? 0.0f : value);
        bytes[i] = static_cast<std::uint8_t>(std::lround(encoded * 255.0f));
    }
    return bytes;
}

/// 8-bit sRGB as linear floats.
std::vector<float> toFloats(const Image& image)
{
    std::vector<float> floats(image.bytes.size());
    const auto channels = static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0; i < floats.size(); ++i) {
        const bool isAlpha = channels == 4 && i % channels == 3;
        const float value = static_cast<float>(image.bytes[i]) / 255.0f;
        floats[i] = isAlpha ? value : srgbDecode(value);
    }
    return floats;
}

OIIO::ImageSpec specOf(const Image& image, bool asFloat, const std::map<std::string, std::string>& metadata,
                       const std::vector<std::string>& channelNames)
{
    OIIO::ImageSpec spec(image.width, image.height, image.channels,
                         asFloat ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
    if (!channelNames.empty()) spec.channelnames = channelNames;
    spec.attribute("oiio:ColorSpace", asFloat ? "linear" : "sRGB");
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.attribute("CompressionQuality", 95);
    if (asFloat) spec.attribute("compression", "zip");
    for (const auto& [key, value] : metadata) spec.attribute(key, value);
    return spec;
}

void writePixels(const std::filesystem::path& temporary, const std::filesystem::path& file, const Image& image,
                 const std::map<std::string, std::string>& metadata, const std::vector<std::string>& channelNames)
{
    const auto output = OIIO::ImageOutput::create(temporary.string());
    if (!output)
        throw Error("{}: pictures of that kind cannot be written ({}); use .png, .exr or .jpg", file.string(),
                    oneLine(OIIO::geterror()));
    const auto extension = temporary.extension();
    const bool asFloat = extension == ".exr" || extension == ".hdr";
    const OIIO::ImageSpec spec = specOf(image, asFloat, metadata, channelNames);
    std::vector<std::uint8_t> encoded;
    std::vector<float> linear;
    const void* data = asFloat ? static_cast<const void*>(image.floats.data()) : image.bytes.data();
    if (asFloat && !image.isFloat()) data = (linear = toFloats(image)).data();
    if (!asFloat && image.isFloat()) data = (encoded = toBytes(image)).data();
    const auto type = asFloat ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
    if (!output->open(temporary.string(), spec) || !output->write_image(type, data) || !output->close())
        throw Error("{}: cannot be written ({})", file.string(), oneLine(output->geterror()));
}

/// OpenImageIO's PNG writer does not notice a full disk: what was written is read back before it takes its place.
void requireWhole(const std::filesystem::path& temporary, const std::filesystem::path& file)
{
    const auto isWhole = [&] {
        // Looked at first because libpng prints a line of its own about a file that ends too early.
        if (temporary.extension() == ".png" && readFile(temporary).find("IEND") == std::string::npos) return false;
        try {
            readImage(temporary);
        } catch (const Error&) {
            return false;
        }
        return true;
    };
    if (!isWhole()) throw Error("{}: cannot be written whole; is the disk full?", file.string());
}

} // namespace

float srgbDecode(float encoded)
{
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

namespace {

/// Opened, and of a shape that can be read.
std::unique_ptr<OIIO::ImageInput> openPicture(const std::filesystem::path& file)
{
    checkIsFile(file);
    const OIIO::ImageSpec hints = readerHints();
    auto input = OIIO::ImageInput::open(file.string(), &hints);
    if (!input) throw Error("{}: not a readable picture ({})", file.string(), oneLine(OIIO::geterror()));

    const OIIO::ImageSpec& spec = input->spec();
    if (spec.width <= 0 || spec.height <= 0) throw Error("{}: the picture is empty (0x0)", file.string());
    if (spec.width > largestSide || spec.height > largestSide)
        throw Error("{}: {}x{} pixels are more than {} a side; make it smaller", file.string(), spec.width, spec.height,
                    largestSide);
    if (spec.nchannels < 1) throw Error("{}: the picture has no channels", file.string());
    return input;
}

Image emptyPicture(const std::filesystem::path& file, const OIIO::ImageSpec& spec, int channels)
{
    Image image;
    image.name = file.string();
    image.width = spec.width;
    image.height = spec.height;
    image.channels = channels;
    return image;
}

} // namespace

Image readImage(const std::filesystem::path& file)
{
    const auto input = openPicture(file);
    const OIIO::ImageSpec& spec = input->spec();
    Image image = emptyPicture(file, spec, std::min(spec.nchannels, 4));
    if (spec.format == OIIO::TypeDesc::UINT8) {
        readPixels(*input, OIIO::TypeDesc::UINT8, image, image.bytes);
    } else {
        readPixels(*input, OIIO::TypeDesc::FLOAT, image, image.floats);
    }
    return image;
}

NamedImage readNamedImage(const std::filesystem::path& file)
{
    const auto input = openPicture(file);
    const OIIO::ImageSpec& spec = input->spec();
    NamedImage result{emptyPicture(file, spec, spec.nchannels), spec.channelnames, {}};
    Image& image = result.image;
    image.floats.resize(image.size());
    if (!input->read_image(0, 0, 0, image.channels, OIIO::TypeDesc::FLOAT, image.floats.data()))
        throw Error("{}: the picture is damaged ({})", image.name, oneLine(input->geterror()));
    for (const auto& attribute : spec.extra_attribs)
        if (attribute.type() == OIIO::TypeDesc::STRING)
            result.metadata[attribute.name().string()] = attribute.get_string();
    return result;
}

void writeImage(const std::filesystem::path& file, const Image& image,
                const std::map<std::string, std::string>& metadata, const std::vector<std::string>& channelNames)
{
    const std::size_t count = image.isFloat() ? image.floats.size() : image.bytes.size();
    if (count == 0 || count != image.size()) throw Error("{}: cannot be written, the picture is empty", file.string());
    writeWhole(file, [&](const std::filesystem::path& temporary) {
        writePixels(temporary, file, image, metadata, channelNames);
        requireWhole(temporary, file);
    });
}

} // namespace tarn
