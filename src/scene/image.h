// Pictures in memory, read and written by OpenImageIO. The only face that Tarn has to it.
#pragma once

#include "base/math.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace tarn {

/// Rows run from top to bottom. Either `bytes` (8 bit) or `floats` holds width*height*channels values.
struct Image {
    std::string name; ///< where it came from, for messages and labels
    int width = 0, height = 0, channels = 0;
    std::vector<std::uint8_t> bytes;
    std::vector<float> floats;

    bool isFloat() const { return !floats.empty(); }
    std::size_t size() const { return static_cast<std::size_t>(width) * height * channels; }
};

/// IEC 61966-2-1, from a stored value in 0..1.
float srgbDecode(float encoded);

/// Reads any picture that OpenImageIO knows. 8-bit files give bytes with 1, 3 or 4 channels, as stored
/// (palettes resolved, grey with alpha spread to 4, alpha not multiplied in); deeper
/// files (EXR, HDR, 16-bit PNG) give floats. Throws Error naming the file when it is missing, damaged or 0x0.
Image readImage(const std::filesystem::path& file);

/// A picture with more to it than colour: every channel as floats, their names, and the header's text attributes.
struct NamedImage {
    Image image;
    std::vector<std::string> channelNames;
    std::map<std::string, std::string> metadata;
};

/// All channels of a file, 8-bit ones as 0 to 1 without decoding. Throws as readImage does.
NamedImage readNamedImage(const std::filesystem::path& file);

/// Writes by extension: .png (bytes, or floats that are sRGB-encoded here), .exr (floats, linear), .jpg.
/// The file appears whole or not at all. `metadata` goes into the header. `channelNames` may name EXR channels.
void writeImage(const std::filesystem::path& file, const Image& image,
                const std::map<std::string, std::string>& metadata = {},
                const std::vector<std::string>& channelNames = {});

} // namespace tarn
