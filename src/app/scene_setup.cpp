#include "app/scene_setup.h"

#include "app/presets.h"
#include "base/error.h"
#include "base/files.h"
#include "base/log.h"
#include "gl/context.h"
#include "scene/scene_file.h"

namespace tarn {

void choosePreset(SettingsArguments& settings, const gl::Context& context)
{
    if (settings.preset != "auto") return;
    const MachinePreset chosen = presetForMachine(context.renderer(), context.isSoftware());
    settings.preset = chosen.name;
    log::info("--preset auto: {}", chosen.why);
}

SceneSetup loadSceneSetup(const SceneArguments& arguments, Progress* progress)
{
    const std::filesystem::path file =
        arguments.file.empty() ? projectRoot() / "assets" / "lake" / "lake.toml" : arguments.file;
    SceneSetup sceneSetup;
    sceneSetup.scene = loadScene(file, {arguments.waterLevel, progress});
    SettingsArguments settings = arguments.settings;
    if (settings.preset == "auto") choosePreset(settings, *gl::makeHeadlessContext({1, 1}));
    sceneSetup.settings = resolveSettings(sceneSetup.scene, settings);
    return sceneSetup;
}

Camera namedCamera(const Scene& scene, const std::string& name, const char* flag)
{
    if (name.empty()) return scene.cameras.empty() ? Camera{} : scene.cameras.front();
    if (const Camera* camera = scene.findCamera(name)) return *camera;
    std::vector<std::string> names;
    for (const Camera& camera : scene.cameras) names.push_back(camera.name);
    const std::string near = nearestName(name, names);
    if (!near.empty()) throw UsageError("{} {}: no such camera in the scene, did you mean {}?", flag, name, near);
    throw UsageError("{} {}: no such camera in the scene; it has {}", flag, name, fmt::join(names, ", "));
}

Camera chooseCamera(const Scene& scene, const CameraArguments& arguments)
{
    Camera camera = namedCamera(scene, arguments.name, "--camera");
    if (arguments.eye) camera.eye = *arguments.eye;
    if (arguments.target) camera.target = *arguments.target;
    if (arguments.up) camera.up = *arguments.up;
    if (arguments.verticalFov) camera.verticalFov = *arguments.verticalFov;

    const vec3 forward = camera.target - camera.eye;
    if (glm::length(forward) < 1e-6f) throw UsageError("--eye and --target are the same point; give two");
    const vec3 side = glm::cross(glm::normalize(forward), camera.up);
    if (!(glm::length(side) > 1e-4f * glm::length(camera.up)))
        throw UsageError("the camera looks along its own up direction; give another --up, such as --up 0,0,-1");
    return camera;
}

} // namespace tarn
