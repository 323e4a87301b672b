#include "app/viewer/stereo_view.h"

#include <fmt/format.h>

namespace tarn {

StereoOptions::Output nextStereo(StereoOptions::Output output)
{
    switch (output) {
    case StereoOptions::Output::off: return StereoOptions::Output::sideBySide;
    case StereoOptions::Output::sideBySide:
    case StereoOptions::Output::pair: return StereoOptions::Output::anaglyph;
    case StereoOptions::Output::anaglyph: break;
    }
    return StereoOptions::Output::off;
}

std::string stereoText(const StereoOptions& options)
{
    if (!options.isOn()) return "";
    const bool anaglyph = options.output == StereoOptions::Output::anaglyph;
    return fmt::format("stereo: {}, eyes {:g} m apart, converging at {:g} m", anaglyph ? "anaglyph" : "side by side",
                       options.separation, options.convergence);
}

} // namespace tarn
