#include "app/viewer/loading.h"

#include <chrono>

namespace tarn {

BackgroundLoad::BackgroundLoad(const SceneArguments& arguments)
    : sceneSetup_(std::async(std::launch::async, [this, arguments] { return loadSceneSetup(arguments, &progress_); }))
{}

bool BackgroundLoad::done() const { return sceneSetup_.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }

} // namespace tarn
