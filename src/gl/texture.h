// Pictures that shaders read. Rows run from bottom to top, as OpenGL has them.
#pragma once

#include "base/math.h"
#include "gl/format.h"
#include "gl/object.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tarn::gl {

enum class TextureKind { flat, cube, array };
enum class Filter { nearest, linear };
enum class Wrap { clamp, repeat, mirror, border };

struct TextureDesc {
    TextureKind kind = TextureKind::flat;
    Format format = Format::rgba8;
    ivec2 size{1, 1};
    int layers = 1;       ///< of an array; each is drawn into, uploaded and read back as a face
    int samples = 1;      ///< over 1: a sampler2DMS that is drawn into, without filter or mipmaps
    bool mipmaps = false; ///< call generateMipmaps() when the top level is there
    Filter filter = Filter::linear;
    Wrap wrap = Wrap::clamp;
    vec4 border{0.0f};
    float anisotropy = 1.0f; ///< capped by what the driver offers
    bool compare = false;    ///< depth only: a sampler2DShadow that answers "reference <= depth"
    bool operator==(const TextureDesc&) const = default;
};

class Texture {
public:
    Texture() = default;
    /// Throws Error with the label when the size or the combination is impossible.
    Texture(const TextureDesc& desc, std::string label);

    /// Fills a level of a face of a cube, or of a layer of an array, from 8-bit values, `channels` per texel (0: as
    /// many as the format has; missing ones read as 0, alpha as 1). Throws Error when the count does not fit the size.
    void upload(std::span<const std::uint8_t> values, int channels = 0, int face = 0, int level = 0);
    /// The same from floats.
    void upload(std::span<const float> values, int channels = 0, int face = 0, int level = 0);
    void generateMipmaps();
    void setAnisotropy(float anisotropy);

    /// Every texel of a level, channelCount(format) floats each, sRGB values as stored (not decoded). Waits
    /// for the GPU: for tests and measurements.
    std::vector<float> readBack(int face = 0, int level = 0) const;

    /// Makes it the texture of a unit. Programs know units by sampler name: see Program::texture.
    void bind(int unit) const;

    const TextureDesc& desc() const { return desc_; }
    ivec2 size() const { return desc_.size; }
    ivec2 levelSize(int level) const;
    int levels() const;
    /// Pictures of a level: 6 of a cube, the layers of an array, else 1.
    int faces() const;
    Format format() const { return desc_.format; }
    const std::string& label() const { return object_.label(); }
    Name name() const { return object_.name(); }
    explicit operator bool() const { return static_cast<bool>(object_); }

private:
    void allocate();
    void setParameters();
    void uploadLevel(const void* values, std::size_t count, unsigned type, int channels, int face, int level);

    Object object_;
    TextureDesc desc_;
};

} // namespace tarn::gl
