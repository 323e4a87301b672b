// How the window shows two eyes' pictures.
#pragma once

#include "plan/options.h"

#include <string>

namespace tarn {

/// What key O goes on to: off, side by side, anaglyph. Two files are for tarn render; in a window they lie side by
/// side.
StereoOptions::Output nextStereo(StereoOptions::Output output);

/// For the figures' corner; "" for one eye.
std::string stereoText(const StereoOptions& options);

} // namespace tarn
