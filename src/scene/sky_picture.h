// A sky given as a picture: latitude-longitude or cube map, told apart by its shape. Private to src/scene.
//
// Every layout is seen from inside, unmirrored: the middle of a latitude-longitude picture, the centre of a
// cross and the fifth face of a strip lie along -z; what is to their right lies along +x.
#pragma once

#include "scene/image.h"

namespace tarn {

enum class SkyLayout { latLong, crossWide, crossTall, stripWide, stripTall };

/// 2:1 latitude-longitude, 4:3 or 3:4 cross, 6:1 or 1:6 strip (right, left, top, bottom, front, back).
/// Throws Error for any other shape.
SkyLayout skyLayout(const Image& image);

/// Three float channels, linear, finite and not negative.
Image linearPicture(const Image& image);

/// Bilinear. `image` from linearPicture, `direction` unit.
vec3 samplePicture(const Image& image, const vec3& direction);

} // namespace tarn
