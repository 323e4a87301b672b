// Pictures for tarn compare: 8-bit ones as they are, linear ones as they would be shown.
#pragma once

#include "app/command_line.h"
#include "plan/options.h"
#include "scene/image.h"

#include <nlohmann/json_fwd.hpp>

namespace tarn {

/// A picture as its file holds it.
struct ComparedPicture {
    std::filesystem::path file;
    Image image; ///< 8-bit sRGB, or linear floats of red, green and blue
    bool isLinear = false;
    std::string settings; ///< a linear picture's "tarn:settings", or ""
};

/// By its extension.
bool isLinearFile(const std::filesystem::path& file);

/// Throws Error when it is missing, damaged, deeper than 8 bits without being linear, or holds NaN.
ComparedPicture readComparedPicture(const std::filesystem::path& file);

/// How linear pictures are shown, and where that was said.
struct Showing {
    FrameOptions frame;
    std::string exposureOrigin = "default", toneCurveOrigin = "default";
};

/// Command line, else the reference's header, else the test's, else the defaults.
Showing chooseShowing(const CompareCommand& command, const ComparedPicture& reference, const ComparedPicture& test);

/// The picture times the exposure where it is linear.
Image exposed(const ComparedPicture& picture, const Showing& showing);

/// The 8-bit sRGB picture of what exposed() returned.
Image shown(const ComparedPicture& picture, const Image& exposed, const Showing& showing);

/// The "frame" options as JSON.
nlohmann::json frameJson(const FrameOptions& frame);

} // namespace tarn
