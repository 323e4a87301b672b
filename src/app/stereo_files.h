// The two files of stereo.output = pair.
#pragma once

#include "plan/stereo.h"
#include "scene/image.h"

#include <filesystem>

namespace tarn {

/// "lake.png" for the left eye is "lake-left.png".
std::filesystem::path eyeFile(const std::filesystem::path& file, Eye eye);

/// One eye's half of a picture that shows the left eye's on the left of the right one's.
Image eyeHalf(const Image& both, Eye eye);

} // namespace tarn
