#include "gl/texture.h"

#include "base/error.h"
#include "gl/context.h"
#include "gl/counters.h"
#include "gl/format_gl.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace tarn::gl {

namespace {

/// Textures are edited through a unit that no sampler uses (Program keeps below it), so that the bindings a
/// pass has made stay.
constexpr int editUnit = 16;

GLenum bindTarget(const TextureDesc& desc)
{
    if (desc.samples > 1) return GL_TEXTURE_2D_MULTISAMPLE;
    if (desc.kind == TextureKind::array) return GL_TEXTURE_2D_ARRAY;
    return desc.kind == TextureKind::cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D;
}

GLenum imageTarget(const TextureDesc& desc, int face)
{
    return desc.kind == TextureKind::cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face) : GL_TEXTURE_2D;
}

GLint wrapMode(Wrap wrap)
{
    constexpr std::array<GLint, 4> modes = {GL_CLAMP_TO_EDGE, GL_REPEAT, GL_MIRRORED_REPEAT, GL_CLAMP_TO_BORDER};
    return modes[static_cast<std::size_t>(wrap)];
}

/// Throws when OpenGL would only answer with an error code.
void check(const TextureDesc& d, const std::string& label)
{
    const auto fail = [&](const std::string& reason) {
        throw Error("texture \"{}\" ({} {}x{}): {}", label, formatName(d.format), d.size.x, d.size.y, reason);
    };
    const int limit = capabilities().maxTextureSize;
    if (d.size.x < 1 || d.size.y < 1) fail("it has no pixels");
    if (d.size.x > limit || d.size.y > limit) fail(fmt::format("this driver takes at most {0}x{0}", limit));
    if (d.kind == TextureKind::cube && d.size.x != d.size.y) fail("the faces of a cube must be square");
    if (d.samples < 1 || d.samples > capabilities().maxSamples) {
        fail(fmt::format("{} samples, but this driver takes 1 to {}", d.samples, capabilities().maxSamples));
    }
    if (d.samples > 1 && d.kind != TextureKind::flat) fail("neither a cube nor an array can be multisampled");
    if (d.kind == TextureKind::array ? d.layers < 1 : d.layers != 1)
        fail(fmt::format("{} layers: an array has at least one, anything else is one", d.layers));
    if (d.layers > capabilities().maxArrayLayers)
        fail(fmt::format("{} layers, but this driver takes at most {}", d.layers, capabilities().maxArrayLayers));
    if (d.samples > 1 && d.mipmaps) fail("a multisampled texture has no mipmaps");
    if (d.compare && !isDepth(d.format)) fail("only depth can be compared");
}

} // namespace

Texture::Texture(const TextureDesc& desc, std::string label) : desc_(desc)
{
    check(desc, label);
    object_ = Object(Object::Kind::texture, std::move(label));
    bind(editUnit);
    object_.announceLabel();
    allocate();
    if (desc_.samples == 1) setParameters();
}

void Texture::allocate()
{
    const auto internal = static_cast<GLint>(internalFormat(desc_.format));
    if (desc_.samples > 1) {
        glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, desc_.samples, internalFormat(desc_.format), desc_.size.x,
                                desc_.size.y, GL_TRUE);
        return;
    }
    for (int level = 0; level < levels(); ++level) {
        const ivec2 size = levelSize(level);
        if (desc_.kind == TextureKind::array) {
            glTexImage3D(GL_TEXTURE_2D_ARRAY, level, internal, size.x, size.y, desc_.layers, 0,
                         pixelFormat(desc_.format, 4), GL_FLOAT, nullptr);
            continue;
        }
        for (int face = 0; face < faces(); ++face) {
            glTexImage2D(imageTarget(desc_, face), level, internal, size.x, size.y, 0, pixelFormat(desc_.format, 4),
                         GL_FLOAT, nullptr);
        }
    }
}

