#include "plan/stereo.h"

namespace tarn {

namespace {

bool isBeside(StereoOptions::Output output)
{
    return output == StereoOptions::Output::sideBySide || output == StereoOptions::Output::pair;
}

} // namespace

Camera eyeCamera(const Camera& camera, const StereoOptions& options, Eye eye)
{
    const float offset = 0.5f * options.separation;
    return movedAside(camera, eye == Eye::left ? -offset : offset, options.convergence);
}

ivec2 presentedSize(ivec2 eye, StereoOptions::Output output)
{
    return isBeside(output) ? ivec2(2 * eye.x, eye.y) : eye;
}

ivec2 eyeSizeFor(ivec2 window, StereoOptions::Output output)
{
    return glm::max(isBeside(output) ? ivec2(window.x / 2, window.y) : window, ivec2(1));
}

} // namespace tarn
