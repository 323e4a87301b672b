// The table of water.fresnel = table as a texture.
#pragma once

#include "gl/texture.h"
#include "plan/options.h"

namespace tarn {

class FresnelTexture {
public:
    /// RG: transmittance and reflectance over the cosine, optics/fresnel_table.h. Made anew when something changed.
    const gl::Texture& of(float ior, const WaterOptions& options);

private:
    gl::Texture texture_;
    float ior_ = 0.0f;
    int size_ = 0;
    optics::TableFilter filter_ = optics::TableFilter::nearest;
};

} // namespace tarn
