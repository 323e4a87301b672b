#include "render/fresnel_texture.h"

#include "optics/fresnel_table.h"

#include <vector>

namespace tarn {

const gl::Texture& FresnelTexture::of(float ior, const WaterOptions& options)
{
    if (texture_ && ior == ior_ && options.fresnelTable == size_ && options.fresnelFilter == filter_) return texture_;
    ior_ = ior;
    size_ = options.fresnelTable;
    filter_ = options.fresnelFilter;
    std::vector<float> values;
    for (const vec2& texel : optics::makeFresnelTable(ior, size_, filter_).texels)
        values.insert(values.end(), {texel.x, texel.y});
    const bool blends = filter_ == optics::TableFilter::linear;
    texture_ = gl::Texture(
        {.format = gl::Format::rg32f, .size = {size_, 1}, .filter = blends ? gl::Filter::linear : gl::Filter::nearest},
        "Fresnel table");
    texture_.upload(std::span<const float>(values), 2);
    return texture_;
}

} // namespace tarn