void Texture::setParameters()
{
    const GLenum target = bindTarget(desc_);
    const bool linear = desc_.filter == Filter::linear;
    const GLint magnify = linear ? GL_LINEAR : GL_NEAREST;
    const GLint mipmapped = linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_NEAREST;
    glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, levels() - 1);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, magnify);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, desc_.mipmaps ? mipmapped : magnify);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
        glTexParameteri(target, axis, wrapMode(desc_.wrap));
    }
    glTexParameterfv(target, GL_TEXTURE_BORDER_COLOR, &desc_.border.x);
    if (desc_.compare) {
        glTexParameteri(target, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        glTexParameteri(target, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    }
    setAnisotropy(desc_.anisotropy);
}

void Texture::setAnisotropy(float anisotropy)
{
    desc_.anisotropy = anisotropy;
    if (capabilities().maxAnisotropy <= 1.0f || desc_.samples > 1) return;
    bind(editUnit);
    glTexParameterf(bindTarget(desc_), GL_TEXTURE_MAX_ANISOTROPY_EXT,
                    std::clamp(anisotropy, 1.0f, capabilities().maxAnisotropy));
}

void Texture::upload(std::span<const std::uint8_t> values, int channels, int face, int level)
{
    uploadLevel(values.data(), values.size(), GL_UNSIGNED_BYTE, channels, face, level);
}

void Texture::upload(std::span<const float> values, int channels, int face, int level)
{
    uploadLevel(values.data(), values.size(), GL_FLOAT, channels, face, level);
}

void Texture::uploadLevel(const void* values, std::size_t count, unsigned type, int channels, int face, int level)
{
    if (channels == 0) channels = channelCount(desc_.format);
    if (desc_.samples > 1 || face < 0 || face >= faces() || level < 0 || level >= levels() || channels < 1 ||
        channels > 4) {
        throw Error("texture \"{}\": nothing can be uploaded to face {}, level {} with {} channels", label(), face,
                    level, channels);
    }
    const ivec2 size = levelSize(level);
    const auto expected =
        static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * static_cast<std::size_t>(channels);
    if (count != expected) {
        throw Error("texture \"{}\": {} values for {}x{} texels with {} channels, {} expected", label(), count, size.x,
                    size.y, channels, expected);
    }
    bind(editUnit);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const GLenum format = pixelFormat(desc_.format, channels);
    if (desc_.kind == TextureKind::array)
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, level, 0, 0, face, size.x, size.y, 1, format, type, values);
    else
        glTexSubImage2D(imageTarget(desc_, face), level, 0, 0, size.x, size.y, format, type, values);
}

void Texture::generateMipmaps()
{
    if (!desc_.mipmaps) return;
    bind(editUnit);
    glGenerateMipmap(bindTarget(desc_));
}

std::vector<float> Texture::readBack(int face, int level) const
{
    if (desc_.samples > 1) throw Error("texture \"{}\" is multisampled and cannot be read back", label());
    if (face < 0 || face >= faces() || level < 0 || level >= levels())
        throw Error("texture \"{}\" has no face {} of level {} to be read back", label(), face, level);
    const ivec2 size = levelSize(level);
    const int channels = channelCount(desc_.format);
    const auto perFace = static_cast<std::ptrdiff_t>(size.x) * size.y * channels;
    const bool isArray = desc_.kind == TextureKind::array; // OpenGL 3.3 gives all of its layers or none
    std::vector<float> values(static_cast<std::size_t>(isArray ? desc_.layers * perFace : perFace));
    bind(editUnit);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    gl::count(Call::readBack);
    glGetTexImage(isArray ? GL_TEXTURE_2D_ARRAY : imageTarget(desc_, face), level, pixelFormat(desc_.format, channels),
                  GL_FLOAT, values.data());
    if (!isArray) return values;
    return {values.begin() + face * perFace, values.begin() + (face + 1) * perFace};
}

void Texture::bind(int unit) const
{
    count(Call::textureBind);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(bindTarget(desc_), object_.name());
}

ivec2 Texture::levelSize(int level) const { return glm::max(ivec2(desc_.size.x >> level, desc_.size.y >> level), 1); }

int Texture::faces() const { return desc_.kind == TextureKind::cube ? 6 : desc_.layers; }

int Texture::levels() const
{
    if (!desc_.mipmaps) return 1;
    return static_cast<int>(std::bit_width(static_cast<unsigned>(std::max(desc_.size.x, desc_.size.y))));
}

} // namespace tarn::gl
