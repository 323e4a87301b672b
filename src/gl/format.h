// The pixel formats that Tarn uses.
#pragma once

namespace tarn::gl {

enum class Format {
    r8,
    rg8,
    rgba8,
    srgb8a8, ///< colour that is decoded to linear when read; alpha stays linear
    r16f,
    rg16f,
    rgba16f,
    r11g11b10f, ///< unsigned: for colour that is never negative
    r32f,
    rg32f,
    rgba32f,
    depth16,
    depth24,
    depth32f,
};

/// "rgba16f"
const char* formatName(Format format);
/// 1 to 4; 1 for depth.
int channelCount(Format format);
bool isDepth(Format format);

} // namespace tarn::gl
