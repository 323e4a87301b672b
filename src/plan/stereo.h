// Two eyes in place of one (after Lipp, who draws every frame for a left and a right camera).
//
//     const Camera left = eyeCamera(head, options.stereo, Eye::left);
#pragma once

#include "plan/options.h"
#include "scene/camera.h"

#include <array>

namespace tarn {

enum class Eye { left, right };
inline constexpr std::array bothEyes{Eye::left, Eye::right};
inline constexpr std::array eyeNames{"left", "right"};
inline const char* eyeName(Eye eye) { return eyeNames[static_cast<std::size_t>(eye)]; }

/// Half the eyes' distance to the left or right of the camera; both axes parallel to its own, both pictures sheared so
/// that they agree on the plane at the convergence distance.
Camera eyeCamera(const Camera& camera, const StereoOptions& options, Eye eye);

/// Of what a frame presents, pixels; eye: the size of one eye's picture.
ivec2 presentedSize(ivec2 eye, StereoOptions::Output output);

/// Of one eye's picture, so that what is presented fills a window; at least 1x1.
ivec2 eyeSizeFor(ivec2 window, StereoOptions::Output output);

} // namespace tarn
