// What every command that looks at a scene starts with: the scene, its settings and a camera.
#pragma once

#include "app/command_line.h"
#include "base/progress.h"
#include "scene/scene.h"

namespace tarn {

namespace gl {
class Context;
}

struct SceneSetup {
    Scene scene;
    Settings settings;
};

/// Replaces the preset "auto" by the one for the machine, and says so; any other stays.
void choosePreset(SettingsArguments& settings, const gl::Context& context);

/// Loads the scene that the arguments name (the shipped lake when they name none) and resolves the settings. For the
/// preset "auto" it makes a headless context and asks it what the machine is.
SceneSetup loadSceneSetup(const SceneArguments& arguments, Progress* progress);

/// The scene's first camera when the name is empty. Throws UsageError, with the flag that named it, when the scene has
/// no such camera.
Camera namedCamera(const Scene& scene, const std::string& name, const char* flag);

/// Throws UsageError when the scene has no camera of the name, or when what replaces its parts leaves no
/// view.
Camera chooseCamera(const Scene& scene, const CameraArguments& arguments);

} // namespace tarn
