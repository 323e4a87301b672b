#include "app/picture_header.h"

#include "app/version.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <vector>

namespace tarn {

std::map<std::string, std::string> pictureHeader(const SceneSetup& sceneSetup, const Camera& camera, double time)
{
    const auto triple = [](const vec3& v) { return std::vector<float>{v.x, v.y, v.z}; };
    nlohmann::json view{{"name", camera.name},
                        {"eye", triple(camera.eye)},
                        {"target", triple(camera.target)},
                        {"up", triple(camera.up)},
                        {"vertical_fov_degrees", glm::degrees(camera.verticalFov)}};
    if (camera.lensShift != 0.0f) view["lens_shift"] = camera.lensShift;
    return {{"tarn:version", versionText()},
            {"tarn:scene", sceneSetup.scene.file.filename().string()},
            {"tarn:camera", view.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)},
            {"tarn:time", fmt::format("{}", time)},
            {"tarn:settings", settingsJson(sceneSetup.settings)}};
}

} // namespace tarn
