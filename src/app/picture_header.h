// What the header of a picture says about how it was made.
#pragma once

#include "app/scene_setup.h"
#include "scene/camera.h"

#include <map>
#include <string>

namespace tarn {

/// "tarn:version", "tarn:scene", "tarn:camera" (JSON: name, eye, target, up, vertical_fov_degrees, and lens_shift where
/// it is not 0), "tarn:time" and "tarn:settings" (JSON of every option).
std::map<std::string, std::string> pictureHeader(const SceneSetup& sceneSetup, const Camera& camera, double time);

} // namespace tarn
