// What every command that looks at a scene starts with: the scene, its settings and a camera.
#pragma once

#include "app/command_line.h"
#include "base/progress.h"
#include "scene/scene.h"

namespace tarn
{

struct Stage {
    Scene scene;
    Settings settings;
};

/// Loads the scene that the arguments name (the shipped lake when they name none) and resolves the settings.
Stage loadStage(const SceneArguments& arguments, Progress* progress);

/// The scene's first camera when the name is empty. Throws UsageError, with the flag that named it, when the scene has
/// no such camera.
Camera namedCamera(const Scene& scene, const std::string& name, const char* flag);

/// Throws UsageError when the scene has no camera of the name, or when what replaces its parts leaves no
/// view.
Camera chooseCamera(const Scene& scene, const CameraArguments& arguments);

} // namespace tarn
