#include "gl/format.h"

#include "gl/format_gl.h"

#include <array>

namespace tarn::gl {

namespace {

struct FormatInfo {
    const char* name;
    int channels;
    GLenum internal;
};

// In the order of the enumeration.
constexpr std::array<FormatInfo, 14> infos = {{
    {"r8", 1, GL_R8},
    {"rg8", 2, GL_RG8},
    {"rgba8", 4, GL_RGBA8},
    {"srgb8a8", 4, GL_SRGB8_ALPHA8},
    {"r16f", 1, GL_R16F},
    {"rg16f", 2, GL_RG16F},
    {"rgba16f", 4, GL_RGBA16F},
    {"r11g11b10f", 3, GL_R11F_G11F_B10F},
    {"r32f", 1, GL_R32F},
    {"rg32f", 2, GL_RG32F},
    {"rgba32f", 4, GL_RGBA32F},
    {"depth16", 1, GL_DEPTH_COMPONENT16},
    {"depth24", 1, GL_DEPTH_COMPONENT24},
    {"depth32f", 1, GL_DEPTH_COMPONENT32F},
}};
static_assert(infos.size() == static_cast<std::size_t>(Format::depth32f) + 1);

const FormatInfo& info(Format format) { return infos[static_cast<std::size_t>(format)]; }

} // namespace

const char* formatName(Format format) { return info(format).name; }

int channelCount(Format format) { return info(format).channels; }

bool isDepth(Format format)
{
    return format == Format::depth16 || format == Format::depth24 || format == Format::depth32f;
}

GLenum internalFormat(Format format) { return info(format).internal; }

GLenum pixelFormat(Format format, int channels)
{
    if (isDepth(format)) return GL_DEPTH_COMPONENT;
    constexpr std::array<GLenum, 4> byCount = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
    return byCount[static_cast<std::size_t>(channels - 1)];
}

} // namespace tarn::gl
